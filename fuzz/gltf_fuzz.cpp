// Any bytes as a scene: it loads, or is refused by an error that names the place; what loads can be collided, and its
// animation played.
#include <cstdint>
#include <string>

#include "graze/io/collide.hpp"
#include "graze/io/collide_frames.hpp"

namespace {

/// Five frames over the whole animation. Few colliders, as each may become a sampled hull in every frame.
void play(const graze::io::Scene& scene) {
  if (scene.animations.empty() || scene.colliders.size() > 8) return;
  graze::io::FrameOptions options;
  const double duration = scene.animations[0].duration;
  options.fps = duration > 0 ? 4 / duration : 1;
  std::size_t last = 0;
  graze::io::collide_frames(scene, options, [&](const graze::io::Frame& f) {
    std::size_t begun = 0, ended = 0;
    for (const auto& e : f.events) {
      if (e.b >= scene.colliders.size() || e.a >= e.b || (e.depth && !(*e.depth >= 0))) __builtin_trap();
      ++(e.begin ? begun : ended);
    }
    if (last + begun != f.pairs + ended) __builtin_trap();
    last = f.pairs;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    graze::io::LoadOptions options;
    options.animations = true;
    const graze::io::Scene scene = graze::io::load_gltf({reinterpret_cast<const char*>(bytes), size}, "fuzz", options);
    for (const auto& collider : scene.colliders)
      if (collider.body >= scene.bodies.size()) __builtin_trap();
    if (scene.colliders.size() < 50) graze::io::collide(scene);
    play(scene);
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
