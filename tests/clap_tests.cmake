# SPDX-License-Identifier: MIT
# Tests of the CLAP plugins under tools of others. The scripts find the binary in $CLAP.

if(NOT TABOR_BUILD_PROGRAM OR TABOR_SANITIZE OR TABOR_COVERAGE)
  return()
endif()
if(TABOR_CLAP_MISSING)
  tabor_add_skipped_test(test_clap_validate "there are no CLAP headers: tools/setup --plugins brings them")
endif()
if(NOT TABOR_BUILD_CLAP)
  return()
endif()

# tabor_add_clap_test(NAME [SCRIPT OTHER-NAME] [ARGUMENT...])
function(tabor_add_clap_test name)
  tabor_add_host_test(${name} ${ARGN})
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "CLAP=$<TARGET_FILE:tabor-clap>"
                                            "SOURCE=${PROJECT_SOURCE_DIR}")
endfunction()
tabor_add_clap_test(test_clap_validate)
