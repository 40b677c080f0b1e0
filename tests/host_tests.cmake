# SPDX-License-Identifier: MIT
# Tests of the program. The scripts find it in $TABOR and their helpers in $INSPECT and $SYNTHESISE.

if(TARGET tabor-program)
  pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
  add_executable(host_inspect host_inspect.c)
  tabor_target_defaults(host_inspect)
  target_link_libraries(host_inspect PRIVATE PkgConfig::JANSSON PkgConfig::SNDFILE m)

  add_executable(host_synthesise host_synthesise.c)
  tabor_target_defaults(host_synthesise)
  target_link_libraries(host_synthesise PRIVATE PkgConfig::SNDFILE m)

  pkg_check_modules(JACK IMPORTED_TARGET jack)
  if(JACK_FOUND)
    add_executable(jack_send jack_send.c)
    tabor_target_defaults(jack_send)
    target_compile_definitions(jack_send PRIVATE _XOPEN_SOURCE=700)
    target_link_libraries(jack_send PRIVATE PkgConfig::JACK)
  endif()

  foreach(name IN ITEMS test_library_sampler test_sweep test_system_analyze test_system_bench test_system_completion
                        test_system_events_file
                        test_system_files test_system_humanize test_system_jobs test_system_library
                        test_system_midi_file
                        test_system_midi_live
                        test_system_play test_system_play_jack test_system_play_random
                        test_system_preset_files test_system_program test_system_requests
                        test_system_split)
    add_test(NAME ${name} COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/${name}.sh")
    tabor_test_properties(${name})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                              "INSPECT=$<TARGET_FILE:host_inspect>"
                                              "SYNTHESISE=$<TARGET_FILE:host_synthesise>")
  endforeach()
  if(JACK_FOUND)
    set_property(TEST test_system_midi_live APPEND PROPERTY ENVIRONMENT "JACK_SEND=$<TARGET_FILE:jack_send>")
  endif()

  # Somebody at a terminal.
  add_executable(host_typist host_typist.c)
  tabor_target_defaults(host_typist)
  target_link_libraries(host_typist PRIVATE util)

  add_test(NAME test_system_keys COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_system_keys.sh")
  add_test(NAME test_system_keys_jack COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_system_keys.sh" jack)
  add_test(NAME test_system_terminal COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_system_terminal.sh")
  foreach(name IN ITEMS test_system_keys test_system_keys_jack test_system_terminal)
    tabor_test_properties(${name})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                              "INSPECT=$<TARGET_FILE:host_inspect>"
                                              "TYPIST=$<TARGET_FILE:host_typist>")
  endforeach()

  if(TARGET man-page)
    add_test(NAME test_system_man_page COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_system_man_page.sh"
                                               "${PROJECT_BINARY_DIR}/host/tabor.1")
    tabor_test_properties(test_system_man_page)
    set_property(TEST test_system_man_page APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                                           "INSPECT=$<TARGET_FILE:host_inspect>")
  endif()

  # What the program's audio thread may call, and what compilers that know such threads say.
  if(NOT BUILD_SHARED_LIBS AND NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
    add_test(NAME test_player_symbols
             COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_realtime_symbols.sh" "$<TARGET_FILE:tabor>"
                     "${PROJECT_SOURCE_DIR}/engine/include/tabor/tabor.h" "$<TARGET_OBJECTS:tabor-program>"
             COMMAND_EXPAND_LISTS)
    tabor_test_properties(test_player_symbols)
    add_test(NAME test_player_effects
             COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_player_effects.sh" "${PROJECT_SOURCE_DIR}"
                     "${CMAKE_COMMAND}")
    tabor_test_properties(test_player_effects)
  endif()

  if(NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
    add_test(NAME test_compare_tools
             COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_compare_tools.sh" "${PROJECT_SOURCE_DIR}")
    tabor_test_properties(test_compare_tools)
    set_property(TEST test_compare_tools APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                                         "INSPECT=$<TARGET_FILE:host_inspect>")
  endif()

  # It builds a profiling library of its own, beside one without sanitizers and counters.
  if(NOT BUILD_SHARED_LIBS AND NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
    add_test(NAME test_bench_tool
             COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/test_bench_tool.sh" "${PROJECT_SOURCE_DIR}"
                     "${CMAKE_COMMAND}" "${CMAKE_C_COMPILER}" "$<TARGET_FILE:tabor>")
    tabor_test_properties(test_bench_tool)
    set_property(TEST test_bench_tool APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                                      "INSPECT=$<TARGET_FILE:host_inspect>")
  endif()
endif()
