# Looks at the code of kernels: OBJDUMP, OBJECTS (a list). A product fused with a sum is rounded once where others round
# twice: a kernel that has one answers other bits than its other levels.
cmake_minimum_required(VERSION 3.22)

if(NOT OBJECTS)
  message(FATAL_ERROR "no objects of kernels to look at")
endif()
set(fused "")
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND "${OBJDUMP}" -d --no-show-raw-insn "${object}" OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
  if(code MATCHES "[ \t](vfn?m(add|sub)[0-9a-z]*)")
    string(APPEND fused "  ${object}: ${CMAKE_MATCH_1}\n")
  endif()
endforeach()
if(fused)
  message(FATAL_ERROR "fused products:\n${fused}")
endif()
