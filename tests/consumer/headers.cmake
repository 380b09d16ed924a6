# What public headers promise of themselves, tried with each compiler of COMPILERS: they compile without exceptions and
# run-time type information, also into a program that is linked with LIBRARY and runs; with other containers than the
# library's a program is not linked; an older standard is refused before any other error, graze.hpp includes all of the core, and
# graze.h is C99 and C++.
cmake_minimum_required(VERSION 3.22)

file(MAKE_DIRECTORY "${WORK}")
file(GLOB_RECURSE headers RELATIVE "${INCLUDE}" "${INCLUDE}/graze/*.hpp")
list(FILTER headers EXCLUDE REGEX "^graze/mpi/") # they need those of MPI
if(NOT headers)
  message(FATAL_ERROR "no headers in ${INCLUDE}")
endif()
set(everything "")
foreach(header IN LISTS headers)
  string(APPEND everything "#include <${header}>\n")
endforeach()
file(WRITE "${WORK}/everything.hpp" "${everything}#include <graze/graze.h>\n")
file(WRITE "${WORK}/header.c" "#include <graze/graze.h>\n")
file(WRITE "${WORK}/core.cpp" "#include <graze/graze.hpp>\n")

foreach(compiler IN LISTS COMPILERS)
  set(program "${WORK}/no_exceptions")
  execute_process(COMMAND "${compiler}" -std=c++20 -fno-exceptions -fno-rtti "-I${INCLUDE}" "-I${WORK}"
                          "${CMAKE_CURRENT_LIST_DIR}/no_exceptions.cpp" "${LIBRARY}" -o "${program}"
                          COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${program}" COMMAND_ERROR_IS_FATAL ANY)
  # Containers that are not the library's are no crash but no program; the C interface takes none.
  execute_process(COMMAND "${compiler}" -std=c++20 -D_GLIBCXX_DEBUG "-I${INCLUDE}" "${CMAKE_CURRENT_LIST_DIR}/main.cpp"
                          "${LIBRARY}" -o "${program}"
                  RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(result EQUAL 0 OR NOT errors MATCHES "library_with_glibcxx_debug")
    message(FATAL_ERROR "${compiler} -D_GLIBCXX_DEBUG is linked with a library without: ${errors}")
  endif()
  execute_process(COMMAND "${compiler}" -std=c++20 -D_GLIBCXX_DEBUG "-I${INCLUDE}" -x c++ "${CMAKE_CURRENT_LIST_DIR}/main.c"
                          -x none "${LIBRARY}" -o "${program}" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${program}" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${compiler}" -x c -std=c99 -pedantic -Wall -Wextra -Werror -fsyntax-only "-I${INCLUDE}"
                          "${WORK}/header.c" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${compiler}" -std=c++17 -fsyntax-only "-I${INCLUDE}" "${WORK}/core.cpp"
                  RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(result EQUAL 0 OR NOT errors MATCHES "Graze needs C\\+\\+20")
    message(FATAL_ERROR "${compiler} -std=c++17 does not say which standard is needed: ${errors}")
  endif()
  # The second error is what ends the compilation.
  string(REGEX MATCHALL "error: " found "${errors}")
  list(LENGTH found count)
  if(count GREATER 2)
    message(FATAL_ERROR "${compiler} -std=c++17 says which standard is needed among ${count} errors")
  endif()
endforeach()

list(GET COMPILERS 0 compiler)
execute_process(COMMAND "${compiler}" -std=c++20 -MM "-I${INCLUDE}" "${WORK}/core.cpp" OUTPUT_VARIABLE included
                        COMMAND_ERROR_IS_FATAL ANY)
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^graze/(io/|tbb_executor)" AND NOT included MATCHES "/${header}[ \n\\\\]")
    message(FATAL_ERROR "graze.hpp does not include ${header}")
  endif()
endforeach()
