# SPDX-License-Identifier: MIT
# Installs the program (component `program`), its man page, completion in bash, zsh and fish, its place on a desktop, the
# presets and the kits.

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

# A menu's entry, a software centre's page, and the icon of both.
if(UNIX AND NOT APPLE)
  include("${PROJECT_SOURCE_DIR}/cmake/TaborIdentity.cmake")
  set(TABOR_RELEASE_TYPE stable)
  if(TABOR_VERSION MATCHES "-")
    set(TABOR_RELEASE_TYPE development)
  endif()
  string(REPLACE "-" "~" TABOR_RELEASE_VERSION "${TABOR_VERSION}")
  string(TIMESTAMP TABOR_RELEASE_DATE "%Y-%m-%d" UTC) # of SOURCE_DATE_EPOCH, if it is set
  if(TABOR_IDENTITY_REPOSITORY)
    set(TABOR_METAINFO_URLS "\n  <url type=\"homepage\">${TABOR_IDENTITY_REPOSITORY}</url>")
  endif()
  configure_file(tabor.desktop.in "${TABOR_IDENTITY_ID}.desktop" @ONLY)
  configure_file(tabor.metainfo.xml.in "${TABOR_IDENTITY_ID}.metainfo.xml" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${TABOR_IDENTITY_ID}.desktop"
          DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/applications" COMPONENT program)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${TABOR_IDENTITY_ID}.metainfo.xml"
          DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/metainfo" COMPONENT program)
  install(
    FILES "${PROJECT_SOURCE_DIR}/web/page/icon.svg"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/icons/hicolor/scalable/apps"
    RENAME tabor.svg
    COMPONENT program)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/presets" "${PROJECT_SOURCE_DIR}/kits" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/tabor"
        COMPONENT program FILES_MATCHING PATTERN "*.ini")
