// GRAZE_API: the mark of functions and classes in the compiled library.
//
// Guarantee: Graze is compiled with hidden visibility, and each function and class of the public headers that is
// compiled into the library bears this mark: libgraze.so exports these names and no others, and an internal name never
// clashes with one in a user's program. The mark is empty where there is no such visibility: on Windows Graze is linked
// statically.
#pragma once

#if defined(__GNUC__) && !defined(_WIN32)
#define GRAZE_API __attribute__((visibility("default")))
#else
#define GRAZE_API
#endif
