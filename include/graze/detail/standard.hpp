// Check of the C++ standard that Graze needs: one line of error before an older one fails in a thousand.
//
// Guarantee: every public header includes this one, directly or through another, but for visibility.hpp beside it,
// which this one needs. The compiled library and the code that uses it have to agree on the standard library's
// containers, which cross the boundary between them: code compiled with -D_GLIBCXX_DEBUG needs a Graze that was
// compiled with it too, and is not linked with another. The C interface (graze/graze.h) takes no containers and may be
// used with either.
#pragma once

#include "graze/detail/visibility.hpp"

#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "Graze needs C++20: compile with -std=c++20 (or /std:c++20) or later"
// No such file: g++ and clang go on after #error and end here, before the other headers' errors hide that one.
#include <graze/needs_cpp20>
#endif

#if defined(__GNUC__)
namespace graze::detail {

/// The library defines the one of these two that fits its own containers.
extern GRAZE_API const char library_without_glibcxx_debug, library_with_glibcxx_debug;

/// A reference that only the library with this file's containers resolves: the linker refuses the other.
#ifdef _GLIBCXX_DEBUG
[[maybe_unused, gnu::used]] static const char* const fitting_library = &library_with_glibcxx_debug;
#else
[[maybe_unused, gnu::used]] static const char* const fitting_library = &library_without_glibcxx_debug;
#endif

}  // namespace graze::detail
#endif
