// The scalar of the module, and names that go with it, for functions that only JavaScript has.
//
// GRAZE_C_TAG and TYPE are those of the C interface (c/double.cpp, c/float.cpp), so that its handles can be opened.
#pragma once

#ifdef GRAZE_JS_DOUBLE
#define EXPORTED(name) __attribute__((export_name("graze_js_" name "_d")))
#define GRAZE_C_TAG 0x67720d00u
#define TYPE(name) Graze##name##d
using T = double;
#else
#define EXPORTED(name) __attribute__((export_name("graze_js_" name "_f")))
#define GRAZE_C_TAG 0x67720f00u
#define TYPE(name) Graze##name##f
using T = float;
#endif
