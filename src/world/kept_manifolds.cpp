// The state that finding manifolds takes over from the last call, and the lists that it leaves.
#include <algorithm>
#include <utility>

#include "composite/composite.hpp"
#include "graze/plane/space.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

namespace {

/// The number of points up to which comparing all of them costs less than sorting them: all that two convex shapes
/// have.
constexpr std::size_t few_points = 16;

}  // namespace

/// Takes other pairs, and finds what is known of each from the last call: both lists are sorted.
template <class T, class Space>
void ManifoldFinder<T, Space>::remember(std::span<const IdPair> pairs) {
  last_pairs_.swap(pairs_);
  last_contact_.swap(contact_);
  pairs_.assign(pairs.begin(), pairs.end());
  contact_.resize(pairs.size());
  if (keeps_axes_) {
    last_axes_.swap(axes_);
    axes_.resize(pairs.size());
  }
  std::size_t known = 0;
  const std::size_t count = last_pairs_.size();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    while (known < count && last_pairs_[known] < pairs[i]) ++known;
    const bool same = known < count && last_pairs_[known] == pairs[i];
    contact_[i] = same ? last_contact_[known] : unknown;
    if (keeps_axes_) axes_[i] = same ? last_axes_[known] : Vec{};
    known += same;
  }
}

/// Whether a pair with a fixed body came or went though neither body changed: then its filters did. The contacts with
/// other fixed bodies beside it may become others by that.
template <class T, class Space>
bool ManifoldFinder<T, Space>::ground_pairs_differ() const {
  const auto matters = [&](const IdPair& p) {
    return ((seen_[p.a].traits | seen_[p.b].traits) & (fixed | changed)) == fixed;
  };
  auto now = pairs_.begin(), last = last_pairs_.begin();
  while (now != pairs_.end() || last != last_pairs_.end()) {
    if (last == last_pairs_.end() || (now != pairs_.end() && *now < *last)) {
      if (matters(*now++)) return true;
    } else if (now == pairs_.end() || *last < *now) {
      if (matters(*last++)) return true;
    } else {
      ++now, ++last;
    }
  }
  return false;
}

/// For each body that moves, the fixed bodies it stands in a pair with, in the order of the pairs.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_neighbours(const BodyArrays<T, Space>& bodies) {
  const auto each = [&](const auto& f) {
    for (const IdPair& p : pairs_) {
      if ((seen_[p.a].traits & fixed) != 0) f(p.b, p.a);
      if ((seen_[p.b].traits & fixed) != 0) f(p.a, p.b);
    }
  };
  // Only the bodies of pairs are touched.
  around_.resize(bodies.size());
  std::uint32_t count = 0, first = 0;
  each([&](std::uint32_t body, std::uint32_t) { around_[body] = {}; });
  each([&](std::uint32_t body, std::uint32_t) { ++around_[body].count, ++count; });
  neighbours_.resize(count);
  each([&](std::uint32_t body, std::uint32_t ground) {
    Around& around = around_[body];
    if (around.filled == 0) around.first = std::exchange(first, first + around.count);
    neighbours_[around.first + around.filled++] = {&bodies.shapes()[ground], &bodies.poses()[ground]};
  });
}

/// Keeps the contacts of a pair of which nothing changed. Those that stood one behind the other are copied as one.
template <class T, class Space>
void ManifoldFinder<T, Space>::keep_last(std::uint32_t place, Run& run, Task& task) {
  const std::uint32_t contact = contact_[place];
  if (contact == apart) return;
  const ContactPair<T>& last = last_.pairs[contact];
  if (last.manifold_count != 0) {
    if (last.first_manifold != run.end) {
      copy_last(run, task);
      run.begin = run.end = last.first_manifold;
    }
    run.end += last.manifold_count;
  }
  const std::size_t end = found_[task.found].manifolds.size() + (run.end - run.begin);
  touch(place, task, end - last.manifold_count, last.manifold_count, last.overlap);
}

/// The points of a pair after the last call, which stand one behind the other.
template <class T, class Space>
std::span<const SolverPoint<T, Space>> ManifoldFinder<T, Space>::last_points(std::uint32_t place) const {
  const std::uint32_t contact = contact_[place];
  if (contact >= apart) return {};
  const auto manifolds = last_.manifolds_of(last_.pairs[contact]);
  if (manifolds.empty()) return {};
  const std::size_t first = manifolds.front().first_point;
  return std::span(last_.points).subspan(first, manifolds.back().first_point + manifolds.back().point_count - first);
}

