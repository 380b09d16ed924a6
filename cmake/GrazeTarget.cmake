# graze_target(<target>): the compiler flags that every target of ours has in common.
#
# A function and not an interface library, because a static library would have to export and install the latter.
# The flags are private: they say how Graze is compiled, not how its users must compile.

# Answers are the same bits with every compiler, at every optimisation level and in every lane width only if no
# compiler fuses a*b+c on its own (g++ does by default, clang within an expression). errno after sqrt keeps the
# compiler from vectorising it. -ffast-math is never right here: it reorders sums and assumes NaN away.
set(graze_floating_point -ffp-contract=off -fno-math-errno)

set(graze_warnings
    -Wall
    -Wextra
    -Wshadow
    -Wconversion # float from double above all: the scalars come from one source
    -Wno-sign-conversion # clang counts it in -Wconversion, g++ does not; every index would need a cast
    -Wold-style-cast
    -Wnon-virtual-dtor
    -Woverloaded-virtual
    -Wcast-align
    -Wundef
    -Wno-psabi) # vector types are passed differently than by old compilers, and nobody links Graze to such code
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # -Wdouble-promotion: double from float unasked costs speed; clang's also counts `double h(some_float)`.
  list(APPEND graze_warnings -Wlogical-op -Wdouble-promotion)
else()
  # Kernels join conditions by & because a lane's are masks; for a single scalar they are bools.
  list(APPEND graze_warnings -Wno-bitwise-instead-of-logical)
endif()

set(graze_sanitize "")
if(GRAZE_SANITIZE)
  # Without recovery, so that undefined behaviour fails a test instead of adding a line to its log.
  set(graze_sanitize -fsanitize=${GRAZE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Without asking of each reference whether it is null and how large what it refers to is, and of each sum with a pointer
  # whether it wrapped: the address sanitizer and the hardware tell where it matters, and these take two fifths of the time
  # to compile.
  if(GRAZE_SANITIZE MATCHES "undefined")
    list(APPEND graze_sanitize -fno-sanitize=null,object-size,pointer-overflow)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND graze_warnings -Wno-maybe-uninitialized) # g++ takes the sanitizers' own branches for ours
  endif()
endif()
# For kernels, into which thousands of small functions are inlined, and for tests' own code: without the marks for the
# scope of each temporary, and without asking of each reference whether it is aligned.
set(graze_fewer_checks "")
if(GRAZE_SANITIZE MATCHES "address|undefined")
  set(graze_fewer_checks -fno-sanitize-address-use-after-scope -fno-sanitize=alignment)
endif()
# For the program's own code and that of tests, which calls the rest: under the sanitizers not optimised, which clang
# compiles in half of the time. What fuzzers go through, as readers do, they would go through half as often and less.
set(graze_unhurried "")
if(GRAZE_SANITIZE)
  set(graze_unhurried -O0)
endif()

# graze_join(<target> <count>): compiles up to so many of the target's files as one.
#
# Where small files include big headers (CLI11, nlohmann-json, fmt, GoogleTest), the compiler spends its time on what it
# instantiates for each file anew: joined, they cost it a third. Precompiled headers save only the reading. Hence the
# names in the unnamed namespaces of a target differ from file to file. Each file compiles alone as well: the clang preset
# keeps them apart, which shows it, and which clang-tidy needs.
option(GRAZE_JOIN_FILES "Compile small files that include big headers several at a time" ON)
function(graze_join target count)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${GRAZE_JOIN_FILES} UNITY_BUILD_BATCH_SIZE ${count})
  # What is included counts as a header to g++, in which an unnamed namespace would be a mistake.
  if(GRAZE_JOIN_FILES AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# graze_precompile(<target> <headers...>): reads the headers that most of the target's files share once and not for each
# file, where the whole is built once on a machine without a cache of objects, as the demo is. Our own headers are named
# from the top of the project.
option(GRAZE_PRECOMPILE "Read the headers that most files share once" OFF)
function(graze_precompile target)
  if(GRAZE_PRECOMPILE)
    list(TRANSFORM ARGN REPLACE "^include/" "${PROJECT_SOURCE_DIR}/include/")
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# Each function and number in a section of its own, of which a program keeps those that it reaches: one that asks for the
# distance of two boxes has 1.2 MB so and 5.9 without.
set(graze_sections -ffunction-sections -fdata-sections)
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(graze_keep_reached -Wl,--gc-sections)
elseif(MINGW)
  # The format of objects on Windows counts sections in 16 bits unless told.
  list(APPEND graze_sections -Wa,-mbig-obj)
endif()

# graze_c_target(<target>): the same of a program in C.
function(graze_c_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -pedantic -Wshadow -Wstrict-prototypes ${graze_sanitize})
  target_link_options(${target} PRIVATE ${graze_sanitize})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  if(GRAZE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

function(graze_target target)
  target_compile_options(${target} PRIVATE ${graze_warnings} ${graze_floating_point} ${graze_sections} ${graze_sanitize})
  target_link_options(${target} PRIVATE ${graze_sanitize})
  if(GRAZE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
