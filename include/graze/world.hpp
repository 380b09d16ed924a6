// A world: bodies that are added, moved and removed, and their contacts from update to update.
//
//     poses -> bounds -> candidate pairs -> filter -> bins by pair type -> manifolds -> begin, stay, end
//
// Guarantee: the result of an update is a function of the calls made so far alone: the same bits for any executor and
// any number of threads. Nothing is dropped: arrays grow. Each stage has a header of its own under `graze/world/`,
// reads plain arrays and leaves one, and can be used without the others.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>

#include "graze/world/bodies.hpp"
#include "graze/world/bounds.hpp"
#include "graze/world/candidates.hpp"
#include "graze/world/events.hpp"
#include "graze/world/impacts.hpp"
#include "graze/world/manifolds.hpp"
#include "graze/world/queries.hpp"

namespace graze {

/// Settings of a world.
template <class T>
struct WorldSettings {
  /// Distance up to which contacts are reported; by default `contact_margin` of the two shapes.
  std::optional<T> margin = std::nullopt;
  /// Final decision on a pair that its filters allow. Called from the thread that calls `update`, but for fast bodies
  /// from the executor's.
  std::function<bool(BodyId, BodyId)> allow = nullptr;
  /// Largest number of contact points of a pair of bodies, which bounds the work of a solver: the points that `reduce`
  /// of its manifolds keeps. Impulses are carried over to the points that are kept again in the next update. By default
  /// a pair keeps all of its points; with 0 none, and the world knows only what touches. Costs so many times the points
  /// of a pair that has more.
  std::optional<std::size_t> points_per_pair = std::nullopt;
};

/// Bodies in place, and their contacts.
template <class T, class Space = graze::Space<T>>
class GRAZE_API World {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Shape = typename Space::Shape;
  using Ray = typename Space::Ray;
  using BackFaces = typename Space::BackFaces;
  using Velocity = typename Space::Velocity;

 public:
  /// Throws `InvalidValue` for a margin that is negative, not finite or larger than `largest_magnitude`.
  explicit World(WorldSettings<T> settings = {}, Executor* executor = nullptr)
      : settings_(std::move(settings)),
        executor_(executor ? executor : &serial_),
        bodies_(settings_.margin),
        manifolds_(settings_.points_per_pair.value_or(ManifoldFinder<T, Space>::all_points)) {}
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Adds a body. Throws `InvalidValue` for a pose or velocity that is not finite or larger than `largest_magnitude`.
  BodyId add(Body<T, Space> body) { return bodies_.add(std::move(body)); }
  /// Removes a body. This and the setters below throw `InvalidValue` for a handle whose body was removed, and for
  /// values that `add` refuses.
  void remove(BodyId id) { bodies_.remove(id); }
  /// Puts a body elsewhere; its velocities stay as they are.
  void move(BodyId id, const Pose& pose) { bodies_.move(id, pose); }
  /// Puts a body elsewhere with other velocities, linear and angular in world axes.
  void move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular) {
    bodies_.move(id, pose, linear, angular);
  }
  /// Puts many bodies elsewhere at once, each of `ids` to the pose of the same place; with the velocities there, or as
  /// they are without `linear` and `angular`. Throws `InvalidValue` for what `move` of one refuses and for spans of
  /// other lengths than `ids`; nothing moves then.
  void move(std::span<const BodyId> ids, std::span<const Pose> poses, std::span<const Vec> linear = {},
            std::span<const Turning> angular = {}) {
    bodies_.move(ids, poses, linear, angular);
  }
  /// Replaces the shape from the next update on.
  void set_shape(BodyId id, Shape shape) { bodies_.set_shape(id, std::move(shape)); }
  /// Replaces the filter from the next update on.
  void set_filter(BodyId id, const Filter& filter) { bodies_.set_filter(id, filter); }
  /// Sets whether the body is fast: tested for bodies that it would pass through.
  void set_fast(BodyId id, bool fast) { bodies_.set_fast(id, fast); }
  /// Replaces the final decision on pairs (`WorldSettings::allow`) from the next update on; null allows all.
  void
  set_allow(std::function<bool(BodyId, BodyId)> allow) {  // NOLINT(performance-unnecessary-value-param): moved from
    settings_.allow = std::move(allow);
  }

  /// All bodies, as arrays by index.
  const BodyArrays<T, Space>& bodies() const { return bodies_; }

  /// Finds the contacts of the present poses; and, given the time to the next update, the bodies that fast ones would
  /// pass through until then. Costs the changes since the last update while these are few, and the casts. Throws
  /// `InvalidValue` for a duration that is negative or not finite.
  void update(T duration = T(0));

  /// Recomputes `impacts` alone: the bodies that fast ones would meet within `duration`, by the velocities that bodies
  /// have now, from the poses of the last update. For solvers, which know velocities only after contacts.
  void find_impacts(T duration);

