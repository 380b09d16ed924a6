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
  // Where those are that still touched: ends are told once.
  const auto skip_ends = [&] {
    while (from < end && from->kind == EventKind::end) ++from;
  };
  const auto take = [&]() -> const ContactEvent& {
    const ContactEvent& taken = *from++;
    skip_ends();
    return taken;
  };
  const auto end_one = [&] {
    const ContactEvent& e = take();
    *to++ = {EventKind::end, e.trigger, e.a, e.b, ContactEvent::no_pair};
  };
  skip_ends();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    ContactEvent now{EventKind::stay, false, bodies.id(pairs[i].a), bodies.id(pairs[i].b), i};
    const auto stays = [&] { return from < end && from->a == now.a && from->b == now.b; };
    // Mostly the next one that touched still does.
    while (!stays() && from < end && before(*from, now)) end_one();
    if (stays()) {
      now.trigger = take().trigger;
    } else if (pairs[i].overlap) {
      now.kind = EventKind::begin;
      now.trigger = (bodies.triggers()[now.a.index] | bodies.triggers()[now.b.index]) != 0;
    } else {
      continue;
    }
    *to++ = now;
  }
  while (from < end) end_one();
  now_.shorten(static_cast<std::size_t>(to - first));
}

template void EventTracker::update(const BodyArrays<float>&, std::span<const ContactPair<float>>);
template void EventTracker::update(const BodyArrays<double>&, std::span<const ContactPair<double>>);

}  // namespace graze
