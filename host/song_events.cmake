# SPDX-License-Identifier: MIT
# The sources of kit/song_events.h: MIDI files for the Python package and the web page. They take nothing but the C library and the engine.

set(TABOR_SONG_EVENTS
    kit/kit_midi.c
    kit/kit_song.c
    kit/song_events.c
    midi/kit_map.c
    midi/midi_file.c
    midi/midi_map.c
    midi/midi_order.c
    midi/midi_song.c
    midi/midi_speed.c
    midi/midi_to_events.c
    strokes/humanize.c)
list(TRANSFORM TABOR_SONG_EVENTS PREPEND "${CMAKE_CURRENT_LIST_DIR}/")

# tabor-midi: a library of them beside a shared libtabor, for the Python package.
function(tabor_add_midi_library)
  add_library(tabor-midi MODULE ${TABOR_SONG_EVENTS})
  tabor_target_defaults(tabor-midi)
  set_target_properties(tabor-midi PROPERTIES C_VISIBILITY_PRESET hidden PREFIX lib BUILD_WITH_INSTALL_RPATH ON
                                              INSTALL_RPATH "$ORIGIN")
  target_include_directories(tabor-midi PRIVATE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  target_compile_options(tabor-midi PRIVATE -ffp-contract=off) # the same bits as the program
  target_link_libraries(tabor-midi PRIVATE Tabor::tabor)
  if(UNIX)
    target_link_libraries(tabor-midi PRIVATE m)
  endif()
endfunction()
