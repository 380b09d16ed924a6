// The triggers of a scene that is played, of space or of the plane.
//
// Guarantee: a body counts as inside a trigger from the first of its parts that is to the last.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "graze/io/simulate.hpp"
#include "graze/world/events.hpp"

namespace graze::io {

/// Follows the events of a world's updates, and knows by them which bodies are inside each trigger.
class TriggerWatch {
 public:
  /// Records that a body of the simulation is a trigger: the collider of that index in the scene.
  void add(BodyId body, std::uint32_t collider) { collider_of_[body.index] = collider; }

  /// Appends what began and ended by the events of an update at `time`. `body_of[i]`: the scene's body of which the
  /// body of index i is a part.
  void note(std::span<const ContactEvent> events, std::span<const std::uint32_t> body_of, double time,
            std::vector<TriggerEvent>& out) {
    std::map<Meeting, std::ptrdiff_t> change;  // of the number of parts inside: one may come as another leaves
    for (const ContactEvent& event : events) {
      if (!event.trigger || event.kind == EventKind::stay) continue;
      for (const auto& [own, other] : {std::pair(event.a, event.b), std::pair(event.b, event.a)})
        if (const auto trigger = collider_of_.find(own.index); trigger != collider_of_.end())
          change[{trigger->second, body_of[other.index]}] += event.kind == EventKind::begin ? 1 : -1;
    }
    for (const auto& [meeting, parts] : change) {
      std::ptrdiff_t& inside = inside_[meeting];
      const bool was = inside > 0;
      inside += parts;
      if (was != (inside > 0)) out.push_back({time, !was, meeting.first, meeting.second});
    }
  }

 private:
  using Meeting = std::pair<std::uint32_t, std::uint32_t>;  ///< of a trigger's collider and a body of the scene

  std::map<std::uint32_t, std::uint32_t> collider_of_;  ///< by the simulation's index of a trigger
  std::map<Meeting, std::ptrdiff_t> inside_;            ///< the number of the body's parts that are inside
};

}  // namespace graze::io
