# graze_kernels(<name> <sources...>): compiles each source once for every level of the instruction set and names all of
# the objects in <name>_kernel_objects; <name>_objects is the target whose files call them. The source sees GRAZE_ISA, the namespace it is to define its functions in; which of them
# is called is chosen at run time by simd/dispatch.hpp.
#
# Object libraries, because one target cannot compile a source twice. Their objects are linked for everyone, also on
# machines without the instructions: hence no inline function that others share may be left in them, since the linker
# keeps any one copy. tests/simd/kernel_symbols.cmake looks for that.
set(graze_levels baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64" AND CMAKE_SIZEOF_VOID_P EQUAL 8)
  list(APPEND graze_levels avx2 avx512)
endif()

# With GRAZE_LEVELS=native only the best of them that this machine has, for what runs where it is built: a third of the
# kernels to compile; with GRAZE_LEVELS=baseline only the first, which compiles soonest. The library asks for
# GRAZE_ONLY_LEVEL in simd/dispatch.hpp.
set(graze_only_level "")
if(GRAZE_LEVELS STREQUAL "baseline")
  set(graze_only_level baseline)
  set(graze_levels baseline)
  add_compile_definitions(GRAZE_ONLY_LEVEL=baseline)
elseif(GRAZE_LEVELS STREQUAL "native" AND "avx512" IN_LIST graze_levels)
  include(CheckCXXSourceRuns)
  foreach(level IN ITEMS avx512 avx2)
    set(feature_avx512 "avx512f\") && __builtin_cpu_supports(\"avx512bw\") && __builtin_cpu_supports(\"avx512cd\") && __builtin_cpu_supports(\"avx512dq\") && __builtin_cpu_supports(\"avx512vl")
    set(feature_avx2 "avx2\") && __builtin_cpu_supports(\"fma\") && __builtin_cpu_supports(\"bmi\") && __builtin_cpu_supports(\"bmi2\") && __builtin_cpu_supports(\"popcnt")
    check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"${feature_${level}}\") ? 0 : 1; }" GRAZE_HAS_${level})
    if(GRAZE_HAS_${level})
      set(graze_only_level ${level})
      break()
    endif()
  endforeach()
  if(NOT graze_only_level)
    set(graze_only_level baseline)
  endif()
  set(graze_levels ${graze_only_level})
  add_compile_definitions(GRAZE_ONLY_LEVEL=${graze_only_level})
elseif(NOT GRAZE_LEVELS MATCHES "^(all|native)$")
  message(FATAL_ERROR "GRAZE_LEVELS: expected all, native or baseline, got ${GRAZE_LEVELS}")
endif()
set(graze_flags_baseline "")
if(EMSCRIPTEN)
  # clang 14 for WebAssembly makes other numbers of a pair of boxes alone where it joins scalars to vectors by itself.
  set(graze_flags_baseline -msimd128 -fno-slp-vectorize)
endif()
set(graze_flags_avx2 -march=x86-64-v3)
set(graze_flags_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ fuses products with sums and differences in turns where it joins scalars to vectors by itself, whatever
  # -ffp-contract says (GCC bug 106902).
  list(APPEND graze_flags_avx2 -fno-tree-slp-vectorize)
  list(APPEND graze_flags_avx512 -fno-tree-slp-vectorize)
endif()

if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # On Windows a stack is aligned by 16 bytes, and g++ moves wider registers to it as if it were aligned by their width (GCC
  # bug 54412), which ends the program. The assembler writes such moves as those that ask for no alignment and take the same
  # time where there is one. Debian's mingw-w64 is mended that way by itself, others are not.
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-Wa,-muse-unaligned-vector-move GRAZE_HAS_UNALIGNED_MOVES)
  if(NOT GRAZE_HAS_UNALIGNED_MOVES)
    message(FATAL_ERROR "Graze needs an assembler that knows -muse-unaligned-vector-move (binutils 2.38)")
  endif()
  list(APPEND graze_flags_avx2 -Wa,-muse-unaligned-vector-move)
  list(APPEND graze_flags_avx512 -Wa,-muse-unaligned-vector-move)
endif()

function(graze_kernels target)
  set(kernel_objects "")
  string(REPLACE "," ";" graze_sanitizers "${GRAZE_SANITIZE}")
  foreach(level IN LISTS graze_levels)
    set(objects ${target}_kernels_${level})
    add_library(${objects} OBJECT ${ARGN})
    target_compile_features(${objects} PRIVATE cxx_std_20)
    target_compile_definitions(${objects} PRIVATE GRAZE_ISA=${level})
    target_include_directories(${objects} PRIVATE "${PROJECT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}")
    graze_target(${objects})
    # g++ inlines what a kernel calls, and what that calls, because the kernel is "flatten"; clang only the former. With a
    # sanitizer's checks that takes minutes, and where bytes are dear it doubles the library.
    if(NOT GRAZE_SANITIZE AND NOT GRAZE_SMALL)
      target_compile_options(
        ${objects} PRIVATE "$<$<CXX_COMPILER_ID:Clang,AppleClang>:SHELL:-mllvm -inline-threshold=1000000>")
    endif()
    target_compile_options(${objects} PRIVATE ${graze_fewer_checks})
    if("address" IN_LIST graze_sanitizers)
      # Nor are a kernel's frames kept for a while after it returns: there g++ 12 forgets that wide registers want memory of
      # their alignment (GCC bug 110027). Reads and writes are checked still.
      target_compile_options(${objects} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param asan-use-after-return=0>")
    endif()
    if(GRAZE_SANITIZE)
      # Where references point to is worked out for all of a function at once: of one so long that takes a third of the time.
      target_compile_options(${objects} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-pta>)
    endif()
    # Last, so that it wins over a -march among the user's own flags.
    target_compile_options(${objects} PRIVATE ${graze_flags_${level}})
    list(APPEND kernel_objects $<TARGET_OBJECTS:${objects}>)
  endforeach()
  set(${target}_kernel_objects ${kernel_objects} PARENT_SCOPE)
endfunction()
