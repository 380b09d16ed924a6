# Every program of PAGE is compiled and run as it stands, and prints what stands in the block of output that follows it.
cmake_minimum_required(VERSION 3.22)

file(MAKE_DIRECTORY "${WORK}")
file(READ "${PAGE}" page)
string(REPLACE ";" "\\;" page "${page}") # a list's separator
string(REPLACE "[" "<bracket>" page "${page}")
string(REPLACE "]" "<tekcarb>" page "${page}")
string(REGEX MATCHALL "```c\n[^`]*```|```console\n[^`]*```" blocks "${page}")
set(programs 0)
set(printed "")
foreach(block IN LISTS blocks)
  string(REGEX REPLACE "^```[a-z]*\n|```$" "" text "${block}")
  string(REPLACE "<bracket>" "[" text "${text}")
  string(REPLACE "<tekcarb>" "]" text "${text}")
  if(block MATCHES "^```c\n")
    math(EXPR programs "${programs} + 1")
    file(WRITE "${WORK}/page_${programs}.c" "${text}")
    foreach(compiler IN LISTS COMPILERS)
      execute_process(
        COMMAND "${compiler}" -std=c99 -pedantic -Wall -Wextra -Werror "-I${INCLUDE}" "${WORK}/page_${programs}.c"
                "${LIBRARY}" -o "${WORK}/page_${programs}" -lstdc++ -lm
        COMMAND_ERROR_IS_FATAL ANY)
      execute_process(COMMAND "${WORK}/page_${programs}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
  elseif(NOT text STREQUAL printed)
    message(FATAL_ERROR "program ${programs} of ${PAGE} prints\n${printed}and the page says\n${text}")
  else()
    set(printed "compared")
  endif()
endforeach()
if(programs LESS 2 OR NOT printed STREQUAL "compared")
  message(FATAL_ERROR "${PAGE}: ${programs} programs, and the last one's output is not shown")
endif()
