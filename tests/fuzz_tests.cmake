# SPDX-License-Identifier: MIT
# Fuzz targets, fuzz/fuzz_NAME.c. With TABOR_FUZZ they are programs of libFuzzer, for tools/fuzz. Otherwise each is a
# test: it tries its corpus and some mutations of it (fuzz/replay.c), the same in every run.

set(TABOR_FUZZ_SEED 1 CACHE STRING "Seed of the mutations that the fuzz targets try as tests")
add_custom_target(fuzz-targets)

# tabor_add_fuzz_target(NAME RUNS LIBRARY [CORPUS GLOB...]): fuzz/corpus/NAME is its corpus, too. It links the engine with
# sanitizers. test_fuzz_reach.sh says what of the sources its corpus must reach.
function(tabor_add_fuzz_target name runs library)
  cmake_parse_arguments(of "" "" "CORPUS" ${ARGN})
  if(NOT TARGET ${library})
    return()
  endif()
  set(target fuzz_${name})
  add_executable(${target} fuzz/${target}.c fuzz/fuzz.c)
  tabor_target_defaults(${target})
  set_target_properties(${target} PROPERTIES TABOR_SANITIZED_ENGINE ON)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/fuzz")
  target_link_libraries(${target} PRIVATE ${library} m)
  add_dependencies(fuzz-targets ${target})
  file(GLOB corpus CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/${name}/*" ${of_CORPUS})
  if(TABOR_FUZZ)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
    list(JOIN corpus "," seeds) # as -seed_inputs=@FILE takes them
    file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${target}.seeds" "${seeds}")
    return()
  endif()
  target_sources(${target} PRIVATE fuzz/replay.c)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/fuzz/${name}") # where the last input stays if it breaks something
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME ${target} COMMAND ${target} ${runs} ${TABOR_FUZZ_SEED} ${corpus} WORKING_DIRECTORY "${folder}")
  tabor_test_properties(${target})
endfunction()

tabor_add_fuzz_target(api 1000 Tabor::tabor)
tabor_add_fuzz_target(state 2000 Tabor::tabor)
tabor_add_fuzz_target(room_state 1000 Tabor::tabor)
tabor_add_fuzz_target(definition 500 tabor-plugin-archive)
tabor_add_fuzz_target(preset 500 tabor-host CORPUS "${PROJECT_SOURCE_DIR}/presets/*.ini")
tabor_add_fuzz_target(kit 500 tabor-host CORPUS "${PROJECT_SOURCE_DIR}/kits/*.ini")
tabor_add_fuzz_target(events_file 3000 tabor-host)
tabor_add_fuzz_target(log 3000 tabor-host)
tabor_add_fuzz_target(replay 1000 tabor-host CORPUS "${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus/log/*")
tabor_add_fuzz_target(midi_file 3000 tabor-host CORPUS "${PROJECT_SOURCE_DIR}/examples/*.mid")
tabor_add_fuzz_target(midi_map 1000 tabor-host)
tabor_add_fuzz_target(keymap 2000 tabor-host)
tabor_add_fuzz_target(sound_file 300 tabor-host)
tabor_add_fuzz_target(manifest 1000 tabor-host)

# The CLAP plugins, with the host of their tests.
tabor_add_fuzz_target(clap 500 tabor-clap-archive)
if(TARGET fuzz_clap)
  target_sources(fuzz_clap PRIVATE support/clap_host.c support/host_threads.c)
  target_include_directories(fuzz_clap PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/support" ${CMOCKA_INCLUDE_DIRS})
  target_link_libraries(fuzz_clap PRIVATE tabor-host-core Tabor::tabor ${CMOCKA_LINK_LIBRARIES} Threads::Threads
                                          ${CMAKE_DL_LIBS})
elseif(TABOR_CLAP_MISSING AND NOT TABOR_FUZZ)
  tabor_add_skipped_test(fuzz_clap "there are no CLAP headers: tools/setup --plugins brings them")
endif()

# What of the sources the corpora reach, in a build of its own with clang.
if(TARGET tabor-host AND NOT TABOR_FUZZ AND NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
  tabor_add_script_test(test_fuzz_reach "${PROJECT_SOURCE_DIR}" "${CMAKE_COMMAND}"
                        "${CMAKE_CURRENT_BINARY_DIR}/fuzz_reach" "$<$<BOOL:${TABOR_BUILD_CLAP}>:${TABOR_CLAP_INCLUDE_DIR}>")
  set_tests_properties(test_fuzz_reach PROPERTIES COST 100)
endif()
