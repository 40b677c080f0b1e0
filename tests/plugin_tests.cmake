# SPDX-License-Identifier: MIT
# Tests of the plugins of all formats.

if(NOT TABOR_BUILD_PROGRAM OR TABOR_SANITIZE OR TABOR_COVERAGE)
  return()
endif()
set(threads "")
foreach(format IN ITEMS lv2 clap)
  if(TARGET test_${format}_threads)
    list(APPEND threads test_${format}_threads)
  endif()
endforeach()
if(threads)
  tabor_add_script_test(test_plugin_races "${PROJECT_SOURCE_DIR}" "${CMAKE_COMMAND}" "${TABOR_CLAP_INCLUDE_DIR}" ${threads})
else()
  tabor_add_skipped_test(test_plugin_races "there are no plugins: needs lv2-dev")
endif()
