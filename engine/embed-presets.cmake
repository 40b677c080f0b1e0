# SPDX-License-Identifier: MIT
# Writes preset files, without their comments, as the C table of engine/src/definition/preset.h, in this order:
#
#   cmake -D "OUTPUT=TABLE.c" -D "PRESETS=A.ini;B.ini" [-D KITS=ON] -P embed-presets.cmake
#
# With KITS the table is that of engine/src/kit/kit_def.h. The library reads the texts when a preset is asked for
# (tests/engine/test_preset.c and test_kit_def.c see to it that it can).
cmake_minimum_required(VERSION 3.22)

if(NOT OUTPUT OR NOT PRESETS)
  message(FATAL_ERROR "usage: cmake -D OUTPUT=TABLE.c -D \"PRESETS=A.ini;B.ini\" -P embed-presets.cmake")
endif()
if(KITS)
  set(header "kit/kit_def.h")
  set(table tb_kits)
  set(count tb_kit_count)
else()
  set(header "definition/preset.h")
  set(table tb_presets)
  set(count tb_preset_count)
endif()

# as_bytes(VARIABLE TEXT): the text as the elements of a C array.
function(as_bytes variable text)
  string(HEX "${text}" hex)
  string(REGEX REPLACE "(..)" "0x\\1," hex "${hex}")
  string(REPLACE "0x0a," "0x0a,\n" hex "${hex}")
  set(${variable} "${hex}" PARENT_SCOPE)
endfunction()

set(arrays "")
set(rows "")
set(index 0)
foreach(file IN LISTS PRESETS)
  file(READ "${file}" text)
  string(REGEX REPLACE "[ \t]+;[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n+(;[^\n]*\n+)*" "\n" text "\n${text}")
  string(REGEX MATCH "\ncomment = ([^\n]*)" comment "${text}")
  as_bytes(comment "${CMAKE_MATCH_1}")
  get_filename_component(file_name "${file}" NAME)
  get_filename_component(name "${file}" NAME_WLE)
  set(base "NULL")
  if(KITS)
    set(category "kit")
  elseif(text MATCHES "\n\\[drum\\]\nbase = ([^\n]*)") # a tuning, behind its drum
    set(base "\"${CMAKE_MATCH_1}\"")
    set(category "${category_${CMAKE_MATCH_1}}")
  else()
    string(REGEX MATCH "\ncategory = ([^\n]*)" ignored "${text}")
    set(category "${CMAKE_MATCH_1}")
    set(category_${name} "${category}")
  endif()
  as_bytes(bytes "${text}")
  string(APPEND arrays "\nstatic const unsigned char comment_${index}[] = {\n${comment}0};\n"
                       "static const unsigned char text_${index}[] = {\n${bytes}};\n")
  string(APPEND rows "  {{\"${name}\", (const char *)comment_${index}, \"${file_name}\", \"${category}\", ${base}},
   (const char *)text_${index}, sizeof text_${index}},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(
  WRITE "${OUTPUT}"
  "/* Written by engine/embed-presets.cmake from text files. */
#include \"${header}\"
${arrays}
const TbPreset ${table}[] = {
${rows}};

const uint32_t ${count} = ${index};
")
