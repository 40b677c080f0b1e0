# SPDX-License-Identifier: MIT
# Tests of the VST3 plugins. The scripts find the bundle in $BUNDLE.

if(NOT TABOR_BUILD_PROGRAM OR TABOR_SANITIZE OR TABOR_COVERAGE)
  return()
endif()
if(TABOR_VST3_MISSING)
  foreach(name IN ITEMS test_vst3_bundle test_vst3_dawdreamer test_vst3_pedalboard test_vst3_window)
    tabor_add_skipped_test(${name} "there are no sources of the VST3 plugins: tools/setup --plugins brings them")
  endforeach()
endif()
if(NOT TABOR_BUILD_VST3)
  return()
endif()

add_executable(vst3_host support/vst3_host.cpp)
target_link_libraries(vst3_host PRIVATE vst3-hosting vst3-sdk)
add_dependencies(vst3_host tabor-vst3)

foreach(name IN ITEMS test_vst3_bundle test_vst3_dawdreamer test_vst3_pedalboard)
  if(WIN32)
    break() # scripts; tools/check-windows has such a one
  endif()
  tabor_add_host_test(${name})
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "BUNDLE=${PROJECT_BINARY_DIR}/vst3/Tabor.vst3"
                                            "VST3_HOST=$<TARGET_FILE:vst3_host>"
                                            "SOURCE=${PROJECT_SOURCE_DIR}")
endforeach()

if(NOT TABOR_WINDOW_FOUND)
  tabor_add_skipped_test(test_vst3_window "no cairo-xcb, xcb or xkbcommon-x11: needs libcairo2-dev libxcb1-dev libxkbcommon-x11-dev")
  return()
endif()
if(WIN32)
  set(desktop support/desktop_windows.c)
else()
  set(desktop support/desktop_x11.c)
endif()
add_executable(test_vst3_window host/vst3/test_vst3_window.cpp support/user_files.c support/desktop.c ${desktop})
target_include_directories(test_vst3_window PRIVATE support ${CMOCKA_INCLUDE_DIRS})
target_compile_features(test_vst3_window PRIVATE c_std_11 cxx_std_17)
target_link_libraries(test_vst3_window PRIVATE vst3-hosting vst3-sdk PkgConfig::TABOR_WINDOW ${CMOCKA_LINK_LIBRARIES})
add_dependencies(test_vst3_window tabor-vst3)
add_test(NAME test_vst3_window COMMAND test_vst3_window "${PROJECT_BINARY_DIR}/vst3/Tabor.vst3")
tabor_test_properties(test_vst3_window)
