# The public headers below INCLUDE compile behind <windows.h>, whose macros take names away: with each compiler of
# COMPILERS. One for Windows reads the real header; for others the macros stand here. The standard library's headers come
# before them, since libstdc++ uses some of the names.
cmake_minimum_required(VERSION 3.22)

file(GLOB_RECURSE headers RELATIVE "${INCLUDE}" "${INCLUDE}/graze/*.hpp" "${INCLUDE}/graze/*.h")
list(FILTER headers EXCLUDE REGEX "^graze/mpi/") # they need those of MPI
if(NOT headers)
  message(FATAL_ERROR "no headers in ${INCLUDE}")
endif()
set(own "")
set(standard "")
foreach(header IN LISTS headers)
  string(APPEND own "#include <${header}>\n")
  file(STRINGS "${INCLUDE}/${header}" includes REGEX "^#include <[^/]*>")
  list(APPEND standard ${includes})
endforeach()
list(REMOVE_DUPLICATES standard)
list(JOIN standard "\n" standard)

# As in minwindef.h, rpcndr.h, combaseapi.h, wingdi.h and winnt.h. Those of mingw-w64 leave `min` and `max` to the standard
# library in C++, and Microsoft's do not, unless NOMINMAX is defined.
set(names [=[
#undef min
#undef max
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#ifndef _WIN32
#define near
#define far
#define NEAR
#define FAR
#define pascal __stdcall
#define cdecl
#define CALLBACK __stdcall
#define CONST const
#define VOID void
#define IN
#define OUT
#define OPTIONAL
#define STRICT 1
#define TRUE 1
#define FALSE 0
#define interface struct
#define PURE = 0
#define THIS void
#define hyper __int64
#define ERROR 0
#define DIFFERENCE 11
#define TRANSPARENT 1
#define OPAQUE 2
#define ABSOLUTE 1
#define RELATIVE 2
#define PASSTHROUGH 19
#define DELETE (0x00010000L)
#define IGNORE 0
#define INFINITE 0xffffffff
#define RGB(r, g, b) ((r) | (g) << 8 | (b) << 16)
#define Yield()
#define environ (*_environ)
#define GetObject GetObjectA
#define GetMessage GetMessageA
#define CreateWindow(...) CreateWindowExA(0L, __VA_ARGS__)
#endif
#undef small
#define small char
]=])

file(MAKE_DIRECTORY "${WORK}")
file(WRITE "${WORK}/windows_names.cpp"
     "#ifdef _WIN32\n#include <windows.h>\n#ifdef NOMINMAX\n#undef NOMINMAX\n#endif\n#endif\n${standard}\n${names}${own}")
foreach(compiler IN LISTS COMPILERS)
  # And as other compilers read them: in the letter of the standard, without vectors of the compiler's own.
  foreach(lanes IN ITEMS "" "-DGRAZE_PLAIN_LANES")
    execute_process(COMMAND "${compiler}" -std=c++20 -pedantic-errors ${lanes} -fsyntax-only "-I${INCLUDE}"
                            "${WORK}/windows_names.cpp" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
