#include "graze/world/manifolds.hpp"

#include <algorithm>
#include <utility>

#include "mid/composite.hpp"
#include "narrow/ball_batch.hpp"
#include "narrow/box_batch.hpp"
#include "narrow/cached_axis.hpp"
#include "narrow/convex_pair.hpp"

namespace graze {

namespace {

/// Pairs a task: some tens of microseconds of work, so that a thread that comes late to the last ones costs little, and
/// as many as kernels take at a time.
constexpr std::size_t pairs_per_task = box_chunk;

/// Points up to which to look at all of them costs less than to sort them: all that two convex shapes have.
constexpr std::size_t few_points = 16;

/// Up to where contacts of a pair are wanted.
template <class T>
T margin_of(const BodyArrays<T>& bodies, const IdPair& pair) {
  const T margin = least(bodies.margins()[pair.a], bodies.margins()[pair.b]);
  return margin < std::numeric_limits<T>::infinity() ? margin : T(0);
}

}  // namespace

template <class T>
void ManifoldFinder<T>::find_traits(const BodyArrays<T>& bodies) {
  traits_.resize(bodies.size());
  ground_changed_ = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Shape<T>& shape = bodies.shapes()[i];
    traits_[i] = static_cast<std::uint8_t>(
        (plain_box(shape) ? box : 0) | (plain_ball(shape) ? ball : 0) | (bodies.changed()[i] != 0 ? changed : 0) |
        (bodies.triggers()[i] != 0 ? trigger : 0) | (bodies.fixed()[i] != 0 ? fixed : 0));
    ground_changed_ |= (traits_[i] & (fixed | changed)) == (fixed | changed);
  }
}

/// Finds what is known of each pair from the last call: both lists are sorted.
template <class T>
void ManifoldFinder<T>::remember(std::span<const IdPair> pairs) {
  last_pairs_.swap(pairs_);
  last_memory_.swap(memory_);
  std::swap(last_, now_);
  pairs_.assign(pairs.begin(), pairs.end());
  memory_.assign(pairs.size(), {});
  std::size_t known = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    while (known < last_pairs_.size() && last_pairs_[known] < pairs[i]) ++known;
    if (known < last_pairs_.size() && last_pairs_[known] == pairs[i]) memory_[i] = last_memory_[known];
  }
}

/// For each body that moves, the fixed bodies it stands in a pair with, in the order of the pairs.
template <class T>
void ManifoldFinder<T>::find_neighbours(const BodyArrays<T>& bodies) {
  const auto each = [&](const auto& f) {
    for (const IdPair& p : pairs_) {
      if ((traits_[p.a] & fixed) != 0) f(p.b, p.a);
      if ((traits_[p.b] & fixed) != 0) f(p.a, p.b);
    }
  };
  first_neighbour_.assign(bodies.size() + 1, 0);
  each([&](std::uint32_t body, std::uint32_t) { ++first_neighbour_[body + 1]; });
  for (std::size_t i = 1; i < first_neighbour_.size(); ++i) first_neighbour_[i] += first_neighbour_[i - 1];
  neighbours_.resize(first_neighbour_.back());
  places_.assign(first_neighbour_.begin(), first_neighbour_.end());
  each([&](std::uint32_t body, std::uint32_t ground) {
    neighbours_[places_[body]++] = {&bodies.shapes()[ground], &bodies.poses()[ground]};
  });
}

template <class T>
std::span<const PlacedRef<T>> ManifoldFinder<T>::neighbours_of(std::uint32_t index) const {
  return std::span(neighbours_).subspan(first_neighbour_[index], first_neighbour_[index + 1] - first_neighbour_[index]);
}

template <class T>
void ManifoldFinder<T>::find(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, Executor& executor) {
  find_traits(bodies);
  remember(pairs);
  find_neighbours(bodies);
  bin_pairs<T>(pairs_, bodies.shapes(), bins_);
  results_.assign(pairs_.size(), {});
  const std::size_t tasks = (pairs_.size() + pairs_per_task - 1) / pairs_per_task;
  if (found_.size() < tasks) found_.resize(tasks);
  for_each_chunk(executor, pairs_.size(), pairs_per_task, [&](std::size_t begin, std::size_t end, std::size_t task) {
    found_[task].manifolds.clear();
    found_[task].points.clear();
    find_some(bodies, std::span(bins_.order).subspan(begin, end - begin), static_cast<std::uint32_t>(task));
  });
  gather(pairs_, executor);
}

