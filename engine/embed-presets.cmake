# SPDX-License-Identifier: MIT
# Writes preset files as the C table of engine/src/definition/preset.h, in this order:
#
#   cmake -D "OUTPUT=TABLE.c" -D "PRESETS=A.ini;B.ini" [-D KITS=ON] -P embed-presets.cmake
#
# With KITS the table is that of engine/src/kit/kit_def.h.
# It reads what host/drums/preset_file.h describes, and no text but ASCII. Whether the values make sense is tested
# later (tests/engine/test_preset.c); here a file only has to be sound.
cmake_minimum_required(VERSION 3.22)

set(LINE_LIMIT 198) # bytes, as host/drums/preset_file.h has them
set(WORD_LIMIT 49)
set(SIZE_LIMIT 65536)

# Stand-ins, while a file is a list, for what lists do not hold as it is.
string(ASCII 1 SEMICOLON)
string(ASCII 2 OPEN)
string(ASCII 3 CLOSE)
string(ASCII 4 BACKSLASH)
set(BLANK "[ \t]")

# refuse(REASON [LINE]): of `file`.
function(refuse reason)
  if(ARGC GREATER 1)
    string(APPEND file ":${ARGV1}")
  endif()
  message(FATAL_ERROR "${file}: ${reason}")
endfunction()

