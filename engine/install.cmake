# SPDX-License-Identifier: MIT
# Installs the library: what programs need to run (component `library`) and what building against it
# takes (component `development`): the header, a CMake package, a pkg-config file.

include(CMakePackageConfigHelpers)
set(TABOR_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/tabor")

install(
  TARGETS tabor
  EXPORT TaborTargets
  RUNTIME COMPONENT library
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(DIRECTORY include/tabor DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)

# tabor-config.cmake is found by find_package(tabor) and by find_package(Tabor).
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/tabor-config.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/tabor-config.cmake"
  INSTALL_DESTINATION "${TABOR_PACKAGE_DIR}")
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/tabor-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(
  EXPORT TaborTargets
  NAMESPACE Tabor::
  FILE tabor-targets.cmake
  DESTINATION "${TABOR_PACKAGE_DIR}"
  COMPONENT development)
install(
  FILES "${CMAKE_CURRENT_BINARY_DIR}/tabor-config.cmake"
        "${CMAKE_CURRENT_BINARY_DIR}/tabor-config-version.cmake"
  DESTINATION "${TABOR_PACKAGE_DIR}"
  COMPONENT development)

# The pkg-config file. A shared libtabor has linked libm already; whoever links a static one needs it, with
# --static and without.
if(BUILD_SHARED_LIBS)
  set(TABOR_PC_CFLAGS " -DTABOR_SHARED")
  set(TABOR_PC_LIBS_PRIVATE " -lm")
else()
  set(TABOR_PC_LIBS " -lm")
endif()

# Found from the file's own place, so that an installed tree can be moved.
function(tabor_pc_folder variable folder)
  if(NOT IS_ABSOLUTE "${folder}")
    set(folder "\${prefix}/${folder}")
  endif()
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(TABOR_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH TABOR_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" TABOR_PC_PREFIX "\${pcfiledir}/${TABOR_PC_PREFIX}")
endif()
tabor_pc_folder(TABOR_PC_LIBDIR "${CMAKE_INSTALL_LIBDIR}")
tabor_pc_folder(TABOR_PC_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/tabor.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/tabor.pc" @ONLY)
install(
  FILES "${CMAKE_CURRENT_BINARY_DIR}/tabor.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
  COMPONENT development)
