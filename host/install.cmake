# SPDX-License-Identifier: MIT
# Installs the program (component `program`), its man page, completion in bash, zsh and fish, the presets and the kits.

install(TARGETS tabor-program RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
if(TABOR_MAN_PAGE)
  install(FILES "${TABOR_MAN_PAGE}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
endif()
install(
  FILES completion.bash
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions"
  RENAME tabor
  COMPONENT program)
install(
  FILES completion.zsh
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions"
  RENAME _tabor
  COMPONENT program)
install(
  FILES completion.fish
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d"
  RENAME tabor.fish
  COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/presets" "${PROJECT_SOURCE_DIR}/kits" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/tabor"
        COMPONENT program FILES_MATCHING PATTERN "*.ini")
