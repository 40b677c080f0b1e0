# SPDX-License-Identifier: MIT
# The built-in presets: files of presets/ compiled into the library, in the order in which they are
# listed. Sets TABOR_PRESET_SOURCE, the generated table, and adds it to tabor.

set(TABOR_PRESETS
    tabor
    frame-drum
    bodhran-piano-string
    bodhran-d-string
    bodhran-d-string-tensioned
    snare-14x5.5
    snare-14x5.5-off
    snare-14x6.5-loose
    piccolo-13x3.5
    marching-14x12
    tom-12
    floor-tom-16
    bass-drum-22
    timpani-26)

list(TRANSFORM TABOR_PRESETS PREPEND "${PROJECT_SOURCE_DIR}/presets/" OUTPUT_VARIABLE TABOR_PRESET_FILES)
list(TRANSFORM TABOR_PRESET_FILES APPEND ".ini")
set(TABOR_PRESET_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/preset_table.c")

find_package(PkgConfig REQUIRED)
pkg_check_modules(INIH REQUIRED IMPORTED_TARGET inih)

add_executable(embed-presets "${PROJECT_SOURCE_DIR}/host/drums/embed_presets.c"
                             "${PROJECT_SOURCE_DIR}/host/drums/preset_file.c")
tabor_target_defaults(embed-presets)
target_include_directories(embed-presets PRIVATE "${PROJECT_SOURCE_DIR}/host")
target_link_libraries(embed-presets PRIVATE PkgConfig::INIH)

add_custom_command(
  OUTPUT "${TABOR_PRESET_SOURCE}"
  COMMAND embed-presets "${TABOR_PRESET_SOURCE}" ${TABOR_PRESET_FILES}
  DEPENDS embed-presets ${TABOR_PRESET_FILES}
  COMMENT "Embedding the presets"
  VERBATIM)

target_sources(tabor PRIVATE "${TABOR_PRESET_SOURCE}")
