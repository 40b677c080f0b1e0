# SPDX-License-Identifier: MIT
# Tests of what other programs get: the installed trees, packages, examples, the manual. Most look at a
# build with the shared library, which test_shared_build makes first. Sanitizers and counters would have
# to be in all of it, so these are for builds without them.

if(NOT TARGET tabor-program OR NOT TABOR_INSTALL OR BUILD_SHARED_LIBS
   OR TABOR_SANITIZE OR TABOR_COVERAGE)
  return()
endif()
include(CheckLanguage)
check_language(CXX)
set(TABOR_CXX "")
if(CMAKE_CXX_COMPILER)
  set(TABOR_CXX "${CMAKE_CXX_COMPILER}")
endif()

# tabor_add_embed_test(NAME [NEEDS_SHARED])
function(tabor_add_embed_test name)
  tabor_add_script_test(${name})
  set_property(
    TEST ${name} APPEND
    PROPERTY ENVIRONMENT
             "SOURCE=${PROJECT_SOURCE_DIR}"
             "CMAKE=${CMAKE_COMMAND}"
             "CC=${CMAKE_C_COMPILER}"
             "CXX=${TABOR_CXX}"
             "STATIC_BUILD=${PROJECT_BINARY_DIR}"
             "SHARED_BUILD=${PROJECT_BINARY_DIR}/shared"
             "TABOR=$<TARGET_FILE:tabor-program>"
             "INSPECT=$<TARGET_FILE:host_inspect>"
             "STALLS=$<TARGET_FILE:host_stalls>")
  if("NEEDS_SHARED" IN_LIST ARGN)
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED shared_build)
  endif()
endfunction()

tabor_add_embed_test(test_shared_build)
set_tests_properties(test_shared_build PROPERTIES FIXTURES_SETUP shared_build COST 200)
tabor_add_embed_test(test_shared_library NEEDS_SHARED)
tabor_add_embed_test(test_install NEEDS_SHARED)
tabor_add_embed_test(test_subproject)
set_tests_properties(test_subproject PROPERTIES COST 100) # it builds the engine twice
# It builds everything but the tests.
tabor_add_embed_test(test_first_page)
set_tests_properties(test_first_page PROPERTIES TIMEOUT 3600 COST 150)
tabor_add_embed_test(test_embedding)
tabor_add_embed_test(test_amalgamation)
set_property(TEST test_amalgamation APPEND PROPERTY ENVIRONMENT "SOUND_HASHES=$<TARGET_FILE:sound_hashes>")
tabor_add_embed_test(test_other_systems)
tabor_add_embed_test(test_manual)
tabor_add_embed_test(test_release)
tabor_add_embed_test(test_windows_sdk)
tabor_add_embed_test(test_packages NEEDS_SHARED)
tabor_add_embed_test(test_abi NEEDS_SHARED)
tabor_add_embed_test(test_jack_example)
tabor_add_embed_test(test_python NEEDS_SHARED)
tabor_add_embed_test(test_python_examples NEEDS_SHARED)
tabor_add_embed_test(test_midi_files NEEDS_SHARED)
# They build the engine for WebAssembly.
tabor_add_embed_test(test_web)
tabor_add_embed_test(test_npm)
# They build in build/web.
set_tests_properties(test_midi_files test_web test_npm PROPERTIES RESOURCE_LOCK web_build)
