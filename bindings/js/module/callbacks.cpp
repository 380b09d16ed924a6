// Functions of JavaScript behind the C interface's callbacks: `user` is the number of the function in JavaScript.
#include <malloc.h>

#include <algorithm>
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
/// Draws one place, or two of a line, or three of a triangle; of three numbers each.
GRAZE_JS_IMPORT("draw")
void graze_js_call_draw(std::uintptr_t key, const double* places, int count, int layer, int meaning);
GRAZE_JS_IMPORT("arrow")
void graze_js_call_arrow(std::uintptr_t key, const double* from, const double* direction, int layer, int meaning);
GRAZE_JS_IMPORT("text")
void graze_js_call_text(std::uintptr_t key, const double* at, const char* words, int layer, int meaning);
GRAZE_JS_IMPORT("frame")
void graze_js_call_frame(std::uintptr_t key, std::size_t frame, const void* world, const void* plane_world);
GRAZE_JS_IMPORT("write") bool graze_js_call_write(std::uintptr_t key, const void* bytes, std::size_t size);

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

void frame(void* user, std::size_t number, const void* world, const void* plane_world) {
  graze_js_call_frame(key_of(user), number, world, plane_world);
}

bool write(void* user, const void* bytes, std::size_t size) { return graze_js_call_write(key_of(user), bytes, size); }

/// Passes places on, one behind the other.
template <class... Places>
void hand_on(void* user, GrazeDrawLayer layer, GrazeDrawMeaning meaning, Places... places) {
  double all[3 * sizeof...(places)];
  double* next = all;
  ((next = std::copy(places, places + 3, next)), ...);
  graze_js_call_draw(key_of(user), all, sizeof...(places), layer, meaning);
}

void point(void* user, const double at[3], GrazeDrawLayer layer, GrazeDrawMeaning meaning) {
  hand_on(user, layer, meaning, at);
}
void line(void* user, const double from[3], const double to[3], GrazeDrawLayer layer, GrazeDrawMeaning meaning) {
  hand_on(user, layer, meaning, from, to);
}
void arrow(void* user, const double from[3], const double direction[3], GrazeDrawLayer layer,
           GrazeDrawMeaning meaning) {
  graze_js_call_arrow(key_of(user), from, direction, layer, meaning);
}
void triangle(void* user, const double a[3], const double b[3], const double c[3], GrazeDrawLayer layer,
              GrazeDrawMeaning meaning) {
  hand_on(user, layer, meaning, a, b, c);
}
void text(void* user, const double at[3], const char* words, GrazeDrawLayer layer, GrazeDrawMeaning meaning) {
  graze_js_call_text(key_of(user), at, words, layer, meaning);
}

}  // namespace

extern "C" {

GRAZE_JS_EXPORT("graze_js_allow") void* graze_js_allow() { return reinterpret_cast<void*>(&allow); }

GRAZE_JS_EXPORT("graze_js_accept") void* graze_js_accept() { return reinterpret_cast<void*>(&accept); }

GRAZE_JS_EXPORT("graze_js_frame") void* graze_js_frame() { return reinterpret_cast<void*>(&frame); }

GRAZE_JS_EXPORT("graze_js_write") void* graze_js_write() { return reinterpret_cast<void*>(&write); }

/// Makes a renderer call the functions of JavaScript with that number; `arrows`: whether there is one for arrows.
GRAZE_JS_EXPORT("graze_js_debug_draw") void graze_js_debug_draw(GrazeDebugDraw* on, std::uintptr_t key, bool arrows) {
  on->user = reinterpret_cast<void*>(key);
  on->point = &point;
  on->line = &line;
  on->triangle = &triangle;
  on->text = &text;
  if (arrows) on->arrow = &arrow;
}

/// The number of bytes that are allocated.
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
