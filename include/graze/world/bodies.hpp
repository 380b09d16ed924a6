// Bodies of a world, in arrays by index.
//
// Guarantee: an index names the same body from its insertion to its removal; a handle whose body was removed is
// refused, also when the index is in use again. Insertion, removal and look-up take constant time.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graze/detail/validate.hpp"
#include "graze/filter.hpp"
#include "graze/world/space.hpp"

namespace graze {

/// A handle: the index of a body in all arrays, and how often the index was given away before.
struct BodyId {
  /// The slot, and how often the slot was given away before.
  std::uint32_t index = ~std::uint32_t{0}, generation = 0;

  friend constexpr bool operator==(const BodyId&, const BodyId&) = default;
  friend constexpr auto operator<=>(const BodyId&, const BodyId&) = default;
};

/// Throws `InvalidValue` for a handle of something that is not there, or not any more: `path` is its place in the call,
/// `expected` what it should name, as "a body of the world".
template <class Id>
[[noreturn]] void refuse_missing(const std::string& path, const char* expected, const Id& id) {
  validate::fail(path, expected,
                 std::to_string(id.index) + " of generation " + std::to_string(id.generation) + ", which is not there");
}

/// Description of a body to be added.
template <class T, class Space = graze::Space<T>>
struct Body {
  typename Space::Shape shape;        ///< shape in the body's frame
  typename Space::Pose pose{};        ///< pose in the world
  typename Space::Vec linear{};       ///< velocity of the pose's origin
  typename Space::Turning angular{};  ///< angular velocity about the origin, in world space
  Filter filter{};                    ///< category and mask of collisions
  bool fixed = false;                 ///< never moves by itself: two fixed bodies are no pair
  bool trigger = false;               ///< only reports overlaps; has no contact points
  bool fast = false;                  ///< is tested for what it would pass through before the next update
};

/// The bodies of a world, an array for each attribute. At indices that are not `alive` the values are meaningless.
template <class T, class Space = graze::Space<T>>
class GRAZE_API BodyArrays {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Shape = typename Space::Shape;

 public:
  /// With `margin` contacts begin that far from every body, without it at each body's own `contact_margin`. Throws
  /// `InvalidValue` for a margin that is negative, not finite or larger than `largest_magnitude`.
  explicit BodyArrays(std::optional<T> margin = {}) : margin_(margin) {
    if (margin) validate::extent(*margin, "margin");
  }

  /// Makes room for this number of bodies, and no more than that.
  void reserve(std::size_t bodies);
  /// Adds a body, whose rotation is turned to unit length. Throws `InvalidValue` for a pose or velocity that is not
  /// finite or larger than `largest_magnitude`.
  BodyId add(Body<T, Space> body);
  /// Removes a body. This and the setters below throw `InvalidValue` for a handle whose body is gone.
  void remove(BodyId id);
  /// Puts a body elsewhere; its velocities stay as they are.
  void move(BodyId id, const Pose& pose);
  /// Puts a body elsewhere, with new velocities.
  void move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular);
  /// Puts many bodies elsewhere, one after the other: each of `ids` to the pose of the same place, with the velocities
  /// there. Without `linear` and `angular`, both empty, velocities stay as they are. Throws `InvalidValue` for handles,
  /// poses and velocities that `move` of one refuses, and for spans of other lengths than `ids`; nothing moves then.
  void move(std::span<const BodyId> ids, std::span<const Pose> poses, std::span<const Vec> linear = {},
            std::span<const Turning> angular = {});
  void set_shape(BodyId id, Shape shape);            ///< replaces the shape
  void set_filter(BodyId id, const Filter& filter);  ///< replaces the filter
  void set_fast(BodyId id, bool fast);               ///< sets whether it may pass through something within an update
  Body<T, Space> body(BodyId id) const;              ///< the body as it is now

  /// Whether the handle's body exists.
  bool contains(BodyId id) const {
    return id.index < generations_.size() && alive_[id.index] != 0 && generations_[id.index] == id.generation;
  }
  /// The handle of the body at this index.
  BodyId id(std::uint32_t index) const { return {index, generations_[index]}; }
  /// The number of bodies; `size` counts indices.
  std::size_t count() const { return shapes_.size() - free_.size(); }
  std::size_t size() const { return shapes_.size(); }

  /// Shapes, by index.
  std::span<const Shape> shapes() const { return shapes_; }
  /// Poses, by index.
  std::span<const Pose> poses() const { return poses_; }
  /// Velocities of the origins, by index.
  std::span<const Vec> linear() const { return linear_; }
  /// Angular velocities, by index.
  std::span<const Turning> angular() const { return angular_; }
  /// Filters, by index.
  std::span<const Filter> filters() const { return filters_; }
  /// Whether any body was ever given a filter: without, all may collide.
  bool filtered() const { return filtered_; }
  /// By index: whether a body is there.
  std::span<const std::uint8_t> alive() const { return alive_; }
  /// By index: whether the body never moves.
  std::span<const std::uint8_t> fixed() const { return fixed_; }
  /// By index: whether the body is a trigger, which only reports overlaps.
  std::span<const std::uint8_t> triggers() const { return triggers_; }
  /// By index: whether the body may pass through something within an update.
  std::span<const std::uint8_t> fast() const { return fast_; }
  /// By index: the distance at which contacts of the body begin; in a pair the smaller counts. Infinite for a
  /// half-space, which has no size.
  std::span<const T> margins() const { return margins_; }
  /// The margin of a body with this shape, in a world of the given margin or of none.
  static T margin_of(const Shape& shape, const std::optional<T>& margin);

  /// By index: whether the body was added, removed, moved or given another shape since `settle`.
  std::span<const std::uint8_t> changed() const { return changed_; }
  std::span<const std::uint32_t> changes();  ///< the indices of `changed` bodies, sorted
  /// The indices of `changed` bodies, in the order in which they changed.
  std::span<const std::uint32_t> unsorted_changes() const { return changes_; }
  void settle();  ///< resets `changed`
  /// A number that grows with every change.
  std::uint64_t revision() const { return revision_; }

  std::size_t memory() const;

 private:
  std::uint32_t checked(BodyId id) const;
  void change(std::uint32_t index);
  void put(std::uint32_t index, const Pose& pose);

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
