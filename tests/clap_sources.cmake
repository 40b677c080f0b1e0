# SPDX-License-Identifier: MIT
# What the tests of the CLAP plugins, test_clap_*.c, are made of.

if(NOT TABOR_BUILD_CLAP OR NOT TABOR_BUILD_PROGRAM)
  set(TABOR_CLAP_TESTS ${TABOR_TEST_SOURCES})
  list(FILTER TABOR_CLAP_TESTS INCLUDE REGEX "/test_clap_")
  list(FILTER TABOR_TEST_SOURCES EXCLUDE REGEX "/test_clap_")
  if(TABOR_CLAP_MISSING)
    foreach(source IN LISTS TABOR_CLAP_TESTS)
      get_filename_component(name "${source}" NAME_WE)
      tabor_add_skipped_test(${name} "there are no CLAP headers: tools/setup --plugins brings them")
    endforeach()
  endif()
  return()
endif()

set(TABOR_CLAP_HOST support/clap_host.c support/plugin_songs.c support/midi_writer.c support/said.c)
set(TABOR_CLAP_LIBRARIES tabor-clap-archive tabor-host tabor-host-core ${CMAKE_DL_LIBS})

set(test_clap_render_SOURCES ${TABOR_CLAP_HOST})
set(test_clap_render_LIBRARIES ${TABOR_CLAP_LIBRARIES})
set(test_clap_render_NEEDS tabor-program tabor-clap)
set(test_clap_render_ARGUMENTS "$<TARGET_FILE:tabor-program>" "$<TARGET_FILE:tabor-clap>")

set(test_clap_state_SOURCES ${TABOR_CLAP_HOST})
set(test_clap_state_LIBRARIES ${TABOR_CLAP_LIBRARIES})
set(test_clap_state_NEEDS tabor-clap)
set(test_clap_state_ARGUMENTS "$<TARGET_FILE:tabor-clap>")

# It looks inside, and has the plugin in itself.
set(test_clap_realtime_SOURCES ${TABOR_CLAP_HOST} support/counted_calls.c)
set(test_clap_realtime_LIBRARIES ${TABOR_CLAP_LIBRARIES})
set(test_clap_realtime_LINK_OPTIONS ${TABOR_COUNTED_CALLS})

# Under sanitizers, and counting coverage, everything takes ten times as long.
if(TABOR_SANITIZE OR TABOR_COVERAGE)
  list(APPEND test_clap_render_ARGUMENTS brief)
  set(test_clap_realtime_ARGUMENTS 3)
endif()
