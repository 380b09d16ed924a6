// Bodies: what stands in a world, in arrays by index.
//
// Guarantee: an index names the same body from its insertion to its removal; a handle whose body was removed is
// refused, also when the index is in use again. Insertion, removal and look-up take constant time.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "graze/filter.hpp"
#include "graze/validate.hpp"
#include "graze/world/space.hpp"

namespace graze {

/// A handle: the index of a body in all arrays, and how often the index was given away before.
struct BodyId {
  /// Which place, and which of the bodies or joints that had it.
  std::uint32_t index = ~std::uint32_t{0}, generation = 0;

  friend constexpr bool operator==(const BodyId&, const BodyId&) = default;
  friend constexpr auto operator<=>(const BodyId&, const BodyId&) = default;
};

/// What is said of a body when it is added.
template <class T, class Space = graze::Space<T>>
struct Body {
  typename Space::Shape shape;        ///< what it is
  typename Space::Pose pose{};        ///< where it stands
  typename Space::Vec linear{};       ///< velocity of the pose's origin
  typename Space::Turning angular{};  ///< the turning about it, in world space
  Filter filter{};                    ///< what it may meet
  bool fixed = false;                 ///< never moves by itself: two fixed bodies are no pair
  bool trigger = false;               ///< tells that something is inside it; has no contact points
  bool fast = false;                  ///< is asked what it would pass through before the next update
};

/// The bodies of a world, an array for each of their parts. At indices that are not `alive` the rest means nothing.
template <class T, class Space = graze::Space<T>>
class GRAZE_API BodyArrays {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Shape = typename Space::Shape;

 public:
  /// With `margin` contacts begin that far from every body, without it at each one's `contact_margin`.
  /// Throws `InvalidValue` for a margin that is negative, not finite or larger than `largest_magnitude`.
  explicit BodyArrays(std::optional<T> margin = {}) : margin_(margin) {
    if (margin) validate::extent(*margin, "margin");
  }

  /// Makes room for so many bodies, and no more than that.
  void reserve(std::size_t bodies);
  /// Throws `InvalidValue` for a pose or velocity that is not finite or larger than `largest_magnitude`; turns the
  /// rotation to unit length.
  BodyId add(Body<T, Space> body);
  /// These throw `InvalidValue` for a handle whose body is gone.
  void remove(BodyId id);
  /// The velocities stay what they are where none are given.
  void move(BodyId id, const Pose& pose);
  /// Puts it there, with the velocities that it has there.
  void move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular);
  void set_shape(BodyId id, Shape shape);            ///< another shape
  void set_filter(BodyId id, const Filter& filter);  ///< another filter
  void set_fast(BodyId id, bool fast);               ///< whether it may pass through something within an update
  Body<T, Space> body(BodyId id) const;              ///< as it is now

  /// Whether the body is still there.
  bool contains(BodyId id) const {
    return id.index < generations_.size() && alive_[id.index] != 0 && generations_[id.index] == id.generation;
  }
  /// Of the body that has this index.
  BodyId id(std::uint32_t index) const { return {index, generations_[index]}; }
  /// How many bodies there are, and how many indices.
  std::size_t count() const { return shapes_.size() - free_.size(); }
  std::size_t size() const { return shapes_.size(); }

  /// By index.
  std::span<const Shape> shapes() const { return shapes_; }
  /// By index.
  std::span<const Pose> poses() const { return poses_; }
  /// Velocities of the origins, by index.
  std::span<const Vec> linear() const { return linear_; }
  /// Angular velocities, by index.
  std::span<const Turning> angular() const { return angular_; }
  /// By index.
  std::span<const Filter> filters() const { return filters_; }
  /// Whether any was ever given a filter of its own: without, all may collide.
  bool filtered() const { return filtered_; }
  /// By index: whether a body has it.
  std::span<const std::uint8_t> alive() const { return alive_; }
  /// By index: whether it never moves.
  std::span<const std::uint8_t> fixed() const { return fixed_; }
  /// By index: whether it only tells of overlaps.
  std::span<const std::uint8_t> triggers() const { return triggers_; }
  /// By index: whether it may pass through something within an update.
  std::span<const std::uint8_t> fast() const { return fast_; }
  /// How far from each body its contacts begin; of two bodies the smaller counts. Infinite of a half-space, which has
  /// no size.
  std::span<const T> margins() const { return margins_; }
  /// That of a body with this shape, in a world of this margin or of none.
  static T margin_of(const Shape& shape, const std::optional<T>& margin);

  /// What was added, removed, moved or given another shape since `settle`: one byte an index, and the indices sorted.
  std::span<const std::uint8_t> changed() const { return changed_; }
  std::span<const std::uint32_t> changes();  ///< the indices of what is `changed`, sorted
  /// The same in the order in which they came.
  std::span<const std::uint32_t> unsorted_changes() const { return changes_; }
  void settle();  ///< nothing counts as changed from here on
  /// Grows with every change.
  std::uint64_t revision() const { return revision_; }

  std::size_t memory() const;

 private:
  std::uint32_t checked(BodyId id) const;
  void change(std::uint32_t index);

  std::optional<T> margin_;
  std::vector<Shape> shapes_;
  std::vector<Pose> poses_;
  std::vector<Vec> linear_;
  std::vector<Turning> angular_;
  std::vector<Filter> filters_;
  std::vector<T> margins_;
  std::vector<std::uint8_t> alive_, fixed_, triggers_, fast_, changed_;
  std::vector<std::uint32_t> generations_, free_, changes_;
  std::uint64_t revision_ = 0;
  bool filtered_ = false;
};

}  // namespace graze
