// What the finding of manifolds takes over from the last call, and the lists that it leaves.
#include <algorithm>
#include <utility>

#include "graze/world/manifolds.hpp"
#include "mid/composite.hpp"

namespace graze {

namespace {

/// What is copied takes a tenth of the time that it took to find.
constexpr std::size_t blocks_per_task = 8;

/// Points up to which to look at all of them costs less than to sort them: all that two convex shapes have.
constexpr std::size_t few_points = 16;

}  // namespace

/// Finds what is known of each pair from the last call: both lists are sorted.
template <class T>
void ManifoldFinder<T>::remember(std::span<const IdPair> pairs) {
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
    if (keeps_axes_) axes_[i] = same ? last_axes_[known] : Vec3<T>{};
    known += same;
  }
}

/// Whether a pair with a fixed body came or went though neither body changed: by its filters then. What the other one
/// stands on beside it may be met otherwise.
template <class T>
bool ManifoldFinder<T>::ground_pairs_differ() const {
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
template <class T>
void ManifoldFinder<T>::find_neighbours(const BodyArrays<T>& bodies) {
  const auto each = [&](const auto& f) {
    for (const IdPair& p : pairs_) {
      if ((seen_[p.a].traits & fixed) != 0) f(p.b, p.a);
      if ((seen_[p.b].traits & fixed) != 0) f(p.a, p.b);
    }
  };
  // Only what is in a pair is touched.
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

/// One thread finds all manifolds one behind the other, where they stay; what several find is joined in the same order.
template <class T>
void ManifoldFinder<T>::begin_blocks(std::size_t blocks, bool alone) {
  if (found_.size() < blocks) found_.resize(blocks);
  if (alone) {
    found_[0].manifolds.swap(now_.manifolds);
    found_[0].points.swap(now_.points);
  }
  for (std::size_t i = 0; i < blocks; ++i) {
    found_[i].manifolds.clear();
    found_[i].points.clear();
    found_[i].contacts = 0;
  }
}

/// A pair of which nothing changed has what it had. What stood one behind the other is copied as one.
template <class T>
void ManifoldFinder<T>::keep_last(std::uint32_t place, Run& run, std::uint32_t block) {
  const std::uint32_t contact = contact_[place];
  if (contact == apart) {
    results_[place] = {};
    return;
  }
  ++found_[block].contacts;
  const ContactPair<T>& last = last_.pairs[contact];
  if (last.manifold_count != 0) {
    if (last.first_manifold != run.end) {
      copy_last(run, block);
      run.begin = run.end = last.first_manifold;
    }
    run.end += last.manifold_count;
  }
  const std::size_t first = found_[block].manifolds.size() + (run.end - run.begin) - last.manifold_count;
  results_[place] = {block, static_cast<std::uint32_t>(first), last.manifold_count, last.overlap};
}

/// What a pair had after the last call; its points stand one behind the other.
template <class T>
std::span<const SolverPoint<T>> ManifoldFinder<T>::last_points(std::uint32_t place) const {
  const std::uint32_t contact = contact_[place];
  if (contact >= apart) return {};
  const auto manifolds = last_.manifolds_of(last_.pairs[contact]);
  if (manifolds.empty()) return {};
  const std::size_t first = manifolds.front().first_point;
  return std::span(last_.points).subspan(first, manifolds.back().first_point + manifolds.back().point_count - first);
}

/// To points of the same features, which are single in the one manifold of two convex shapes; mostly they are the same
/// ones in the same order.
template <class T>
void ManifoldFinder<T>::carry_one(std::uint32_t place, std::span<SolverPoint<T>> points) const {
  const auto last = last_points(place);
  std::size_t at = 0;
  for (SolverPoint<T>& point : points) {
    for (std::size_t tried = 0; tried < last.size(); ++tried, ++at) {
      if (at >= last.size()) at = 0;
      if (last[at].feature != point.feature) continue;
      point.impulse = last[at++].impulse;
      break;
    }
  }
}

/// To points of the same features; of several, which only composites have, to the nearest.
template <class T>
void ManifoldFinder<T>::carry_many(std::uint32_t place, std::span<SolverPoint<T>> points,
                                   std::vector<SolverPoint<T>>& sorted) const {
  const auto last = last_points(place);
  const auto by_feature = [](const SolverPoint<T>& p, const SolverPoint<T>& q) { return p.feature < q.feature; };
  const bool few = last.size() <= few_points;
  if (!few) {
    sorted.assign(last.begin(), last.end());
    std::stable_sort(sorted.begin(), sorted.end(), by_feature);
  }
  for (SolverPoint<T>& point : points) {
    auto candidates = last;
    if (!few) {
      const auto [begin, end] = std::equal_range(sorted.begin(), sorted.end(), point, by_feature);
      candidates = std::span<const SolverPoint<T>>(sorted).subspan(static_cast<std::size_t>(begin - sorted.begin()),
                                                                   static_cast<std::size_t>(end - begin));
    }
    const SolverPoint<T>* nearest = nullptr;
    for (const SolverPoint<T>& p : candidates)
      if (p.feature == point.feature &&
          (!nearest || length_squared(p.a - point.a) < length_squared(nearest->a - point.a)))
        nearest = &p;
    if (nearest) point.impulse = nearest->impulse;
  }
}

/// Copies the manifolds of a run with their points, impulses included, which stand in the same order.
template <class T>
void ManifoldFinder<T>::copy_last(Run& run, std::uint32_t block) {
  if (run.begin == run.end) return;
  Found& found = found_[block];
  const ContactManifold<T>&front = last_.manifolds[run.begin], &back = last_.manifolds[run.end - 1];
  const auto shift = static_cast<std::uint32_t>(found.points.size()) - front.first_point;  // modulo its range
  const auto points =
      std::span(last_.points).subspan(front.first_point, back.first_point + back.point_count - front.first_point);
  found.points.insert(found.points.end(), points.begin(), points.end());
  const std::size_t first = found.manifolds.size();
  const auto manifolds = std::span(last_.manifolds).subspan(run.begin, run.end - run.begin);
  found.manifolds.insert(found.manifolds.end(), manifolds.begin(), manifolds.end());
  for (ContactManifold<T>& m : std::span(found.manifolds).subspan(first)) m.first_point += shift;
  run = {};
}

/// Lays what was found one behind the other, and the pairs in their order.
template <class T>
void ManifoldFinder<T>::gather(std::size_t blocks, bool alone, Executor& executor) {
  std::uint32_t manifolds = 0, points = 0, contacts = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    Found& found = found_[i];
    found.first_manifold = std::exchange(manifolds, manifolds + static_cast<std::uint32_t>(found.manifolds.size()));
    found.first_point = std::exchange(points, points + static_cast<std::uint32_t>(found.points.size()));
    contacts += found.contacts;
  }
  now_.pairs.resize(contacts);
  if (alone) {
    gather_pairs();
    now_.manifolds.swap(found_[0].manifolds);
    now_.points.swap(found_[0].points);
    return;
  }
  now_.manifolds.resize(manifolds);
  now_.points.resize(points);
  // The pairs, which are the longest of these tasks, beside all others.
  executor.run((blocks + blocks_per_task - 1) / blocks_per_task + 1, [&](std::size_t task) {
    if (task == 0) return gather_pairs();
    for (std::size_t i = (task - 1) * blocks_per_task; i < std::min(blocks, task * blocks_per_task); ++i) {
      const Found& found = found_[i];
      auto to = now_.manifolds.begin() + found.first_manifold;
      for (ContactManifold<T> m : found.manifolds) {
        m.first_point += found.first_point;
        *to++ = m;
      }
      std::copy(found.points.begin(), found.points.end(), now_.points.begin() + found.first_point);
    }
  });
}

/// Each is written whether it touches or not, and written over by the next one: no branch would foresee which do.
template <class T>
void ManifoldFinder<T>::gather_pairs() {
  const std::size_t count = now_.pairs.size();
  std::uint32_t place = 0;
  for (std::size_t i = 0; place < count; ++i) {
    const Result& r = results_[i];
    now_.pairs[place] = {pairs_[i].a, pairs_[i].b, r.overlap != 0, found_[r.block].first_manifold + r.first_manifold,
                         r.manifold_count};
    const std::uint32_t touches = r.touches();
    contact_[i] = apart ^ ((apart ^ place) & (0 - touches));  // the place or `apart`, without a jump
    place += touches;
  }
}

template <class T>
std::size_t ManifoldFinder<T>::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = bytes(seen_) + bytes(bins_.order) + bytes(bins_.bins) + bytes(bins_.types) + bytes(around_) +
                    bytes(neighbours_) + bytes(last_changes_) + bytes(generations_) + bytes(found_) + bytes(pairs_) +
                    bytes(last_pairs_) + bytes(contact_) + bytes(last_contact_) + bytes(axes_) + bytes(last_axes_) +
                    bytes(results_);
  for (const Found& found : found_)
    sum += bytes(found.manifolds) + bytes(found.points) + bytes(found.composite) + bytes(found.sorted);
  for (const ContactArrays<T>* arrays : {&now_, &last_})
    sum += bytes(arrays->pairs) + bytes(arrays->manifolds) + bytes(arrays->points);
  return sum;
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;

}  // namespace graze
