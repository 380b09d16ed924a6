// Any bytes as a scene of the plane, JSON if they begin with a brace and SVG otherwise: refused as `InvalidValue`, or
// collided, drawn, and written as JSON that is read as the same bodies and colliders.
#include <cstdint>
#include <string>

#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"

namespace {

using graze::io::PlaneScene;

void require(bool holds) {
  if (!holds) __builtin_trap();
}

PlaneScene read(const std::string& text) {
  return text.starts_with('{') ? graze::io::load_plane_json(text, "fuzz.json")
                               : graze::io::load_plane_svg(text, "fuzz.svg");
}

/// Bodies with their motions, and colliders with their filters, in the same order.
void check_same(const PlaneScene& read, const PlaneScene& written) {
  require(read.bodies.size() == written.bodies.size() && read.colliders.size() == written.colliders.size());
  for (std::size_t i = 0; i < read.bodies.size(); ++i)
    require(read.bodies[i].type == written.bodies[i].type && read.bodies[i].motion == written.bodies[i].motion);
  for (std::size_t i = 0; i < read.colliders.size(); ++i) {
    const graze::io::PlaneCollider &a = read.colliders[i], &b = written.colliders[i];
    require(a.body == b.body && a.filter == b.filter && a.trigger == b.trigger);
    require(a.pose.translation == b.pose.translation && a.shape.name() == b.shape.name());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  PlaneScene scene;
  try {
    scene = read({reinterpret_cast<const char*>(bytes), size});
    for (const graze::io::PlaneCollider& c : scene.colliders) require(c.body < scene.bodies.size());
    // Pictures and pairs of few shapes; a file of many takes as long as it takes.
    if (scene.colliders.size() > 32) return 0;
    graze::io::draw_picture(scene, graze::io::collide(scene));
  } catch (const graze::InvalidValue&) {
    return 0;
  }
  check_same(graze::io::load_plane_json(to_json(scene), "written"), scene);
  return 0;
}
