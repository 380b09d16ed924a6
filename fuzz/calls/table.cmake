# Writes the table of all functions of the C interface from its header: one line each, with the names of its parameters,
#
#     SCALAR_CALL(shape_sphere, "radius", "center", "shape")   for graze_shape_sphere_d and graze_shape_sphere_f
#     COMMON_CALL(graze_trace_view, "trace", "view")           for those without a scalar
#
# so that a new function is fuzzed without a word. Fails where a declaration is not understood.
#
#     cmake -DHEADER=<graze.h> -DTABLE=<file to write> -P table.cmake
file(READ "${HEADER}" text)
string(REGEX REPLACE "(//|#)[^\n]*" "" text "${text}")
string(REGEX MATCHALL "GRAZE_C_API " declared "${text}")
list(LENGTH declared declared)

string(REGEX REPLACE "[ \n]+" " " text "${text}")
# A parameter that is a pointer to a function counts by its name alone.
string(REGEX REPLACE "\\(\\*([a-z_]+)\\)\\([^()]*\\)" "\\1" text "${text}")
string(REPLACE ";" "\n" text "${text}")
string(REGEX MATCHALL "GRAZE_C_API [^\n]*" lines "${text}")

set(understood 0)
set(table "")
foreach(line IN LISTS lines)
  if(NOT line MATCHES "^GRAZE_C_API .*[ *](graze_[a-z_]+)\\((.*)\\)$")
    message(FATAL_ERROR "${HEADER}: no declaration of a function: ${line}")
  endif()
  math(EXPR understood "${understood} + 1")
  set(function "${CMAKE_MATCH_1}")
  set(names "")
  if(NOT CMAKE_MATCH_2 STREQUAL "void")
    string(REPLACE "," ";" parameters "${CMAKE_MATCH_2}")
    foreach(parameter IN LISTS parameters)
      string(REGEX REPLACE "\\[[0-9]+\\]$" "" parameter "${parameter}")
      string(REGEX REPLACE "^.*[ *]([a-z_]+)$" "\\1" name "${parameter}")
      string(APPEND names ", \"${name}\"")
    endforeach()
  endif()
  if(function MATCHES "^graze_(.*)_d$")
    string(APPEND table "SCALAR_CALL(${CMAKE_MATCH_1}${names})\n")
  elseif(NOT function MATCHES "_f$")
    string(APPEND table "COMMON_CALL(${function}${names})\n")
  endif()
endforeach()
if(NOT understood EQUAL declared)
  message(FATAL_ERROR "${HEADER}: ${declared} functions are declared, ${understood} are understood")
endif()
file(WRITE "${TABLE}" "${table}")
