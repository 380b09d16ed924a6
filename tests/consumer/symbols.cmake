# The names that SHARED exports and STATIC does not hide: the functions of graze.h, all of them, and what bears GRAZE_API
# in a public header of C++; and what STATIC takes of the C library's functions of real numbers. In the static library
# the standard library's templates stand beside its own, as in any object.
cmake_minimum_required(VERSION 3.22)

# What public headers mark, as one text of declarations.
file(GLOB_RECURSE headers "${INCLUDE}/graze/*.hpp")
set(public "")
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "GRAZE_API[^;{]*" declarations "${text}")
  string(APPEND public "${declarations}\n")
endforeach()
# Classes whose definitions stand behind a template's instance.
string(REGEX MATCHALL "[A-Za-z_][A-Za-z0-9_]*" public "${public}")
list(REMOVE_DUPLICATES public)

file(READ "${INCLUDE}/graze/graze.h" text)
string(REGEX MATCHALL "[ *]graze_[a-z0-9_]+\\(" declared "${text}")
list(TRANSFORM declared REPLACE "[ *(]" "")
list(REMOVE_DUPLICATES declared)
list(LENGTH declared declared_count)
if(declared_count LESS 250)
  message(FATAL_ERROR "only ${declared_count} functions were found in graze.h")
endif()

# The first name below namespace graze, of the function where it is something inside one, (or one of its public namespaces) in a mangled name.
function(outermost_name symbol result)
  string(REGEX REPLACE "^_Z(GV|TV|TI|TS|TT|TC)?Z?NK?5graze" "" rest "${symbol}")
  set(name "")
  while(rest MATCHES "^([0-9]+)(.*)$")
    set(length "${CMAKE_MATCH_1}")
    string(SUBSTRING "${CMAKE_MATCH_2}" 0 ${length} name)
    string(SUBSTRING "${CMAKE_MATCH_2}" ${length} -1 rest)
    if(NOT name MATCHES "^(plane|validate|io|detail)$")
      break()
    endif()
  endwhile()
  set(${result} "${name}" PARENT_SCOPE)
endfunction()

function(check library symbols also)
  set(in_c "")
  set(seen "")
  set(strangers "")
  foreach(symbol IN LISTS symbols)
    if(symbol MATCHES "^graze_")
      list(APPEND in_c "${symbol}")
    elseif(symbol MATCHES "^_Z(GV|TV|TI|TS|TT|TC)?Z?NK?5graze")
      outermost_name("${symbol}" name)
      if(NOT name IN_LIST seen)
        list(APPEND seen "${name}")
        if(NOT name IN_LIST public)
          list(APPEND strangers "${symbol}")
        endif()
      endif()
    elseif(also STREQUAL "" OR NOT symbol MATCHES "${also}")
      list(APPEND strangers "${symbol}")
    endif()
  endforeach()
  set(missing ${declared})
  list(REMOVE_ITEM missing ${in_c})
  list(REMOVE_ITEM in_c ${declared})
  list(LENGTH seen seen_count)
  if(seen_count LESS 30 OR strangers OR missing OR in_c)
    list(JOIN strangers "\n  " strangers)
    message(FATAL_ERROR "${library}: ${seen_count} public names of C++\nnot public:\n  ${strangers}\n"
                        "declared in graze.h and not there: ${missing}\nthere and not declared: ${in_c}")
  endif()
endfunction()

execute_process(COMMAND "${NM}" -D --defined-only --format=just-symbols "${SHARED}" OUTPUT_VARIABLE symbols
                        COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
check("${SHARED}" "${symbols}" "")

execute_process(
  COMMAND "${READELF}" -sW "${STATIC}"
  COMMAND awk "$5 != \"LOCAL\" && $6 == \"DEFAULT\" && $7 != \"UND\" && $8 != \"\" && $7 ~ /^[0-9]+$/ { print $8 }"
  COMMAND sort -u
  OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
check("${STATIC}" "${symbols}" "^_Z(GV|T[VIST])?Z?N?K?(S[a-z]|9__gnu_cxx)|^DW\\.ref\\.__gxx")

# The same bits on every machine: sines and powers differ from one C library to the next, of which IEEE 754 promises the
# square root alone. `graze/angles.hpp` has what is needed.
execute_process(COMMAND "${NM}" --undefined-only --format=just-symbols "${STATIC}" OUTPUT_VARIABLE symbols
                        COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
list(REMOVE_DUPLICATES symbols)
list(FILTER symbols INCLUDE REGEX
     "^a?(sin|cos|tan)h?[fl]?$|^(sincos|atan2|exp|exp2|expm1|log|log2|log10|log1p|pow|hypot|cbrt|fma)[fl]?$")
if(symbols)
  message(FATAL_ERROR "${STATIC} takes from the C library, whose bits may differ: ${symbols}")
endif()
