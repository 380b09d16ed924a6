#include "graze/world/events.hpp"

#include <tuple>
#include <utility>

namespace graze {

namespace {

/// By the indices of the two, and where these were given to another body, by that.
bool before(const ContactEvent& s, const ContactEvent& t) {
  const auto key = [](const ContactEvent& e) {
    return std::tuple(e.a.index, e.b.index, e.a.generation, e.b.generation);
  };
  return key(s) < key(t);
}

}  // namespace

template <class T>
void EventTracker::update(const BodyArrays<T>& bodies, std::span<const ContactPair<T>> pairs) {
  std::swap(now_, last_);
  now_.clear();
  const std::span<const ContactEvent> last = last_.filled();
  const ContactEvent* from = last.data();
  const ContactEvent* const end = from + last.size();
  ContactEvent* const first = now_.extend(pairs.size() + last.size());
  ContactEvent* to = first;
  const auto skip_ends = [&] {
    while (from < end && from->kind == EventKind::end) ++from;
  };
  const auto end_one = [&] { *to++ = {EventKind::end, from->trigger, from->a, from->b, ContactEvent::no_pair}; };
  skip_ends();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    ContactEvent now{EventKind::stay, false, bodies.id(pairs[i].a), bodies.id(pairs[i].b), i};
    // Mostly the next one that touched still does.
    bool stays = from < end && from->a == now.a && from->b == now.b;
    if (!stays) {
      for (; from < end && before(*from, now); ++from, skip_ends()) end_one();
      stays = from < end && from->a == now.a && from->b == now.b;
    }
    if (stays) {
      now.trigger = from->trigger;
      ++from, skip_ends();
    } else if (pairs[i].overlap) {
      now.kind = EventKind::begin;
      now.trigger = (bodies.triggers()[now.a.index] | bodies.triggers()[now.b.index]) != 0;
    } else {
      continue;
    }
    *to++ = now;
  }
  for (; from < end; ++from, skip_ends()) end_one();
  now_.shorten(static_cast<std::size_t>(to - first));
}

template void EventTracker::update(const BodyArrays<float>&, std::span<const ContactPair<float>>);
template void EventTracker::update(const BodyArrays<double>&, std::span<const ContactPair<double>>);

}  // namespace graze
