// The motion of a scene's colliders and bodies by an animation.
//
// Guarantee: at every time a pose of finite numbers for each collider and body that is moved, and a new shape only
// where its scale has changed by more than files hold; at rest, shapes and poses are those of the scene up to rounding.
#pragma once

#include <span>
#include <vector>

#include "graze/io/scene.hpp"
#include "io/gltf_animation.hpp"

namespace graze::io {

/// A collider on its way.
struct MovedCollider {
  std::uint32_t index;    ///< in the scene
  bool shown = true;      ///< false while it is scaled to nothing, as glTF hides things
  bool reshaped = false;  ///< it has another shape than at the time before
  Posed pose;
  Shaped shape;
};

/// A body whose node is on its way.
struct MovedBody {
  std::uint32_t index;  ///< in the scene
  Posed pose;           ///< of its node; the last one before while that is scaled to nothing
};

class ColliderMotion {
 public:
  /// Throws `InvalidValue` for a scene that has lost colliders or bodies since it was loaded.
  ColliderMotion(const Scene& scene, const Animation& animation);

  /// The colliders that are moved, by index.
  std::span<const MovedCollider> colliders() const { return moved_; }
  /// The bodies whose nodes are moved, by index.
  std::span<const MovedBody> bodies() const { return bodies_; }
  /// Moves the colliders and bodies to a time in seconds. Costs a few products a node, and a shape where the scale
  /// changes: microseconds for a ball or box, as much as loading it for a mesh, milliseconds for a shape that becomes a
  /// sampled hull. Throws `InvalidValue` for a collider that gets too large.
  void go_to(double t);

 private:
  /// A node on the way to some collider; parents come first.
  struct Step {
    std::size_t node;
    std::ptrdiff_t parent;  ///< its place among the steps
    bool animated;          ///< by a channel of its own
    std::size_t first_channel, end_channel;
    Affine world{};
  };
  /// The parts of which a shape was made.
  struct Made {
    std::size_t step;
    Shaped base;
    Affine map;
    Quatd rotation;  ///< of the pose, under that map
  };

  std::vector<char> moving_nodes() const;
  void add_steps(const std::vector<char>& moves);
  void place(std::size_t i, double t);
  void place_body(std::size_t i, double t);
  /// The node of a step at a time, for errors.
  std::string path(std::size_t step, double t) const;
  void check_in_range(std::size_t step, double t) const;

  std::shared_ptr<const AnimationTracks> tracks_;
  std::vector<const Channel*> channels_;  ///< by node
  std::vector<Step> steps_;
  std::vector<MovedCollider> moved_;
  std::vector<Made> made_;
  std::vector<MovedBody> bodies_;
  std::vector<std::size_t> steps_of_bodies_;
};

}  // namespace graze::io
