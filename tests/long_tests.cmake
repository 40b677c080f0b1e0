# SPDX-License-Identifier: MIT
# What takes more than minutes: ./tools/check --long.
if(TARGET tabor-program)
  tabor_add_host_test(test_system_play_long SCRIPT test_system_play_random 600 snare-14x5.5-off)
  set_tests_properties(test_system_play_long PROPERTIES TIMEOUT 1200 LABELS long)
endif()
if(TEST test_replay)
  add_test(NAME test_replay_long COMMAND test_replay 600)
  tabor_test_properties(test_replay_long)
  set_tests_properties(test_replay_long PROPERTIES TIMEOUT 7200 LABELS long)
endif()
add_test(NAME test_system_energy_long COMMAND test_system_energy long)
tabor_test_properties(test_system_energy_long)
set_tests_properties(test_system_energy_long PROPERTIES LABELS long)
add_test(NAME test_system_trials_long COMMAND test_system_trials 10000 9000)
tabor_test_properties(test_system_trials_long)
add_test(NAME test_system_trials_exact COMMAND test_system_trials 100 900 exact)
tabor_test_properties(test_system_trials_exact)
set_tests_properties(test_system_trials_exact PROPERTIES TIMEOUT 3600 LABELS long)
set_tests_properties(test_system_trials_long PROPERTIES TIMEOUT 7200 LABELS long)

if(TEST test_leaks)
  tabor_add_script_test(test_leaks_long SCRIPT test_leaks "$<TARGET_FILE:test_system_instances>" 1000)
  set_tests_properties(test_leaks_long PROPERTIES TIMEOUT 1800 LABELS long)
endif()
if(COMMAND tabor_add_embed_test)
  tabor_add_embed_test(test_packages_in_root NEEDS_SHARED)
  tabor_add_embed_test(test_python_wheel)
  set_tests_properties(test_packages_in_root test_python_wheel PROPERTIES TIMEOUT 1800 LABELS long)
  tabor_add_embed_test(test_first_page_in_root)
  set_tests_properties(test_first_page_in_root PROPERTIES TIMEOUT 7200 LABELS long)
endif()

if(TEST test_lv2_render AND NOT TABOR_SANITIZE)
  add_test(NAME test_lv2_render_long COMMAND test_lv2_render "$<TARGET_FILE:tabor-program>"
                                             "$<TARGET_FILE:tabor-lv2>" songs 200)
  tabor_test_properties(test_lv2_render_long)
  set_tests_properties(test_lv2_render_long PROPERTIES TIMEOUT 3600 LABELS long)
endif()
if(TABOR_BUILD_LV2 AND TEST test_lv2_jalv)
  tabor_add_script_test(test_lv2_ardour)
  set_tests_properties(test_lv2_ardour PROPERTIES TIMEOUT 2400 LABELS long)
  set_property(TEST test_lv2_ardour APPEND PROPERTY ENVIRONMENT "BUNDLE=$<TARGET_FILE_DIR:tabor-lv2>"
                                                    "SOURCE=${PROJECT_SOURCE_DIR}"
                                                    "TABOR=$<TARGET_FILE:tabor-program>"
                                                    "INSPECT=$<TARGET_FILE:host_inspect>")
endif()

# The engine for another processor, under an emulator.
if(NOT TABOR_SANITIZE AND NOT TABOR_COVERAGE)
  add_test(NAME test_arm COMMAND "${PROJECT_SOURCE_DIR}/tools/check-arm")
  tabor_test_properties(test_arm)
  set_tests_properties(test_arm PROPERTIES TIMEOUT 3600 LABELS long)
endif()