  /// The contacts of the last update. Solvers write the points' impulses.
  ContactArrays<T, Space>& contacts() { return manifolds_.contacts(); }
  /// The contacts of the last update.
  const ContactArrays<T, Space>& contacts() const { return manifolds_.contacts(); }
  /// The events of the last update: contacts that began, stayed and ended.
  std::span<const ContactEvent> events() const { return tracker_.events(); }
  /// Takes events of an earlier update, with pairs of the last one, in place of the last update's: the next update goes
  /// on from them. `lost` are those whose pairs the last update did not find, as one of the bodies is gone: their ends
  /// are events of the next update. For who goes back to an earlier state.
  void go_back_to(std::span<const ContactEvent> events, std::span<const ContactEvent> lost = {}) {
    tracker_.go_back_to(events, lost);
  }
  /// The events that `go_back_to` took as lost, until the next update.
  std::span<const ContactEvent> lost_events() const { return tracker_.lost(); }
  /// The bodies that fast ones would meet in the duration of the last update or `find_impacts`, in the order of time.
  std::span<const Impact<T, Space>> impacts() const { return impacts_; }

  /// Appends the bodies that touch a shape, by index. A point is a sphere without radius.
  void overlapping(const Shape& shape, const Pose& pose, const QueryFilter& filter, std::vector<BodyId>& out) const;
  /// Whether any body touches a shape: stops at the first.
  bool overlaps_any(const Shape& shape, const Pose& pose, const QueryFilter& filter = {}) const;
  /// Appends the `count` bodies nearest to a shape, among those no further than `limit`, the nearest first; without a
  /// limit on `count`, all of them.
  void nearest(const Shape& shape, const Pose& pose, std::size_t count, T limit, const QueryFilter& filter,
               std::vector<BodyDistance<T, Space>>& out) const;
  /// The body nearest to a shape.
  std::optional<BodyDistance<T, Space>> closest(const Shape& shape, const Pose& pose,
                                                T limit = std::numeric_limits<T>::infinity(),
                                                const QueryFilter& filter = {}) const;

  /// The first body that a ray hits. Rays and back faces as for `graze::raycast`.
  std::optional<BodyRayHit<T, Space>> raycast(const Ray& ray, T length = std::numeric_limits<T>::infinity(),
                                              const QueryFilter& filter = {}, BackFaces back = {}) const;
  /// Whether the ray hits any body.
  bool raycast_any(const Ray& ray, T length = std::numeric_limits<T>::infinity(), const QueryFilter& filter = {},
                   BackFaces back = {}) const;
  /// Appends all bodies that the ray hits, each at its first hit, the nearest first.
  void raycast_all(const Ray& ray, T length, const QueryFilter& filter, std::vector<BodyRayHit<T, Space>>& out,
                   BackFaces back = {}) const;

  /// The first body that a shape meets while it moves for `duration` and the bodies stand still. As `graze::cast`.
  std::optional<BodyCastHit<T, Space>> cast(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration,
                                            const QueryFilter& filter = {}, const CastOptions& options = {}) const;
  /// Appends all bodies that the moving shape meets, each at its first contact, in the order of time.
  void cast_all(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration, const QueryFilter& filter,
                std::vector<BodyCastHit<T, Space>>& out, const CastOptions& options = {}) const;

  /// The tree of the bodies' bounds with their margins, by index, that queries descend; for drawing. Brought up to date
  /// where bodies changed since the last query.
  const DynamicTree<T>& tree() const;

  /// Bytes that are held, without the shapes' own data.
  std::size_t memory() const;

 private:
  std::span<const IdPair> filter(std::span<const IdPair> candidates);
  bool is_pair(std::uint32_t a, std::uint32_t b) const;
  bool is_asked(const QueryFilter& filter, std::uint32_t index) const;
  template <class F>
  void each_hit(const Ray& ray, T length, const QueryFilter& filter, BackFaces back, F&& f) const;
  template <class F>
  void each_met(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration, const QueryFilter& filter,
                const CastOptions& options, F&& f) const;

  static constexpr std::uint64_t no_revision = ~std::uint64_t{0};

  WorldSettings<T> settings_;
  SerialExecutor serial_;
  Executor* executor_;
  BodyArrays<T, Space> bodies_;
  // Queries, too, bring these up to date, one thread at a time.
  mutable std::vector<Aabb<T>> boxes_;
  mutable CandidateFinder<T> candidates_;
  mutable std::mutex mutex_;
  mutable std::atomic<std::uint64_t> tree_revision_ = no_revision;  ///< revision of the bodies that the tree has
  std::vector<IdPair> allowed_;
  ManifoldFinder<T, Space> manifolds_;
  EventTracker tracker_;
  std::vector<Impact<T, Space>> impacts_;
};

using Worldf = World<float>;
using Worldd = World<double>;

}  // namespace graze
