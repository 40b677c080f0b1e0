# SPDX-License-Identifier: MIT
# Finds LAPACKE, the C interface of LAPACK, and defines
#
#   LAPACKE::LAPACKE   what to link
#   LAPACKE_LIBRARIES  the same as file names, for the pkg-config file
#
# With TABOR_STATIC_LAPACK it takes the static reference libraries where a shared library can be
# linked from them (asked only where C is a language of the project): the system's shared LAPACK may be one that starts threads of its own, which a
# real-time host must not get by surprise. Otherwise it takes the shared libraries.

include(CheckCSourceCompiles)
include(CMakePushCheckState)
include(FindPackageHandleStandardArgs)

find_path(LAPACKE_INCLUDE_DIR lapacke.h PATH_SUFFIXES lapacke)

set(LAPACKE_LIBRARIES)
set(_lapacke_probe
    "#include <lapacke.h>
     int probe(double *a, double *b, double *w, double *work);
     int probe(double *a, double *b, double *w, double *work)
     { return LAPACKE_dsygv_work(LAPACK_COL_MAJOR, 1, 'V', 'U', 2, a, 2, b, 2, w, work, 64); }
     int main(void) { double a[4] = {1}, b[4] = {1}, w[2], work[64]; return probe(a, b, w, work); }")

if(TABOR_STATIC_LAPACK)
  find_library(LAPACKE_STATIC_LIBRARY NAMES liblapacke.a)
  find_library(LAPACK_STATIC_LIBRARY NAMES liblapack_pic.a liblapack.a PATH_SUFFIXES lapack)
  find_library(BLAS_STATIC_LIBRARY NAMES libblas.a PATH_SUFFIXES blas)
  # LAPACK's error messages are Fortran; its run-time library may be there without its -dev package.
  find_library(FORTRAN_RUNTIME_LIBRARY NAMES gfortran libgfortran.so.5)
  mark_as_advanced(LAPACKE_STATIC_LIBRARY LAPACK_STATIC_LIBRARY BLAS_STATIC_LIBRARY
                   FORTRAN_RUNTIME_LIBRARY)
  if(LAPACKE_INCLUDE_DIR AND LAPACKE_STATIC_LIBRARY AND LAPACK_STATIC_LIBRARY
     AND BLAS_STATIC_LIBRARY AND FORTRAN_RUNTIME_LIBRARY)
    set(_lapacke_static "${LAPACKE_STATIC_LIBRARY}" "${LAPACK_STATIC_LIBRARY}"
                        "${BLAS_STATIC_LIBRARY}" "${FORTRAN_RUNTIME_LIBRARY}")
    get_property(_lapacke_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
    cmake_push_check_state(RESET)
    set(CMAKE_REQUIRED_QUIET TRUE)
    set(CMAKE_REQUIRED_INCLUDES "${LAPACKE_INCLUDE_DIR}")
    set(CMAKE_REQUIRED_FLAGS "-fPIC")
    set(CMAKE_REQUIRED_LINK_OPTIONS "-shared;-Wl,-z,defs")
    set(CMAKE_REQUIRED_LIBRARIES "${_lapacke_static};m")
    if("C" IN_LIST _lapacke_languages)
      check_c_source_compiles("${_lapacke_probe}" LAPACKE_STATIC_LINKS)
    endif()
    cmake_pop_check_state()
    if(LAPACKE_STATIC_LINKS OR NOT "C" IN_LIST _lapacke_languages)
      set(LAPACKE_LIBRARIES ${_lapacke_static})
    endif()
  endif()
endif()

if(NOT LAPACKE_LIBRARIES)
  find_library(LAPACKE_LIBRARY NAMES lapacke)
  find_library(LAPACK_LIBRARY NAMES lapack)
  find_library(BLAS_LIBRARY NAMES blas)
  mark_as_advanced(LAPACKE_LIBRARY LAPACK_LIBRARY BLAS_LIBRARY)
  set(LAPACKE_LIBRARIES ${LAPACKE_LIBRARY})
  foreach(_library IN ITEMS LAPACK_LIBRARY BLAS_LIBRARY) # either may be part of another
    if(${_library})
      list(APPEND LAPACKE_LIBRARIES "${${_library}}")
    endif()
  endforeach()
endif()

find_package_handle_standard_args(
  LAPACKE
  REQUIRED_VARS LAPACKE_LIBRARIES LAPACKE_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "on Debian and Ubuntu it is in the package liblapacke-dev")

if(LAPACKE_FOUND AND NOT TARGET LAPACKE::LAPACKE)
  add_library(LAPACKE::LAPACKE INTERFACE IMPORTED)
  set_target_properties(
    LAPACKE::LAPACKE PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${LAPACKE_INCLUDE_DIR}"
                                INTERFACE_LINK_LIBRARIES "${LAPACKE_LIBRARIES}")
endif()
mark_as_advanced(LAPACKE_INCLUDE_DIR)
