// Functions of JavaScript behind the C interface's callbacks: `user` is the number by which JavaScript knows its
// function.
#include <malloc.h>

#include <cstddef>
#include <cstdint>

#include "graze/graze.h"

#define GRAZE_JS_IMPORT(name) __attribute__((import_module("graze"), import_name(name)))
#define GRAZE_JS_EXPORT(name) __attribute__((export_name(name)))

extern "C" {

GRAZE_JS_IMPORT("allow")
bool graze_js_call_allow(std::uintptr_t key, std::uint32_t a, std::uint32_t a_generation, std::uint32_t b,
                         std::uint32_t b_generation);
GRAZE_JS_IMPORT("accept") bool graze_js_call_accept(std::uintptr_t key, std::uint32_t index, std::uint32_t generation);
GRAZE_JS_IMPORT("support") void graze_js_call_support(std::uintptr_t key, const void* direction, void* point);
GRAZE_JS_IMPORT("release") void graze_js_call_release(std::uintptr_t key);

}  // extern "C"

namespace {

std::uintptr_t key_of(const void* user) { return reinterpret_cast<std::uintptr_t>(user); }

bool allow(void* user, GrazeBodyId a, GrazeBodyId b) {
  return graze_js_call_allow(key_of(user), a.index, a.generation, b.index, b.generation);
}

bool accept(void* user, GrazeBodyId body) { return graze_js_call_accept(key_of(user), body.index, body.generation); }

template <class Vector>
Vector support(const void* user, Vector direction) {
  Vector point{};
  graze_js_call_support(key_of(user), &direction, &point);
  return point;
}

void release(void* user) { graze_js_call_release(key_of(user)); }

}  // namespace

extern "C" {

GRAZE_JS_EXPORT("graze_js_allow") void* graze_js_allow() { return reinterpret_cast<void*>(&allow); }

GRAZE_JS_EXPORT("graze_js_accept") void* graze_js_accept() { return reinterpret_cast<void*>(&accept); }

/// Bytes that are allocated.
GRAZE_JS_EXPORT("graze_js_memory_in_use") std::size_t graze_js_memory_in_use() {
  return static_cast<std::size_t>(mallinfo().uordblks);
}

#ifdef GRAZE_JS_DOUBLE
GRAZE_JS_EXPORT("graze_js_user_convex_d") GrazeStatus graze_js_user_convex_d(void* key, GrazeShaped** shape) {
  return graze_shape_user_d(&support<GrazeVec3d>, &release, key, shape);
}
#else
GRAZE_JS_EXPORT("graze_js_user_convex_f") GrazeStatus graze_js_user_convex_f(void* key, GrazeShapef** shape) {
  return graze_shape_user_f(&support<GrazeVec3f>, &release, key, shape);
}
#endif

}  // extern "C"
