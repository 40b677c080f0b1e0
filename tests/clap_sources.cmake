# SPDX-License-Identifier: MIT
# What the tests of the CLAP plugins, test_clap_*.c, are made of.

if(NOT TABOR_BUILD_CLAP)
  tabor_leave_out_plugin_tests(clap "${TABOR_CLAP_MISSING}" "there are no CLAP headers: tools/setup --plugins brings them")
  return()
endif()
if(NOT TABOR_BUILD_PROGRAM)
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_clap_(effect|kit|render)")
endif()

set(TABOR_CLAP_LIBRARIES tabor-clap-archive tabor-host-core ${CMAKE_DL_LIBS})

foreach(name IN ITEMS test_clap_effect test_clap_kit test_clap_render)
  set(${name}_SOURCES support/clap_host.c support/clap_songs.c support/plugin_songs.c support/midi_writer.c support/said.c)
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES} tabor-host)
  set(${name}_NEEDS tabor-program tabor-clap)
  if(TABOR_BUILD_PROGRAM)
    set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-program>" "$<TARGET_FILE:tabor-clap>")
  endif()
endforeach()

foreach(name IN ITEMS test_clap_builds test_clap_parameters test_clap_presets test_clap_state)
  set(${name}_SOURCES support/clap_host.c)
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES})
  set(${name}_NEEDS tabor-clap)
  set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-clap>")
endforeach()

list(APPEND test_clap_effect_SOURCES support/sound_burst.c)

# Tests that look inside have the plugins in themselves.
foreach(name IN ITEMS test_clap_realtime test_clap_threads test_clap_window test_clap_kit_window)
  set(${name}_SOURCES support/clap_host.c)
  set(${name}_LIBRARIES ${TABOR_CLAP_LIBRARIES})
endforeach()
list(APPEND test_clap_realtime_SOURCES support/counted_calls.c support/midi_writer.c)
set(test_clap_realtime_LINK_OPTIONS ${TABOR_COUNTED_CALLS})
if(TABOR_WINDOW_FOUND)
  foreach(name IN ITEMS test_clap_window test_clap_kit_window)
    list(APPEND ${name}_SOURCES support/clap_window.c support/counted_calls.c support/window_checks.c support/x11_server.c)
    set(${name}_LINK_OPTIONS ${TABOR_COUNTED_CALLS})
  endforeach()
  list(APPEND test_clap_kit_window_SOURCES support/kit_window_checks.c)
else()
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_clap_(kit_)?window")
  foreach(name IN ITEMS test_clap_window test_clap_kit_window)
    tabor_add_skipped_test(${name} "no cairo-xcb or xcb: needs libcairo2-dev libxcb1-dev")
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
