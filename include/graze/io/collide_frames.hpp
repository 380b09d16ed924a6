// What touches while an animation plays: frame by frame, who begins to touch and who ends.
//
// Guarantee: the answer is a function of the scene and the options alone; for two colliders `begin` and `end` take
// turns, `begin` first. Frames are looked at one by one: what happens between two of them is not seen. Pairs are left
// out as `collide` leaves them out, where whatever the animation moves can move.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// How many frames are played at most.
inline constexpr double max_frames = 1e7;

/// What may be told.
struct FrameOptions {
  std::size_t animation = 0;  ///< an index into `Scene::animations`
  double fps = 30;            ///< frames a second, above 0; the first is at 0 s
  /// Seconds, >= 0; without it as long as the animation. What goes on longer stays where the last keyframe put it.
  std::optional<double> duration;
  /// Colliders that touch go on until they are further apart than this; by default a thousandth of their size or so
  /// (`contact_margin`). Triggers have none.
  std::optional<double> margin;
  Precision precision = Precision::double_precision;  ///< in which scalar it is computed
};

/// Two colliders begin to touch, or no longer do.
struct FrameEvent {
  bool begin;                   ///< whether they begin to touch, or end
  std::uint32_t a, b;           ///< indices of colliders, a < b
  bool trigger;                 ///< one of them is a trigger
  std::optional<double> depth;  ///< >= 0, of the deepest point at a `begin`; nothing for a trigger, which has no points
};

/// What touches in one frame.
struct Frame {
  std::size_t index, count;            ///< this one, and how many there will be
  double time;                         ///< seconds: index / fps
  std::size_t pairs;                   ///< how many pairs touch
  std::span<const FrameEvent> events;  ///< by colliders; valid until the next frame
};

/// The animation of that name (the first), or of that index. Throws `InvalidValue` when there is none.
GRAZE_API std::size_t find_animation(const Scene& scene, const std::string& name_or_index);

/// How many frames are played. Throws `InvalidValue` as `collide_frames` does, before anything is.
GRAZE_API std::size_t frame_count(const Scene& scene, const FrameOptions& options);

/// Which colliders the animation moves, by index. Throws `InvalidValue` without such an animation.
GRAZE_API std::vector<std::uint32_t> animated_colliders(const Scene& scene, std::size_t animation);

/// Plays an animation and calls `each` for every frame. A collider that is scaled to nothing touches nothing while it
/// is. Throws `InvalidValue` for a scene without animations, options out of range, and for what gets too large on the
/// way.
GRAZE_API void collide_frames(const Scene& scene, const FrameOptions& options,
                              const std::function<void(const Frame&)>& each);

}  // namespace graze::io
