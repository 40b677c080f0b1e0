# SPDX-License-Identifier: MIT
# What takes more than minutes: ./tools/check --long.
add_test(NAME test_system_trials_long COMMAND test_system_trials 10000 9000)
tabor_test_properties(test_system_trials_long)
set_tests_properties(test_system_trials_long PROPERTIES TIMEOUT 7200 LABELS long)