/// What moves goes over the fixed bodies as over one; those that it may touch count among them the one of this pair.
template <class T>
Surroundings<T> ManifoldFinder<T>::beside(const IdPair& pair) const {
  Surroundings<T> beside;
  if ((traits_[pair.a] & fixed) != 0) beside.of_a = neighbours_of(pair.b);
  if ((traits_[pair.b] & fixed) != 0) beside.of_b = neighbours_of(pair.a);
  if (beside.of_a.size() < 2) beside.of_a = {};
  if (beside.of_b.size() < 2) beside.of_b = {};
  return beside;
}

/// Pairs of boxes and of balls that are to be asked about anew are put together for the kernels, all others taken one by
/// one.
template <class T>
void ManifoldFinder<T>::find_some(const BodyArrays<T>& bodies, std::span<const std::uint32_t> places,
                                  std::uint32_t task) {
  PairRef<T> boxes[box_chunk], balls[box_chunk];
  std::uint32_t box_places[box_chunk], ball_places[box_chunk];
  std::size_t box_count = 0, ball_count = 0;
  for (const std::uint32_t place : places) {
    const IdPair& pair = pairs_[place];
    const int either = traits_[pair.a] | traits_[pair.b], both = traits_[pair.a] & traits_[pair.b];
    const bool known = memory_[place].apart || memory_[place].contact != no_result;
    if ((both & (box | ball)) == 0 || (either & trigger) != 0 || ((either & changed) == 0 && known) ||
        ((either & fixed) != 0 && !beside(pair).empty())) {
      find_one(bodies, pair, place, task);
      continue;
    }
    const auto ref = [&](const auto* a, const auto* b) {
      return PairRef<T>{a, b, &bodies.poses()[pair.a], &bodies.poses()[pair.b], margin_of(bodies, pair)};
    };
    const Shape<T>&a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
    if ((both & box) != 0) {
      boxes[box_count] = ref(a.template as<Box<T>>(), b.template as<Box<T>>());
      box_places[box_count++] = place;
    } else {
      balls[ball_count] = ref(a.template as<Sphere<T>>(), b.template as<Sphere<T>>());
      ball_places[ball_count++] = place;
    }
    if (box_count == box_chunk) find_boxes(bodies, {boxes, std::exchange(box_count, 0)}, box_places, task);
    if (ball_count == box_chunk) find_balls({balls, std::exchange(ball_count, 0)}, ball_places, task);
  }
  find_boxes(bodies, {boxes, box_count}, box_places, task);
  find_balls({balls, ball_count}, ball_places, task);
}

/// Notes the one manifold of a pair.
template <class T>
void ManifoldFinder<T>::keep(std::uint32_t place, std::uint32_t task, T distance, const Vec3<T>& normal,
                             std::span<const ContactPoint<T>> points) {
  Found& found = found_[task];
  const auto count = static_cast<std::uint32_t>(points.size());
  memory_[place].apart = false;
  results_[place] = {task, static_cast<std::uint32_t>(found.manifolds.size()), 1, count, distance <= T(0)};
  found.manifolds.push_back({normal, 0, 0, static_cast<std::uint32_t>(found.points.size()), count});
  for (const ContactPoint<T>& p : points) found.points.push_back({p, {}});
}

template <class T>
void ManifoldFinder<T>::find_boxes(const BodyArrays<T>& bodies, std::span<const PairRef<T>> boxes,
                                   const std::uint32_t* places, std::uint32_t task) {
  visit_box_contacts(
      boxes.data(), boxes.size(), [&](std::size_t i) { memory_[places[i]].apart = true; },
      [&](std::size_t i, T distance, const Vec3<T>& normal, const ContactPoint<T>* points, std::size_t count) {
        keep(places[i], task, distance, normal, {points, count});
      },
      [&](std::size_t i) { find_one(bodies, pairs_[places[i]], places[i], task); });
}

