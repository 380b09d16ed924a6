// The C++ standard that Graze needs, asked for in one line before an older one fails in a thousand.
//
// Guarantee: every public header includes this one, directly or through another. The compiled library and the code that
// uses it have to agree on the standard library's containers, which cross the boundary between them: code compiled with
// -D_GLIBCXX_DEBUG needs a Graze that was compiled with it too.
#pragma once

#include "graze/visibility.hpp"

#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "Graze needs C++20: compile with -std=c++20 (or /std:c++20) or later"
#endif
