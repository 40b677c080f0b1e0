# SPDX-License-Identifier: MIT
# Tests of the program. The scripts find it in $TABOR and their helpers in $INSPECT, $SYNTHESISE, $TYPIST
# and $STALLS.

if(TARGET tabor-program)
  add_executable(host_inspect support/host_inspect.c)
  tabor_target_defaults(host_inspect)
  target_link_libraries(host_inspect PRIVATE PkgConfig::JANSSON PkgConfig::SNDFILE m)

  add_executable(host_synthesise support/host_synthesise.c)
  tabor_target_defaults(host_synthesise)
  target_link_libraries(host_synthesise PRIVATE PkgConfig::SNDFILE m)

  # Somebody at a terminal.
  add_executable(host_typist support/host_typist.c)
  tabor_target_defaults(host_typist)
  target_link_libraries(host_typist PRIVATE util)

  # Whether the machine keeps time.
  add_executable(host_stalls support/host_stalls.c)
  tabor_target_defaults(host_stalls)

  # tabor_add_host_test(NAME [SCRIPT OTHER-NAME] [ARGUMENT...])
  function(tabor_add_host_test name)
    tabor_add_script_test(${name} ${ARGN})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                              "INSPECT=$<TARGET_FILE:host_inspect>"
                                              "SYNTHESISE=$<TARGET_FILE:host_synthesise>"
                                              "TYPIST=$<TARGET_FILE:host_typist>"
                                              "STALLS=$<TARGET_FILE:host_stalls>")
  endfunction()

  set(test_system_kit_render_ARGUMENTS "${PROJECT_SOURCE_DIR}/examples/kit-groove.mid")
  if(TABOR_SANITIZE)
    list(APPEND test_system_kit_render_ARGUMENTS brief)
  endif()
  foreach(name IN ITEMS test_library_sampler test_system_analyze test_system_bench test_system_completion
                        test_system_events_file
                        test_system_files test_system_fit test_system_humanize test_system_jobs test_system_keys test_system_options test_system_kit_play test_system_kit_render test_system_library
                        test_system_library_kit
                        test_system_killed_take test_system_midi_file
                        test_system_play test_system_play_random
                        test_system_preset_files test_system_program test_system_replay test_system_requests
                        test_system_sound_input
                        test_system_split test_system_stereo test_system_terminal test_system_variations)
    tabor_add_host_test(${name} ${${name}_ARGUMENTS})
  endforeach()
  tabor_add_host_test(test_system_completion_shells "${PROJECT_SOURCE_DIR}")
  if(TARGET man-page AND NOT TABOR_SANITIZE) # of texts
    tabor_add_host_test(test_system_man_page "${PROJECT_BINARY_DIR}/host/tabor.1")
  endif()

  pkg_check_modules(JACK IMPORTED_TARGET jack)
  if(JACK_FOUND)
    add_executable(jack_send support/jack_send.c)
    tabor_target_defaults(jack_send)
    target_compile_definitions(jack_send PRIVATE _XOPEN_SOURCE=700)
    target_link_libraries(jack_send PRIVATE PkgConfig::JACK)
  endif()

  # Sanitizers and counters would be in what these look at or compare times with, and make JACK drop slow clients.
  if(NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
    tabor_add_host_test(test_system_keys_jack SCRIPT test_system_keys jack)
    tabor_add_host_test(test_system_midi_live)
    tabor_add_host_test(test_system_play_jack)
    if(JACK_FOUND)
      set_property(TEST test_system_midi_live APPEND PROPERTY ENVIRONMENT "JACK_SEND=$<TARGET_FILE:jack_send>")
    endif()
    add_library(failing_memory MODULE support/failing_memory.c)
    tabor_target_defaults(failing_memory)
    tabor_add_host_test(test_system_memory "$<TARGET_FILE:failing_memory>" 10)
    tabor_add_host_test(test_compare_recordings "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_compare_cymbals "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_compare_tools "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_contrast "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_docs_all "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_figures "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_pictures "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_python_tools "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_rudiments "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_site "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_sounds "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_tutorial "${PROJECT_SOURCE_DIR}")
    tabor_add_host_test(test_sweep) # of a script: sanitizers have nothing to see in it
  endif()
  if(NOT BUILD_SHARED_LIBS AND NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
    # What the program's audio thread may call, and what compilers that know such threads say.
    tabor_add_script_test(test_player_symbols SCRIPT test_realtime_symbols "$<TARGET_FILE:tabor>"
                          "${PROJECT_SOURCE_DIR}/engine/include/tabor/tabor.h" "$<TARGET_FILE:tabor-host>"
                          "$<TARGET_FILE:tabor-host-core>")
    tabor_add_script_test(test_player_effects "${PROJECT_SOURCE_DIR}"
                          "$<$<BOOL:${TABOR_BUILD_CLAP}>:${TABOR_CLAP_INCLUDE_DIR}>")
  endif()
endif()
