// Any bytes as an SVG scene of the plane: refused as `InvalidValue`, or collided and drawn.
#include <cstdint>
#include <string>

#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  try {
    const graze::io::PlaneScene scene = graze::io::load_plane_svg(text, "fuzz.svg");
    for (const graze::io::PlaneCollider& c : scene.colliders)
      if (c.body >= scene.bodies.size()) __builtin_trap();
    // Pictures and pairs of few shapes; a file of many takes as long as it takes.
    if (scene.colliders.size() <= 32) graze::io::draw_picture(scene, graze::io::collide(scene));
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
