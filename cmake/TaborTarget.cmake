# SPDX-License-Identifier: MIT
# What every target of the project has in common.

# The sanitizers and the coverage counters must reach every object and every link.
if(TABOR_SANITIZE)
  set(TABOR_SANITIZE_FLAGS -fsanitize=address,undefined -fno-sanitize-recover=all)
  add_compile_options(${TABOR_SANITIZE_FLAGS} -fno-omit-frame-pointer)
  add_link_options(${TABOR_SANITIZE_FLAGS})
endif()
if(TABOR_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(TABOR_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

# What mingw-w64 needs. The C library's printf() of C11 takes %zu. The stack is aligned to 16 bytes there, and gcc
# takes no notice: registers of AVX are kept on it by instructions that want no alignment.
if(MINGW)
  add_compile_definitions(__USE_MINGW_ANSI_STDIO=1)
  add_compile_options(-Wa,-muse-unaligned-vector-move)
endif()

# C11, and the warnings; as errors with TABOR_WARNINGS_AS_ERRORS.
function(tabor_target_defaults target)
  set_target_properties(${target} PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON)
  if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(
      ${target}
      PRIVATE -Wall
              -Wextra
              -Wpedantic
              -Wshadow
              -Wconversion
              -Wstrict-prototypes
              -Wmissing-prototypes
              -Wvla
              # mingw's isfinite() and its like are macros of float and double
              $<$<BOOL:${MINGW}>:-Wno-float-conversion>
              $<$<BOOL:${TABOR_WARNINGS_AS_ERRORS}>:-Werror>)
  endif()
endfunction()
