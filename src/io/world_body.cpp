#include "graze/io/world_body.hpp"

#include "io/scene_world.hpp"

namespace graze::io {

template <class T>
graze::Body<T> world_body(const Scene& scene, const Collider& collider, bool fixed) {
  return in_world<T>(scene, collider, fixed);
}

template graze::Body<float> world_body(const Scene&, const Collider&, bool);
template graze::Body<double> world_body(const Scene&, const Collider&, bool);

}  // namespace graze::io
