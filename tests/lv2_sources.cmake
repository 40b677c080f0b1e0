# SPDX-License-Identifier: MIT
# What the tests of the LV2 plugins, test_lv2_*.c, are made of.

if(NOT TABOR_BUILD_LV2)
  tabor_leave_out_plugin_tests(lv2 "${TABOR_LV2_MISSING}" "needs lv2-dev")
  return()
endif()
if(NOT TABOR_BUILD_PROGRAM)
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_lv2_(effect|kit|render)")
endif()

set(TABOR_LV2_LIBRARIES tabor-lv2-archive tabor-host-core ${CMAKE_DL_LIBS})

foreach(name IN ITEMS test_lv2_effect test_lv2_kit test_lv2_render)
  set(${name}_SOURCES support/plugin_host.c support/plugin_songs.c support/midi_writer.c support/said.c)
  set(${name}_LIBRARIES ${TABOR_LV2_LIBRARIES} tabor-host)
  set(${name}_NEEDS tabor-program tabor-lv2)
  if(TABOR_BUILD_PROGRAM)
    set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-program>" "$<TARGET_FILE:tabor-lv2>")
  endif()
endforeach()

foreach(name IN ITEMS test_lv2_robust test_lv2_state)
  set(${name}_SOURCES support/plugin_host.c)
  set(${name}_LIBRARIES ${TABOR_LV2_LIBRARIES})
  set(${name}_NEEDS tabor-lv2)
  set(${name}_ARGUMENTS "$<TARGET_FILE:tabor-lv2>")
endforeach()

list(APPEND test_lv2_effect_SOURCES support/sound_burst.c)
list(APPEND test_lv2_state_SOURCES support/user_files.c)

set(test_lv2_description_SOURCES support/plugin_host.c)
set(test_lv2_description_LIBRARIES ${TABOR_LV2_LIBRARIES})
set(test_lv2_description_NEEDS tabor-lv2 lv2-description)
set(test_lv2_description_ARGUMENTS "$<TARGET_FILE_DIR:tabor-lv2>")
pkg_check_modules(LILV IMPORTED_TARGET lilv-0)
if(LILV_FOUND)
  list(APPEND test_lv2_description_LIBRARIES PkgConfig::LILV)
  set(test_lv2_description_DEFINITIONS TABOR_HAVE_LILV)
endif()

# Tests that look inside have the plugins in themselves.
foreach(name IN ITEMS test_lv2_models test_lv2_realtime test_lv2_set_path test_lv2_threads)
  set(${name}_SOURCES support/plugin_host.c)
  set(${name}_LIBRARIES ${TABOR_LV2_LIBRARIES})
endforeach()
list(APPEND test_lv2_realtime_SOURCES support/counted_calls.c)
list(APPEND test_lv2_set_path_SOURCES support/midi_writer.c)
set(test_lv2_realtime_LINK_OPTIONS ${TABOR_COUNTED_CALLS})

if(TABOR_WINDOW_FOUND)
  foreach(name IN ITEMS test_lv2_window test_lv2_kit_window)
    set(${name}_SOURCES support/lv2_window.c support/plugin_host.c support/counted_calls.c support/window_checks.c
                        support/x11_server.c)
    set(${name}_LIBRARIES tabor-lv2-ui-archive ${TABOR_LV2_LIBRARIES})
    set(${name}_LINK_OPTIONS ${TABOR_COUNTED_CALLS})
  endforeach()
  list(APPEND test_lv2_kit_window_SOURCES support/kit_window_checks.c)
else()
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_lv2_(kit_)?window")
  foreach(name IN ITEMS test_lv2_window test_lv2_kit_window)
    tabor_add_skipped_test(${name} "no cairo-xcb, xcb or xkbcommon-x11: needs libcairo2-dev libxcb1-dev libxkbcommon-x11-dev")
  endforeach()
endif()

# Under sanitizers, and counting coverage, everything takes ten times as long.
if(TABOR_SANITIZE OR TABOR_COVERAGE)
  list(APPEND test_lv2_kit_ARGUMENTS brief)
  list(APPEND test_lv2_render_ARGUMENTS brief)
  set(test_lv2_realtime_ARGUMENTS 3)
endif()
