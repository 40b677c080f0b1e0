# SPDX-License-Identifier: MIT
# Toolchain file: builds Tabor for 64-bit Windows with mingw-w64, with the libraries that tools/windows-libraries
# has built. Programs and plugins need no DLL but those of Windows.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)

set(TABOR_MINGW x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${TABOR_MINGW}-gcc-posix)
set(CMAKE_CXX_COMPILER ${TABOR_MINGW}-g++-posix)
set(CMAKE_RC_COMPILER ${TABOR_MINGW}-windres)

set(TABOR_WINDOWS_LIBRARIES "${CMAKE_CURRENT_LIST_DIR}/../build/windows-libraries")
set(CMAKE_FIND_ROOT_PATH "${TABOR_WINDOWS_LIBRARIES}" /usr/${TABOR_MINGW})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# pkg-config sees these libraries alone, and names what a static library needs.
set(ENV{PKG_CONFIG_LIBDIR} "${TABOR_WINDOWS_LIBRARIES}/lib/pkgconfig")
set(PKG_CONFIG_ARGN --static)
# The linker's time would make every build's bytes others.
foreach(kind IN ITEMS EXE MODULE SHARED)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-static -Wl,--no-insert-timestamp")
endforeach()
