# SPDX-License-Identifier: MIT
# Tests of the program. The scripts find it in $TABOR and their helper in $INSPECT.

if(TARGET tabor-program)
  pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
  add_executable(host_inspect host_inspect.c)
  tabor_target_defaults(host_inspect)
  target_link_libraries(host_inspect PRIVATE PkgConfig::JANSSON PkgConfig::SNDFILE m)

  foreach(name IN ITEMS test_system_files test_system_preset_files test_system_program
                        test_system_requests)
    add_test(NAME ${name} COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/${name}.sh")
    tabor_test_properties(${name})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "TABOR=$<TARGET_FILE:tabor-program>"
                                              "INSPECT=$<TARGET_FILE:host_inspect>")
  endforeach()
endif()
