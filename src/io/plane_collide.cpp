#include "graze/io/plane_scene.hpp"
#include "io/scene_collide.hpp"

namespace graze::io {

std::vector<TouchingPair> collide(const PlaneScene& scene, const CollideOptions& options) {
  return options.precision == Precision::double_precision ? collide_in<double, plane::Space<double>>(scene, options)
                                                          : collide_in<float, plane::Space<float>>(scene, options);
}

}  // namespace graze::io