template <class T>
void ManifoldFinder<T>::find_balls(std::span<const PairRef<T>> balls, const std::uint32_t* places, std::uint32_t task) {
  visit_ball_contacts(
      balls.data(), balls.size(), [&](std::size_t i) { memory_[places[i]].apart = true; },
      [&](std::size_t i, const Vec3<T>& normal, const ContactPoint<T>& point) {
        keep(places[i], task, point.distance, normal, {&point, 1});
      });
}

template <class T>
void ManifoldFinder<T>::find_one(const BodyArrays<T>& bodies, const IdPair& pair, std::uint32_t place,
                                 std::uint32_t task) {
  Memory& memory = memory_[place];
  Found& found = found_[task];
  Result& result = results_[place];
  result.task = task;
  result.first_manifold = static_cast<std::uint32_t>(found.manifolds.size());
  const std::size_t first_point = found.points.size();

  const int either = traits_[pair.a] | traits_[pair.b];
  const Surroundings<T> beside = this->beside(pair);
  const bool anew = (either & changed) != 0 || (ground_changed_ && !beside.empty());
  const Shape<T>&a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
  const Pose<T>&pose_a = bodies.poses()[pair.a], &pose_b = bodies.poses()[pair.b];
  if ((either & trigger) != 0) {
    result.overlap = any_overlap<T>(a, pose_a, b, pose_b, nullptr);
    return;
  }
  if (!anew && memory.contact != no_result) return keep_last(memory.contact, place, task);
  const T margin = margin_of(bodies, pair);

  const auto add = [&](const Manifold<T>& m) {
    found.manifolds.push_back({m.normal, m.piece_a, m.piece_b, static_cast<std::uint32_t>(found.points.size()),
                               static_cast<std::uint32_t>(m.points.size())});
    for (const ContactPoint<T>& p : m.points) found.points.push_back({p, {}});
  };
  if (a.convex() && b.convex()) {
    if (memory.apart && !anew) return;
    if (memory.axis != Vec3<T>{} && still_apart(a, pose_a, b, pose_b, memory.axis, margin)) return;
    Manifold<T> manifold;
    result.overlap = convex_contacts<T>(a, pose_a, b, pose_b, margin, manifold, nullptr) <= T(0);
    const bool apart = manifold.points.empty();
    memory.apart = apart;
    memory.axis = apart ? rotate(conjugate(pose_a.rotation), manifold.normal) : Vec3<T>{};
    if (!apart && beside.empty()) add(manifold);
    if (!apart && !beside.empty()) {
      found.composite.clear();
      any_contacts<T>(a, pose_a, b, pose_b, margin, found.composite, nullptr, beside);
      for (const Manifold<T>& m : found.composite) add(m);
    }
  } else {
    found.composite.clear();
    result.overlap = any_contacts<T>(a, pose_a, b, pose_b, margin, found.composite, nullptr, beside) <= T(0);
    for (const Manifold<T>& m : found.composite) add(m);
  }
  result.manifold_count = static_cast<std::uint32_t>(found.manifolds.size()) - result.first_manifold;
  result.point_count = static_cast<std::uint32_t>(found.points.size() - first_point);
}

/// A pair of which nothing changed: what it had, impulses included.
template <class T>
void ManifoldFinder<T>::keep_last(std::uint32_t contact, std::uint32_t place, std::uint32_t task) {
  Found& found = found_[task];
  Result& result = results_[place];
  const ContactPair<T>& last = last_.pairs[contact];
  result.overlap = last.overlap;
  result.manifold_count = last.manifold_count;
  for (const ContactManifold<T>& m : last_.manifolds_of(last)) {
    ContactManifold<T> moved = m;
    moved.first_point = static_cast<std::uint32_t>(found.points.size());
    found.manifolds.push_back(moved);
    const auto points = last_.points_of(m);
    found.points.insert(found.points.end(), points.begin(), points.end());
    result.point_count += m.point_count;
  }
}

