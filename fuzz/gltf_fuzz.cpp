// Any bytes as a scene: it loads, or is refused by an error that names the place; what loads can be collided.
#include <cstdint>
#include <string>

#include "graze/io/collide.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const graze::io::Scene scene = graze::io::load_gltf({reinterpret_cast<const char*>(bytes), size}, "fuzz");
    for (const auto& collider : scene.colliders)
      if (collider.body >= scene.bodies.size()) __builtin_trap();
    if (scene.colliders.size() < 50) graze::io::collide(scene);
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
