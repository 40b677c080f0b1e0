# SPDX-License-Identifier: MIT
# Toolchain file: builds the library for WebAssembly with Emscripten, for machines that have its vectors.
find_program(TABOR_EM_CONFIG em-config)
if(NOT TABOR_EM_CONFIG)
  message(FATAL_ERROR "Emscripten was not found: tools/setup --web installs it")
endif()
execute_process(COMMAND "${TABOR_EM_CONFIG}" EMSCRIPTEN_ROOT OUTPUT_VARIABLE TABOR_EMSCRIPTEN
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_C_FLAGS_INIT -msimd128)
include("${TABOR_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake")
