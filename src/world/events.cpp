#include "graze/world/events.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "graze/plane/space.hpp"

namespace graze {

namespace {

/// The order of two pairs by the indices of their bodies, and where an index was given to another body, by generation.
inline bool before(const BodyId& a, const BodyId& b, const BodyId& other_a, const BodyId& other_b) {
  const auto key = [](const BodyId& one, const BodyId& two) {
    return std::tuple(one.index, two.index, one.generation, two.generation);
  };
  return key(a, b) < key(other_a, other_b);
}

}  // namespace

template <class T, class Space>
void EventTracker::update(const BodyArrays<T, Space>& bodies, std::span<const ContactPair<T>> pairs) {
  std::swap(now_, last_);
  now_.clear();
  if (!lost_.empty()) take_lost();
  const std::span<const ContactEvent> last = last_.filled();
  const ContactEvent* from = last.data();
  const ContactEvent* const end = from + last.size();
  ContactEvent* const first = now_.extend(pairs.size() + last.size());
  ContactEvent* to = first;
  // Passes over ends, which are reported once: only pairs that still touched are compared.
  const auto skip_ends = [&] {
    while (from < end && from->kind == EventKind::end) ++from;
  };
  const auto take = [&]() -> const ContactEvent& {
    const ContactEvent& taken = *from++;
    skip_ends();
    return taken;
  };
  // Number by number: an event that is put together elsewhere and copied as a whole waits until its bytes are written.
  const auto put = [&](EventKind kind, bool trigger, const BodyId& a, const BodyId& b, std::uint32_t pair) {
    static_assert(sizeof(ContactEvent) == 2 * sizeof(BodyId) + 8, "all of it is written");
    to->kind = kind;
    to->trigger = trigger;
    to->a = a;
    to->b = b;
    to->pair = pair;
    ++to;
  };
  const auto end_one = [&] {
    const ContactEvent& e = take();
    put(EventKind::end, e.trigger, e.a, e.b, ContactEvent::no_pair);
  };
  skip_ends();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const BodyId a = bodies.id(pairs[i].a), b = bodies.id(pairs[i].b);
    const auto stays = [&] { return from < end && from->a == a && from->b == b; };
    // In most cases the next pair that touched still does.
    while (!stays() && from < end && before(from->a, from->b, a, b)) end_one();
    if (stays())
      put(EventKind::stay, take().trigger, a, b, i);
    else if (pairs[i].overlap)
      put(EventKind::begin, (bodies.triggers()[a.index] | bodies.triggers()[b.index]) != 0, a, b, i);
  }
  while (from < end) end_one();
  now_.shorten(static_cast<std::size_t>(to - first));
}

void EventTracker::go_back_to(std::span<const ContactEvent> events, std::span<const ContactEvent> lost) {
  now_.clear();
  std::copy(events.begin(), events.end(), now_.extend(events.size()));
  lost_.assign(lost.begin(), lost.end());
}

/// Puts the lost events among those of the last update.
void EventTracker::take_lost() {
  lost_.insert(lost_.end(), last_.filled().begin(), last_.filled().end());
  std::stable_sort(lost_.begin(), lost_.end(),
                   [](const ContactEvent& e, const ContactEvent& o) { return before(e.a, e.b, o.a, o.b); });
  last_.clear();
  std::copy(lost_.begin(), lost_.end(), last_.extend(lost_.size()));
  lost_.clear();
}

#define GRAZE_INSTANTIATE(T, Space)                                                                                    \
  template void EventTracker::update(const BodyArrays<T, Space<T>>&, std::span<const ContactPair<T>>);
GRAZE_INSTANTIATE(float, Space)
GRAZE_INSTANTIATE(double, Space)
GRAZE_INSTANTIATE(float, plane::Space)
GRAZE_INSTANTIATE(double, plane::Space)
#undef GRAZE_INSTANTIATE

}  // namespace graze
