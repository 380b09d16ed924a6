// GRAZE_API: the mark of what the compiled library offers.
//
// Guarantee: Graze is compiled with hidden visibility, and each function and class of the public headers that is
// compiled into the library bears this mark: libgraze.so exports these names and no others, and a name of the inside
// never meets one of the same name in a user's program. Where there is no such visibility the mark is empty: on Windows
// Graze is linked statically.
#pragma once

#if defined(__GNUC__) && !defined(_WIN32)
#define GRAZE_API __attribute__((visibility("default")))
#else
#define GRAZE_API
#endif
