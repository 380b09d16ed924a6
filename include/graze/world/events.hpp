// The last stage of a world: contacts that begin, stay and end.
//
// Guarantee: for two bodies `begin` and `end` take turns, `begin` first, and every update between them has one `stay`;
// sorted by the bodies. A function of the contacts of each update, so the same for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "graze/detail/refilled.hpp"
#include "graze/world/bodies.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// The change of a pair's contact.
enum class EventKind : std::uint8_t { begin, stay, end };

/// Two bodies and the change of their contact.
struct ContactEvent {
  static constexpr std::uint32_t no_pair = ~std::uint32_t{0};  ///< placeholder at an `end`, whose pair is gone

  EventKind kind;      ///< begin, stay or end
  bool trigger;        ///< one of them is a trigger
  BodyId a, b;         ///< a.index < b.index; at `end` they may have been removed
  std::uint32_t pair;  ///< index among the pairs of the update; `no_pair` at an `end`
};

/// Tracks touching pairs: all events but the ends. Two bodies begin to touch when they overlap (distance <= 0), and
/// stay in touch while they are within their margin, so that a body that rests on another does not begin and end from
/// frame to frame. Triggers have no margin.
class GRAZE_API EventTracker {
 public:
  /// Finds the events. `pairs` are sorted, as the manifolds' stage leaves them.
  template <class T, class Space = graze::Space<T>>
  void update(const BodyArrays<T, Space>& bodies, std::span<const ContactPair<T>> pairs);

  /// Takes events of an earlier update in place of those of the last one: the next update goes on from them. `lost` are
  /// those whose pairs the last update did not find, as one of the bodies is gone: their ends are events of the next
  /// update.
  void go_back_to(std::span<const ContactEvent> events, std::span<const ContactEvent> lost = {});

  /// The events of the last update.
  std::span<const ContactEvent> events() const { return now_.filled(); }
  /// The events that `go_back_to` took as lost, until the next update.
  std::span<const ContactEvent> lost() const { return lost_; }

  /// Bytes that are held.
  std::size_t memory() const { return (now_.capacity() + last_.capacity() + lost_.capacity()) * sizeof(ContactEvent); }

 private:
  void take_lost();

  Refilled<ContactEvent> now_, last_;
  std::vector<ContactEvent> lost_;
};

}  // namespace graze
