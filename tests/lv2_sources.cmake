# SPDX-License-Identifier: MIT
# What the tests of the LV2 plugins, test_lv2_*.c, are made of.

if(NOT TABOR_BUILD_LV2 OR NOT TABOR_BUILD_PROGRAM)
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_lv2_")
  return()
endif()

set(TABOR_LV2_FOLDER "${PROJECT_SOURCE_DIR}/host/lv2")
set(TABOR_LV2_HOST plugin_host.c "${TABOR_LV2_FOLDER}/knobs.c")
set(TABOR_LV2_HOST_LIBRARIES PkgConfig::LV2 ${CMAKE_DL_LIBS})
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
include_directories("${TABOR_LV2_FOLDER}")

set(test_lv2_render_SOURCES ${TABOR_LV2_HOST} midi_writer.c said.c "${PROJECT_SOURCE_DIR}/host/input_file.c"
                            "${PROJECT_SOURCE_DIR}/host/midi_file.c")
set(test_lv2_render_LIBRARIES ${TABOR_LV2_HOST_LIBRARIES} PkgConfig::SNDFILE)
set(test_lv2_render_DEFINITIONS _XOPEN_SOURCE=700)
set(test_lv2_render_ARGUMENTS "$<TARGET_FILE:tabor-program>" "$<TARGET_FILE:tabor-lv2>")
if(TABOR_SANITIZE OR TABOR_COVERAGE)
  list(APPEND test_lv2_render_ARGUMENTS brief)
endif()
