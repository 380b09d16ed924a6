// Collision detection during an animation: contacts that begin and end, frame by frame.
//
// Guarantee: the answer is a function of the scene and the options alone; for two colliders `begin` and `end` take
// turns, `begin` first. Frames are tested one by one: contacts between two of them are not seen. Pairs are left out as
// `collide` leaves them out, where colliders that the animation moves count as movable.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// Largest number of frames.
inline constexpr double max_frames = 1e7;

/// Options of `collide_frames`.
struct FrameOptions {
  std::size_t animation = 0;  ///< an index into `Scene::animations`
  double fps = 30;            ///< frames per second, above 0; the first is at 0 s
  /// Seconds, >= 0; by default the animation's length. Beyond that everything stays at its last keyframe.
  std::optional<double> duration;
  /// Gap up to which colliders that have touched stay in touch; by default `contact_margin`, about a hundredth of their
  /// size. Triggers have none.
  std::optional<double> margin;
  Precision precision = Precision::double_precision;  ///< scalar of the computation
};

/// The beginning or the end of a contact of two colliders.
struct FrameEvent {
  bool begin;                   ///< true where they begin to touch, false where they end
  std::uint32_t a, b;           ///< indices of colliders, a < b
  bool trigger;                 ///< one of them is a trigger
  std::optional<double> depth;  ///< >= 0, of the deepest point, at the `begin` of a pair without a trigger; else
                                ///< nothing
};

/// The contacts of one frame.
struct Frame {
  std::size_t index, count;            ///< number of this frame, and of all frames
  double time;                         ///< seconds: index / fps
  std::size_t pairs;                   ///< number of touching pairs
  std::span<const FrameEvent> events;  ///< sorted by colliders; valid until the next frame
};

/// The index of an animation: the first with that name, or the one with that index. Throws `InvalidValue` when there is
/// none.
GRAZE_API std::size_t find_animation(const Scene& scene, const std::string& name_or_index);

/// The number of frames that `collide_frames` plays. Throws `InvalidValue` as it does, without playing any.
GRAZE_API std::size_t frame_count(const Scene& scene, const FrameOptions& options);

/// The colliders that the animation moves, by index. Throws `InvalidValue` without such an animation.
GRAZE_API std::vector<std::uint32_t> animated_colliders(const Scene& scene, std::size_t animation);

/// Plays an animation and calls `each` for every frame. A collider touches nothing while it is scaled to zero. Throws
/// `InvalidValue` for a scene without animations, options out of range, and for poses and shapes that get too large on
/// the way.
GRAZE_API void collide_frames(const Scene& scene, const FrameOptions& options,
                              const std::function<void(const Frame&)>& each);

}  // namespace graze::io
