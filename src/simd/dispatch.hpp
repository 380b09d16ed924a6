// The level of the instruction set that kernels run at: chosen once, at the first use.
//
// A kernel is a function in a `*.kernel.cpp`, which cmake/GrazeKernels.cmake compiles once a level; each copy lives in
// the namespace of its level. Guarantee: every level gives the same bits, so that the choice is only one of speed. The
// environment variable GRAZE_ISA (baseline, avx2, avx512) forces a level; for an unknown name, or a level that this
// machine does not have, the best one is taken.
#pragma once

#include <cstddef>

namespace graze {

enum class Isa { baseline, avx2, avx512 };

/// Whether the machine and its operating system can run a level.
bool isa_available(Isa level);

/// The level that kernels run at.
Isa chosen_isa();

/// The level of that name, or the best available one: the meaning of GRAZE_ISA. Null is no name.
Isa isa_by_name(const char* name);

}  // namespace graze

// GRAZE_ONLY_LEVEL: the one level that a build has, as on processors that have no others to choose from, or where
// GRAZE_LEVELS is `native` (CMakeLists.txt).
#if !defined(__x86_64__) && !defined(GRAZE_ONLY_LEVEL)
#define GRAZE_ONLY_LEVEL baseline
#endif

#ifdef GRAZE_ONLY_LEVEL
/// Declares a kernel, given with its semicolons, for all levels.
#define GRAZE_DECLARE_KERNEL(...)                                                                                      \
  namespace GRAZE_ONLY_LEVEL {                                                                                         \
  __VA_ARGS__                                                                                                          \
  }
/// The address of the copy of a kernel for one level.
#define GRAZE_KERNEL(level, ...)                                                                                       \
  ((level) == ::graze::Isa::GRAZE_ONLY_LEVEL ? GRAZE_ONLY_LEVEL::__VA_ARGS__ : GRAZE_ONLY_LEVEL::__VA_ARGS__)
#else
#define GRAZE_DECLARE_KERNEL(...)                                                                                      \
  namespace baseline {                                                                                                 \
  __VA_ARGS__                                                                                                          \
  }                                                                                                                    \
  namespace avx2 {                                                                                                     \
  __VA_ARGS__                                                                                                          \
  }                                                                                                                    \
  namespace avx512 {                                                                                                   \
  __VA_ARGS__                                                                                                          \
  }
#define GRAZE_KERNEL(level, ...)                                                                                       \
  ((level) == ::graze::Isa::avx512 ? avx512::__VA_ARGS__                                                               \
   : (level) == ::graze::Isa::avx2 ? avx2::__VA_ARGS__                                                                 \
                                   : baseline::__VA_ARGS__)
#endif
