# SPDX-License-Identifier: MIT
# The built-in presets and kits: files of presets/ and kits/ compiled into the library, in the order in which they are
# listed: drums, then tunings of them, then drums fitted to recordings. Sets TABOR_PRESET_SOURCE and TABOR_KIT_SOURCE, the
# generated tables, which the target preset-table writes.

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
    timpani-26
    snare-14x8
    snare-14x5-steel
    tom-10
    bass-drum-18
    crash-16
    ride-20
    crash-18
    ride-22
    splash-10
    china-18
    hihat-14
    snare-funk-tight
    snare-ballad-deep
    snare-seventies-dead
    snare-jazz-open
    snare-rock-fat
    snare-metal-crack
    snare-reggae-high
    snare-soul-dry
    snare-studio-medium
    snare-garage-trash
    snare-orchestral
    snare-disco-thud
    snare-marching-indoor
    tom-10-fusion
    tom-12-jazz-high
    tom-12-rock-low
    floor-tom-16-jazz
    floor-tom-16-dead
    bass-drum-18-bop
    bass-drum-22-rock-punch
    bass-drum-22-vintage
    frame-drum-low
    tom-8
    snare-14x5-maple)

set(TABOR_KITS standard jazz marching frame-drums)

list(TRANSFORM TABOR_PRESETS PREPEND "${PROJECT_SOURCE_DIR}/presets/" OUTPUT_VARIABLE TABOR_PRESET_FILES)
list(TRANSFORM TABOR_PRESET_FILES APPEND ".ini")
list(TRANSFORM TABOR_KITS PREPEND "${PROJECT_SOURCE_DIR}/kits/" OUTPUT_VARIABLE TABOR_KIT_FILES)
list(TRANSFORM TABOR_KIT_FILES APPEND ".ini")
set(TABOR_PRESET_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/preset_table.c")
set(TABOR_KIT_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/kit_table.c")

set(TABOR_EMBED_PRESETS "${CMAKE_CURRENT_SOURCE_DIR}/embed-presets.cmake")
add_custom_command(
  OUTPUT "${TABOR_PRESET_SOURCE}"
  COMMAND "${CMAKE_COMMAND}" -D "OUTPUT=${TABOR_PRESET_SOURCE}" -D "PRESETS=${TABOR_PRESET_FILES}" -P
          "${TABOR_EMBED_PRESETS}"
  DEPENDS "${TABOR_EMBED_PRESETS}" ${TABOR_PRESET_FILES}
  COMMENT "Embedding the presets"
  VERBATIM)
add_custom_command(
  OUTPUT "${TABOR_KIT_SOURCE}"
  COMMAND "${CMAKE_COMMAND}" -D "OUTPUT=${TABOR_KIT_SOURCE}" -D "PRESETS=${TABOR_KIT_FILES}" -D KITS=ON -P
          "${TABOR_EMBED_PRESETS}"
  DEPENDS "${TABOR_EMBED_PRESETS}" ${TABOR_KIT_FILES}
  COMMENT "Embedding the kits"
  VERBATIM)
add_custom_target(preset-table DEPENDS "${TABOR_PRESET_SOURCE}" "${TABOR_KIT_SOURCE}")
