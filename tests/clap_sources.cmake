# SPDX-License-Identifier: MIT
# What the tests of the CLAP plugins, test_clap_*.c, are made of.

if(NOT TABOR_BUILD_CLAP)
  tabor_leave_out_plugin_tests(clap "${TABOR_CLAP_MISSING}" "there are no CLAP headers: tools/setup --plugins brings them")
  return()
endif()
if(NOT TABOR_BUILD_PROGRAM)
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_clap_(effect|kit|render)")
endif()

set(TABOR_CLAP_HOST support/clap_host.c support/host_threads.c)
set(TABOR_CLAP_LIBRARIES tabor-clap-archive tabor-host-core ${CMAKE_DL_LIBS})

foreach(name IN ITEMS test_clap_effect test_clap_kit test_clap_render)
  set(${name}_SOURCES ${TABOR_CLAP_HOST} support/clap_songs.c support/plugin_songs.c support/midi_writer.c support/said.c)
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES} tabor-host)
  set(${name}_NEEDS tabor-program tabor-clap)
  if(TABOR_BUILD_PROGRAM)
    set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-program>" "$<TARGET_FILE:tabor-clap>")
  endif()
endforeach()

foreach(name IN ITEMS test_clap_builds test_clap_parameters test_clap_presets test_clap_state)
  set(${name}_SOURCES ${TABOR_CLAP_HOST})
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES})
  set(${name}_NEEDS tabor-clap)
  set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-clap>")
endforeach()

list(APPEND test_clap_effect_SOURCES support/sound_burst.c)
list(APPEND test_clap_presets_SOURCES support/user_files.c)

# Tests that look inside have the plugins in themselves.
foreach(name IN ITEMS test_clap_realtime test_clap_threads test_clap_window test_clap_window_keys test_clap_kit_window)
  set(${name}_SOURCES ${TABOR_CLAP_HOST})
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES})
endforeach()
list(APPEND test_clap_realtime_SOURCES support/counted_calls.c support/midi_writer.c)
set(test_clap_realtime_LINK_OPTIONS ${TABOR_COUNTED_CALLS})
if(TABOR_WINDOW_FOUND)
  foreach(name IN ITEMS test_clap_window test_clap_window_keys test_clap_kit_window)
    list(APPEND ${name}_SOURCES support/clap_window.c support/counted_calls.c support/window_checks.c support/x11_server.c)
    set(${name}_LINK_OPTIONS ${TABOR_COUNTED_CALLS})
  endforeach()
  list(APPEND test_clap_kit_window_SOURCES support/kit_window_checks.c support/user_files.c)
  list(APPEND test_clap_window_SOURCES support/user_files.c)
  list(APPEND test_clap_window_keys_SOURCES support/user_files.c)
else()
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_clap_(kit_)?window")
  foreach(name IN ITEMS test_clap_window test_clap_window_keys test_clap_kit_window)
    tabor_add_skipped_test(${name} "no cairo-xcb, xcb or xkbcommon-x11: needs libcairo2-dev libxcb1-dev libxkbcommon-x11-dev")
  endforeach()
endif()

# Under sanitizers, and counting coverage, everything takes ten times as long.
if(TABOR_SANITIZE OR TABOR_COVERAGE)
  list(APPEND test_clap_builds_ARGUMENTS brief)
  list(APPEND test_clap_kit_ARGUMENTS brief)
  list(APPEND test_clap_render_ARGUMENTS brief)
  set(test_clap_realtime_ARGUMENTS 1 1)
  set(test_clap_threads_ARGUMENTS 60)
endif()

# What a kit costs each core in these hosts.
if(TABOR_BUILD_PROGRAM AND TABOR_BUILD_LV2 AND NOT WIN32)
  add_executable(kit_cores EXCLUDE_FROM_ALL support/kit_cores.c ${TABOR_CLAP_HOST} support/plugin_host.c)
  tabor_target_defaults(kit_cores)
  target_compile_options(kit_cores PRIVATE -Wno-missing-prototypes -Wno-conversion)
  target_include_directories(kit_cores PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/support" ${CMOCKA_INCLUDE_DIRS})
  target_link_libraries(kit_cores PRIVATE tabor-lv2-archive ${TABOR_CLAP_LIBRARIES} tabor-host Tabor::tabor
                                          ${CMOCKA_LINK_LIBRARIES} Threads::Threads m)
endif()
