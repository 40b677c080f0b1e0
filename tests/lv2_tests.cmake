# SPDX-License-Identifier: MIT
# Tests of the LV2 plugins in hosts and under tools of others. The scripts find the bundle in $BUNDLE.

if(NOT TABOR_BUILD_PROGRAM OR TABOR_SANITIZE OR TABOR_COVERAGE)
  return()
endif()
if(TABOR_LV2_MISSING)
  foreach(name IN ITEMS test_lv2_dawdreamer test_lv2_validate test_lv2_jalv test_lv2_jalv_window)
    tabor_add_skipped_test(${name} "needs lv2-dev")
  endforeach()
endif()
if(NOT TABOR_BUILD_LV2)
  return()
endif()

tabor_add_script_test(test_lv2_validate)
tabor_add_script_test(test_lv2_dawdreamer)
tabor_add_script_test(test_lv2_jalv)
tabor_add_script_test(test_lv2_jalv_window)
foreach(name IN ITEMS test_lv2_dawdreamer test_lv2_validate test_lv2_jalv test_lv2_jalv_window)
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "BUNDLE=$<TARGET_FILE_DIR:tabor-lv2>"
                                            "SOURCE=${PROJECT_SOURCE_DIR}"
                                            "TABOR=$<TARGET_FILE:tabor-program>"
                                            "INSPECT=$<TARGET_FILE:host_inspect>")
endforeach()
if(JACK_FOUND)
  foreach(name IN ITEMS test_lv2_jalv test_lv2_jalv_window)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "JACK_SEND=$<TARGET_FILE:jack_send>"
                                              "STALLS=$<TARGET_FILE:host_stalls>")
  endforeach()
endif()