/// Lays what the tasks found one behind the other, in the order of the pairs.
template <class T>
void ManifoldFinder<T>::gather(std::span<const IdPair> pairs, Executor& executor) {
  now_.pairs.clear();
  places_.clear();
  std::uint32_t manifolds = 0, points = 0;
  first_point_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const Result& r = results_[i];
    if (!r.overlap && r.manifold_count == 0) {
      memory_[i].contact = no_result;
      continue;
    }
    places_.push_back(i);
    first_point_.push_back(points);
    now_.pairs.push_back({pairs[i].a, pairs[i].b, r.overlap, manifolds, r.manifold_count});
    manifolds += r.manifold_count;
    points += r.point_count;
  }
  now_.manifolds.resize(manifolds);
  now_.points.resize(points);
  constexpr std::size_t copies_per_task = 4 * pairs_per_task;
  scratch_.resize(std::max(scratch_.size(), (places_.size() + copies_per_task - 1) / copies_per_task));
  for_each_chunk(executor, places_.size(), copies_per_task, [&](std::size_t begin, std::size_t end, std::size_t task) {
    for (std::size_t k = begin; k < end; ++k) {
      const Result& r = results_[places_[k]];
      const Found& found = found_[r.task];
      std::uint32_t point = first_point_[k];
      for (std::uint32_t m = 0; m < r.manifold_count; ++m) {
        ContactManifold<T> manifold = found.manifolds[r.first_manifold + m];
        std::copy_n(found.points.begin() + manifold.first_point, manifold.point_count, now_.points.begin() + point);
        manifold.first_point = point;
        point += manifold.point_count;
        now_.manifolds[now_.pairs[k].first_manifold + m] = manifold;
      }
      Memory& memory = memory_[places_[k]];
      if (memory.contact != no_result) carry_impulses(now_.pairs[k], last_.pairs[memory.contact], scratch_[task]);
      memory.contact = static_cast<std::uint32_t>(k);
    }
  });
}

/// To points of the same features; of several, which only composites have, to the nearest.
template <class T>
void ManifoldFinder<T>::carry_impulses(const ContactPair<T>& pair, const ContactPair<T>& last,
                                       std::vector<SolverPoint<T>>& sorted) {
  const auto manifolds = last_.manifolds_of(last);
  if (manifolds.empty()) return;
  // The points of a pair stand one behind the other.
  std::span<const SolverPoint<T>> old(last_.points.begin() + manifolds.front().first_point,
                                      last_.points.begin() + manifolds.back().first_point +
                                          manifolds.back().point_count);
  const auto by_feature = [](const SolverPoint<T>& p, const SolverPoint<T>& q) { return p.feature < q.feature; };
  const bool few = old.size() <= few_points;
  if (!few) {
    sorted.assign(old.begin(), old.end());
    std::stable_sort(sorted.begin(), sorted.end(), by_feature);
  }
  for (const ContactManifold<T>& m : now_.manifolds_of(pair))
    for (SolverPoint<T>& point : std::span(now_.points).subspan(m.first_point, m.point_count)) {
      auto candidates = old;
      if (!few) {
        const auto [begin, end] = std::equal_range(sorted.begin(), sorted.end(), point, by_feature);
        candidates = {begin, end};
      }
      const SolverPoint<T>* nearest = nullptr;
      for (const SolverPoint<T>& p : candidates)
        if (p.feature == point.feature &&
            (!nearest || length_squared(p.a - point.a) < length_squared(nearest->a - point.a)))
          nearest = &p;
      if (nearest) point.impulse = nearest->impulse;
    }
}

template <class T>
std::size_t ManifoldFinder<T>::memory() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t sum = bytes(traits_) + bytes(bins_.order) + bytes(bins_.bins) + bytes(bins_.types) +
                    bytes(first_neighbour_) + bytes(neighbours_) + bytes(found_) + bytes(scratch_) + bytes(pairs_) +
                    bytes(last_pairs_) + bytes(memory_) + bytes(last_memory_) + bytes(results_) + bytes(places_) +
                    bytes(first_point_);
  for (const auto* arrays : {&now_, &last_})
    sum += bytes(arrays->pairs) + bytes(arrays->manifolds) + bytes(arrays->points);
  for (const auto& points : scratch_) sum += bytes(points);
  for (const Found& f : found_) sum += bytes(f.manifolds) + bytes(f.points) + bytes(f.composite);
  return sum;
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;

}  // namespace graze
