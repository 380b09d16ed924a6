#include "graze/detail/standard.hpp"

#if defined(__GNUC__)
namespace graze::detail {

#ifdef _GLIBCXX_DEBUG
const char library_with_glibcxx_debug = 1;
#else
const char library_without_glibcxx_debug = 1;
#endif

}  // namespace graze::detail
#endif