/// Carries impulses over to points of the same features, which are single in the one manifold of two convex shapes; in
/// most cases they are the same ones in the same order.
template <class T, class Space>
void ManifoldFinder<T, Space>::carry_one(std::uint32_t place, std::span<SolverPoint<T, Space>> points) const {
  const auto last = last_points(place);
  std::size_t at = 0;
  for (SolverPoint<T, Space>& point : points) {
    for (std::size_t tried = 0; tried < last.size(); ++tried, ++at) {
      if (at >= last.size()) at = 0;
      if (last[at].feature != point.feature) continue;
      point.impulse = last[at++].impulse;
      break;
    }
  }
}

/// Carries impulses over to points of the same features; of several, which only composites have, to the nearest.
template <class T, class Space>
void ManifoldFinder<T, Space>::carry_many(std::uint32_t place, std::span<SolverPoint<T, Space>> points,
                                          std::vector<SolverPoint<T, Space>>& sorted) const {
  const auto last = last_points(place);
  const auto by_feature = [](const SolverPoint<T, Space>& p, const SolverPoint<T, Space>& q) {
    return p.feature < q.feature;
  };
  const bool few = last.size() <= few_points;
  if (!few) {
    sorted.assign(last.begin(), last.end());
    std::stable_sort(sorted.begin(), sorted.end(), by_feature);
  }
  for (SolverPoint<T, Space>& point : points) {
    auto candidates = last;
    if (!few) {
      const auto [begin, end] = std::equal_range(sorted.begin(), sorted.end(), point, by_feature);
      candidates = std::span<const SolverPoint<T, Space>>(sorted).subspan(
          static_cast<std::size_t>(begin - sorted.begin()), static_cast<std::size_t>(end - begin));
    }
    const SolverPoint<T, Space>* nearest = nullptr;
    for (const SolverPoint<T, Space>& p : candidates)
      if (p.feature == point.feature &&
          (!nearest || length_squared(p.a - point.a) < length_squared(nearest->a - point.a)))
        nearest = &p;
    if (nearest) point.impulse = nearest->impulse;
  }
}

/// Copies the manifolds of a run with their points, impulses included, which stand in the same order.
template <class T, class Space>
void ManifoldFinder<T, Space>::copy_last(Run& run, Task& task) {
  if (run.begin == run.end) return;
  Found& found = found_[task.found];
  const ContactManifold<T, Space>&front = last_.manifolds[run.begin], &back = last_.manifolds[run.end - 1];
  const auto shift = static_cast<std::uint32_t>(found.points.size()) - front.first_point;  // modulo its range
  const auto points =
      std::span(last_.points).subspan(front.first_point, back.first_point + back.point_count - front.first_point);
  std::copy(points.begin(), points.end(), found.points.extend(points.size()));
  ContactManifold<T, Space>* to = found.manifolds.extend(run.end - run.begin);
  for (ContactManifold<T, Space> m : std::span(last_.manifolds).subspan(run.begin, run.end - run.begin)) {
    m.first_point += shift;
    *to++ = m;
  }
  run = {};
}

template <class T, class Space>
std::size_t ManifoldFinder<T, Space>::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = bytes(seen_) + bytes(bins_.order) + bytes(bins_.bins) + bytes(bins_.types) + bytes(around_) +
                    bytes(neighbours_) + bytes(last_changes_) + bytes(generations_) + bytes(found_) + bytes(pairs_) +
                    bytes(last_pairs_) + bytes(contact_) + bytes(last_contact_) + bytes(axes_) + bytes(last_axes_) +
                    bytes(asked_) + bytes(asked_places_) + bytes(tasks_) + bytes(touches_) + bytes(first_contacts_);
  for (const Found& found : found_)
    sum += found.manifolds.capacity() * sizeof(ContactManifold<T, Space>) +
           found.points.capacity() * sizeof(SolverPoint<T, Space>) + bytes(found.composite) + bytes(found.sorted) +
           found.choice.memory();
  for (const ContactArrays<T, Space>* arrays : {&now_, &last_})
    sum += bytes(arrays->pairs) + bytes(arrays->manifolds) + bytes(arrays->points);
  return sum;
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;
template class ManifoldFinder<float, plane::Space<float>>;
template class ManifoldFinder<double, plane::Space<double>>;

}  // namespace graze
