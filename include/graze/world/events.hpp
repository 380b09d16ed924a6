// The last stage of a world: who began to touch, still does, no longer does.
//
// Guarantee: for two bodies `begin` and `end` take turns, `begin` first, and every update between them has one `stay`;
// sorted by the bodies. A function of what touched in each update, so the same for any number of threads.
#pragma once

#include <span>

#include "graze/world/bodies.hpp"
#include "graze/world/manifolds.hpp"
#include "graze/world/refilled.hpp"

namespace graze {

/// What became of a pair.
enum class EventKind : std::uint8_t { begin, stay, end };

/// Two bodies and what became of their touching.
struct ContactEvent {
  static constexpr std::uint32_t no_pair = ~std::uint32_t{0};  ///< in place of a pair that is gone

  EventKind kind;      ///< what became of the pair
  bool trigger;        ///< one of them is a trigger
  BodyId a, b;         ///< a.index < b.index; at `end` they may have been removed
  std::uint32_t pair;  ///< the place among the pairs of the update; `no_pair` at an `end`
};

/// Remembers what touches: all of its events but the ends. Two bodies begin to touch when they overlap (distance <= 0),
/// and go on until nothing of them is within their margin, so that a body that rests on another does not
/// begin and end from frame to frame. Triggers have no margin.
class GRAZE_API EventTracker {
 public:
  /// `pairs` as the manifolds' stage leaves them, sorted.
  template <class T, class Space = graze::Space<T>>
  void update(const BodyArrays<T, Space>& bodies, std::span<const ContactPair<T>> pairs);

  /// Those of the last update.
  std::span<const ContactEvent> events() const { return now_.filled(); }

  /// Bytes that are held.
  std::size_t memory() const { return (now_.capacity() + last_.capacity()) * sizeof(ContactEvent); }

 private:
  Refilled<ContactEvent> now_, last_;
};

}  // namespace graze
