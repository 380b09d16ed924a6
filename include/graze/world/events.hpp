// The last stage of a world: who began to touch, still does, no longer does.
//
// Guarantee: for two bodies `begin` and `end` take turns, `begin` first, and every update between them has one `stay`;
// sorted by the bodies. A function of what touched in each update, so the same for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "graze/world/bodies.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

enum class EventKind : std::uint8_t { begin, stay, end };

/// Two bodies and what became of their touching.
struct ContactEvent {
  static constexpr std::uint32_t no_pair = ~std::uint32_t{0};

  EventKind kind;
  bool trigger;        ///< one of them is a trigger
  BodyId a, b;         ///< a.index < b.index; at `end` they may have been removed
  std::uint32_t pair;  ///< the place among the pairs of the update; `no_pair` at an `end`
};

/// Remembers what touches. Two bodies begin to touch when they overlap (distance <= 0), and go on until nothing of them
/// is within their margin, so that a body that rests on another does not begin and end from frame to frame. Triggers
/// have no margin.
class EventTracker {
 public:
  /// `pairs` as the manifolds' stage leaves them, sorted; `id` and `trigger` tell of an index.
  template <class T, class Id, class Trigger>
  void update(std::span<const ContactPair<T>> pairs, const Id& id, const Trigger& trigger,
              std::vector<ContactEvent>& out) {
    touching_.swap(last_);
    touching_.clear();
    out.clear();
    std::size_t next = 0;
    const auto end_before = [&](const auto& in_front) {
      for (; next < last_.size() && in_front(last_[next]); ++next)
        out.push_back({EventKind::end, last_[next].trigger, last_[next].a, last_[next].b, ContactEvent::no_pair});
    };
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
      const BodyId a = id(pairs[i].a), b = id(pairs[i].b);
      // Mostly the next one that touched still does.
      if (next < last_.size() && last_[next].a == a && last_[next].b == b) {
        touching_.push_back(last_[next]);
        out.push_back({EventKind::stay, last_[next++].trigger, a, b, i});
        continue;
      }
      const Touching now{a, b, trigger(a.index) || trigger(b.index)};
      end_before([&](const Touching& t) { return t < now; });
      const bool before = next < last_.size() && !(now < last_[next]);
      next += before;
      if (!before && !pairs[i].overlap) continue;
      out.push_back({before ? EventKind::stay : EventKind::begin, now.trigger, a, b, i});
      touching_.push_back(now);
    }
    end_before([](const Touching&) { return true; });
  }

  /// Bytes that are held.
  std::size_t memory() const { return (touching_.capacity() + last_.capacity()) * sizeof(Touching); }

 private:
  struct Touching {
    BodyId a, b;
    bool trigger;

    friend bool operator<(const Touching& s, const Touching& t) {
      if (s.a.index != t.a.index) return s.a.index < t.a.index;
      if (s.b.index != t.b.index) return s.b.index < t.b.index;
      return s.a.generation != t.a.generation ? s.a.generation < t.a.generation : s.b.generation < t.b.generation;
    }
  };

  std::vector<Touching> touching_, last_;
};

}  // namespace graze
