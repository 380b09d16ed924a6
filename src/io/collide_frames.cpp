#include "graze/io/collide_frames.hpp"

#include <algorithm>
#include <cmath>

#include "io/collider_motion.hpp"
#include "io/scene_world.hpp"

namespace graze::io {

namespace {

/// The rounding of times in files, which are floats: an animation of 0.7 s ends at 0.69999999, and has a frame at 0.7
/// s.
constexpr double float_rounding = 1.2e-7;

const Animation& animation_of(const Scene& scene, std::size_t index) {
  if (scene.animations.empty()) throw InvalidValue(scene.source, "at least one animation", "no animation");
  if (index >= scene.animations.size())
    throw InvalidValue("animation", "an index below " + std::to_string(scene.animations.size()), std::to_string(index));
  const Animation& animation = scene.animations[index];
  if (!animation.tracks) throw InvalidValue("animation", "one that a loader has read", "an empty one");
  return animation;
}

/// The depth of the pair's deepest point.
template <class T>
std::optional<double> depth_of(const ContactArrays<T>& contacts, const ContactPair<T>& pair) {
  std::optional<double> depth;
  for (const ContactManifold<T>& m : contacts.manifolds_of(pair))
    for (const SolverPoint<T>& p : contacts.points_of(m))
      depth = std::max(depth.value_or(0), -static_cast<double>(p.distance));
  return depth;
}

/// A world that is filled from a scene and follows an animation.
template <class T>
class Player {
 public:
  Player(const Scene& scene, const FrameOptions& options)
      : scene_(scene), motion_(scene, animation_of(scene, options.animation)), world_(settings(options)) {
    std::vector<char> animated(scene.colliders.size(), 0);
    for (const MovedCollider& m : motion_.colliders()) animated[m.index] = 1;
    for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
      const Collider& c = scene.colliders[i];
      auto body = in_world<T>(scene, c, !animated[i] && scene.bodies[c.body].type == MotionType::fixed);
      body.trigger = c.trigger;
      filters_.push_back(body.filter);
      ids_.push_back(world_.add(std::move(body)));
    }
  }

  /// The events at a time, which is not before the last.
  std::span<const FrameEvent> go_to(double t) {
    motion_.go_to(t);
    for (const MovedCollider& m : motion_.colliders()) follow(m, t);
    world_.update();
    events_.clear();
    touching_ = 0;
    for (const ContactEvent& e : world_.events()) {
      touching_ += e.kind != EventKind::end;
      if (e.kind == EventKind::begin)
        events_.push_back(
            {true, e.a.index, e.b.index, e.trigger, depth_of(world_.contacts(), world_.contacts().pairs[e.pair])});
      if (e.kind == EventKind::end) events_.push_back({false, e.a.index, e.b.index, e.trigger, {}});
    }
    return events_;
  }
  std::size_t touching() const { return touching_; }

 private:
  static WorldSettings<T> settings(const FrameOptions& options) {
    WorldSettings<T> settings;
    if (options.margin) settings.margin = checked_margin<T>(*options.margin);
    return settings;
  }

  void follow(const MovedCollider& m, double t) {
    try {
      // A collider that is hidden keeps its place and collides with none.
      world_.set_filter(ids_[m.index], m.shown ? filters_[m.index] : Filter{0, 0, 0});
      if (!m.shown) return;
      if (m.reshaped) world_.set_shape(ids_[m.index], in_precision<T>(m.shape));
      const Pose<T> pose = converted<T>(m.pose);
      check_pose(pose);
      world_.move(ids_[m.index], pose);
    } catch (const InvalidValue& e) {
      throw e.below(scene_.source + ": " + scene_.colliders[m.index].name + " (at " + validate::number(t) + " s)");
    }
  }

  const Scene& scene_;
  ColliderMotion motion_;
  World<T> world_;
  std::vector<BodyId> ids_;
  std::vector<Filter> filters_;
  std::vector<FrameEvent> events_;
  std::size_t touching_ = 0;
};

template <class T>
void play(const Scene& scene, const FrameOptions& options, const std::function<void(const Frame&)>& each) {
  const std::size_t count = frame_count(scene, options);
  Player<T> player(scene, options);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / options.fps;
    const auto events = player.go_to(t);
    each({i, count, t, player.touching(), events});
  }
}

}  // namespace

std::size_t find_animation(const Scene& scene, const std::string& name_or_index) {
  if (scene.animations.empty()) throw InvalidValue(scene.source, "at least one animation", "no animation");
  std::string names;
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    if (scene.animations[i].name == name_or_index) return i;
    if (i < 10) names += (i > 0 ? ", " : "") + scene.animations[i].name;
  }
  const bool digits =
      !name_or_index.empty() && name_or_index.size() < 10 &&
      std::all_of(name_or_index.begin(), name_or_index.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (digits && std::stoul(name_or_index) < scene.animations.size()) return std::stoul(name_or_index);
  throw InvalidValue(
      "animation", "the name of one or an index below " + std::to_string(scene.animations.size()) + " (" + names + ")",
      name_or_index);
}

std::size_t frame_count(const Scene& scene, const FrameOptions& options) {
  const Animation& animation = animation_of(scene, options.animation);
  if (!(options.fps > 0) || !std::isfinite(options.fps)) validate::fail("fps", "a finite number above 0", options.fps);
  const double duration = options.duration.value_or(animation.duration);
  if (!(duration >= 0) || !std::isfinite(duration)) validate::fail("duration", "a finite number >= 0", duration);
  const double last = std::floor(duration * options.fps * (1 + float_rounding));
  if (!(last < max_frames))
    throw InvalidValue("fps", "at most " + validate::number(max_frames) + " frames in all",
                       validate::number(options.fps) + " a second for " + validate::number(duration) + " s");
  return static_cast<std::size_t>(last) + 1;
}

std::vector<std::uint32_t> animated_colliders(const Scene& scene, std::size_t animation) {
  const ColliderMotion motion(scene, animation_of(scene, animation));
  std::vector<std::uint32_t> indices;
  for (const MovedCollider& m : motion.colliders()) indices.push_back(m.index);
  return indices;
}

void collide_frames(const Scene& scene, const FrameOptions& options, const std::function<void(const Frame&)>& each) {
  if (options.precision == Precision::double_precision)
    play<double>(scene, options, each);
  else
    play<float>(scene, options, each);
}

}  // namespace graze::io