# read_lines(LIST FILE): its lines, with the stand-ins.
function(read_lines variable file)
  file(SIZE "${file}" size)
  if(size EQUAL 0)
    refuse("the file holds no section")
  elseif(size GREATER SIZE_LIMIT)
    refuse("the file is larger than ${SIZE_LIMIT} bytes")
  endif()
  file(READ "${file}" text) # without the carriage returns of line ends
  string(REGEX MATCH ".*" seen "${text}") # as far as a zero byte
  string(LENGTH "${text}" length)
  string(LENGTH "${seen}" seen_length)
  if(NOT length EQUAL seen_length OR text MATCHES "[^ -~\t\n]")
    refuse("the file has characters other than printable ASCII, tabs and line ends")
  endif()
  if(NOT text MATCHES "\n$")
    refuse("the last line has no line end: was the file cut off?")
  endif()
  string(REPLACE "\\" "${BACKSLASH}" text "${text}")
  string(REPLACE ";" "${SEMICOLON}" text "${text}")
  string(REPLACE "[" "${OPEN}" text "${text}")
  string(REPLACE "]" "${CLOSE}" text "${text}")
  string(REPLACE "\n" ";" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# as_c(VARIABLE TEXT): the text as a C string. '?' could begin a trigraph.
function(as_c variable text)
  string(REPLACE "${BACKSLASH}" "\\134" text "${text}")
  string(REPLACE "${SEMICOLON}" ";" text "${text}")
  string(REPLACE "${OPEN}" "[" text "${text}")
  string(REPLACE "${CLOSE}" "]" text "${text}")
  string(REPLACE "\"" "\\042" text "${text}")
  string(REPLACE "?" "\\077" text "${text}")
  string(REPLACE "\t" "\\011" text "${text}")
  set(${variable} "\"${text}\"" PARENT_SCOPE)
endfunction()

function(check_word what word)
  string(LENGTH "${word}" length)
  if(length EQUAL 0)
    refuse("a ${what} without a name" ${number})
  elseif(length GREATER WORD_LIMIT)
    refuse("the ${what} is longer than ${WORD_LIMIT} bytes" ${number})
  endif()
endfunction()

# A line of the table; `value` is C.
macro(add_pair)
  as_c(c_key "${full_key}")
  string(APPEND pairs "  {${c_key}, ${value}},\n")
  math(EXPR pair_count "${pair_count} + 1")
endmacro()

# The line `text` with a section. Macros without arguments, for the text of a macro's argument would be read as CMake.
macro(take_section)
  if(NOT text MATCHES "^${OPEN}([^${CLOSE}${SEMICOLON}]*)${CLOSE}${BLANK}*(.*)$")
    refuse("a '[' without a ']'" ${number})
  endif()
  set(section "${CMAKE_MATCH_1}")
  if(NOT "${CMAKE_MATCH_2}" MATCHES "^(${SEMICOLON}.*)?$")
    refuse("text after the section's ']'" ${number})
  endif()
  check_word(section "${section}")
  if(section IN_LIST sections)
    refuse("section [${section}] occurs twice" ${number})
  endif()
  list(APPEND sections "${section}")
  set(keys)
  set(full_key "${section}")
  set(value NULL)
  add_pair()
endmacro()

# The line `text` with key = value.
macro(take_pair)
  if(NOT text MATCHES "^([^=:${SEMICOLON}]*)=(.*)$")
    refuse("the line is neither [section], key = value nor ; comment" ${number})
  endif()
  set(key "${CMAKE_MATCH_1}")
  set(value "${CMAKE_MATCH_2}")
  string(REGEX REPLACE "${BLANK}${SEMICOLON}.*" "" value "${value}")
  string(STRIP "${key}" key)
  string(STRIP "${value}" value)
  check_word(key "${key}")
  if("${sections}" STREQUAL "")
    refuse("'${key}' stands before the first section" ${number})
  endif()
  if(key IN_LIST keys)
    refuse("'${key}' occurs twice in its section" ${number})
  endif()
  list(APPEND keys "${key}")
  set(full_key "${section}.${key}")
  as_c(value "${value}")
  if(full_key STREQUAL "${of_what}.comment")
    set(comment "${value}")
  endif()
  add_pair()
endmacro()

macro(take_line)
  string(LENGTH "${text}" length)
  if(length GREATER LINE_LIMIT)
    refuse("the line is longer than ${LINE_LIMIT} bytes" ${number})
  elseif(text MATCHES "^${BLANK}*([${SEMICOLON}#].*)?$")
    # a comment, or nothing
  elseif(text MATCHES "^${BLANK}")
    refuse("the line is indented" ${number})
  elseif(text MATCHES "^${OPEN}")
    take_section()
  else()
    take_pair()
  endif()
endmacro()

# embed(FILE INDEX): adds its pairs to `arrays` and its row to `rows`.
function(embed file index)
  read_lines(lines "${file}")
  set(comment "\"\"")
  set(pair_count 0)
  set(number 0)
  set(sections "")
  set(pairs "")
  foreach(text IN LISTS lines)
    math(EXPR number "${number} + 1")
    take_line()
  endforeach()
  if("${sections}" STREQUAL "")
    refuse("the file holds no section")
  endif()
  get_filename_component(file_name "${file}" NAME)
  get_filename_component(name "${file}" NAME_WLE)
  string(APPEND arrays "\nstatic const TbPresetPair pairs_${index}[] = {\n${pairs}};\n")
  string(APPEND rows "  {{\"${name}\", ${comment}, \"${file_name}\"}, pairs_${index}, ${pair_count}},\n")
  set(arrays "${arrays}" PARENT_SCOPE)
  set(rows "${rows}" PARENT_SCOPE)
endfunction()

if(NOT OUTPUT OR NOT PRESETS)
  message(FATAL_ERROR "usage: cmake -D OUTPUT=TABLE.c -D \"PRESETS=A.ini;B.ini\" -P embed-presets.cmake")
endif()
if(KITS)
  set(of_what kit)
  set(header "kit/kit_def.h")
  set(table tb_kits)
  set(number_of tb_kit_count)
else()
  set(of_what drum)
  set(header "definition/preset.h")
  set(table tb_presets)
  set(number_of tb_preset_count)
endif()
set(count 0)
foreach(file IN LISTS PRESETS)
  embed("${file}" ${count})
  math(EXPR count "${count} + 1")
endforeach()
file(
  WRITE "${OUTPUT}"
  "/* Written by engine/embed-presets.cmake from text files. */
#include \"${header}\"
#include <stddef.h>
${arrays}
const TbPreset ${table}[] = {
${rows}};

const uint32_t ${number_of} = ${count};
")
