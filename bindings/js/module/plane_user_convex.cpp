// A convex shape of the plane whose support function is JavaScript's: `user` is its number in JavaScript.
#include <cstdint>

#include "graze/graze.h"
#include "scalar.hpp"

extern "C" {

__attribute__((import_module("graze"), import_name("planeSupport"))) void
graze_js_call_plane_support(std::uintptr_t key, const void* direction, void* point);
__attribute__((import_module("graze"), import_name("release"))) void graze_js_release_plane_support(std::uintptr_t key);

}  // extern "C"

namespace {

std::uintptr_t key_of(const void* user) { return reinterpret_cast<std::uintptr_t>(user); }

TYPE(Vec2) support(const void* user, TYPE(Vec2) direction) {
  TYPE(Vec2) point{};
  graze_js_call_plane_support(key_of(user), &direction, &point);
  return point;
}

void release(void* user) { graze_js_release_plane_support(key_of(user)); }

}  // namespace

extern "C" EXPORTED("plane_user_convex") GrazeStatus graze_js_plane_user_convex(void* key, TYPE(PlaneShape) * *shape) {
#ifdef GRAZE_JS_DOUBLE
  return graze_plane_shape_user_d(&support, &release, key, shape);
#else
  return graze_plane_shape_user_f(&support, &release, key, shape);
#endif
}
