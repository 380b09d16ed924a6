// The triggers of a scene that is played, of space or of the plane.
//
// Guarantee: a body counts as inside a trigger from the first of its parts that is to the last.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "graze/io/simulate.hpp"
#include "graze/world/events.hpp"

namespace graze::io {

class TriggerWatch {
 public:
  /// Records that a body of the simulation is a trigger: the collider of that index in the scene.
  void add(BodyId body, std::uint32_t collider) { collider_of_[body.index] = collider; }

  /// Appends what began and ended by the events of an update at `time`. `body_of[i]`: the scene's body of which the
  /// body of index i is a part.
  void note(std::span<const ContactEvent> events, std::span<const std::uint32_t> body_of, double time,
            std::vector<TriggerEvent>& out) {
    for (const ContactEvent& event : events) {
      if (!event.trigger || event.kind == EventKind::stay) continue;
      const bool begins = event.kind == EventKind::begin;
      for (const auto& [own, other] : {std::pair(event.a, event.b), std::pair(event.b, event.a)}) {
        const auto trigger = collider_of_.find(own.index);
        if (trigger == collider_of_.end()) continue;
        const TriggerEvent found{time, begins, trigger->second, body_of[other.index]};
        std::size_t& inside = inside_[{found.trigger, found.body}];
        if (inside == (begins ? 0u : 1u)) out.push_back(found);
        begins ? ++inside : --inside;
      }
    }
  }

 private:
  std::map<std::uint32_t, std::uint32_t> collider_of_;  ///< by the simulation's index of a trigger
  /// The number of parts of a body that are inside, by trigger and body.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> inside_;
};

}  // namespace graze::io
