# Looks at the objects of kernels: NM, OBJECTS (a list). What one of them defines weakly or uniquely, an inline function
# or a template, is one of several copies of which the linker keeps any: outside of the namespaces of the levels that
# would be code for an instruction set that not every machine has. DW.ref is a pointer of the unwinder's, not code.
cmake_minimum_required(VERSION 3.22)

if(NOT OBJECTS)
  message(FATAL_ERROR "no objects of kernels to look at")
endif()
set(shared "")
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND "${NM}" -C --defined-only "${object}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" " " symbols "${symbols}")
  string(REPLACE "\n" ";" symbols "${symbols}")
  foreach(symbol IN LISTS symbols)
    if(symbol MATCHES "^[0-9a-f]* +[WVu] " AND NOT symbol MATCHES " DW\\.ref\\." AND NOT symbol MATCHES "[WVu] (guard variable for |[a-z0-9 :*&<>]* )?graze::(baseline|avx2|avx512)::")
      string(APPEND shared "  ${object}: ${symbol}\n")
    endif()
  endforeach()
endforeach()
if(shared)
  message(FATAL_ERROR "symbols that kernels of different levels share:\n${shared}")
endif()
