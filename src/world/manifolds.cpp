#include "graze/world/manifolds.hpp"

#include <algorithm>
#include <utility>

#include "mid/composite.hpp"
#include "narrow/ball_batch.hpp"
#include "narrow/box_batch.hpp"
#include "narrow/cached_axis.hpp"
#include "narrow/convex_pair.hpp"
#include "narrow/rest_batch.hpp"

namespace graze {

namespace {

/// Pairs a task: some tens of microseconds of work, so that a thread that comes late to the last ones costs little, and
/// as many as kernels take at a time.
constexpr std::size_t pairs_per_task = box_chunk;

/// Points up to which to look at all of them costs less than to sort them: all that two convex shapes have.
constexpr std::size_t few_points = 16;

/// Pairs below which no second thread is asked for what takes each a nanosecond or two.
constexpr std::size_t few_pairs = 4096;

/// What is copied takes a tenth of the time that it took to find.
constexpr std::size_t blocks_per_task = 8;

}  // namespace

/// Pairs that wait for a kernel.
template <class T>
struct Waiting {
  PairRef<T> pairs[box_chunk];
  std::uint32_t places[box_chunk];
  std::size_t count = 0;

  void add(const PairRef<T>& pair, std::uint32_t place) {
    pairs[count] = pair;
    places[count++] = place;
  }
};

template <class T>
void ManifoldFinder<T>::look(const BodyArrays<T>& bodies) {
  seen_.resize(bodies.size());
  ground_ = 0;
  ground_changed_ = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Shape<T>& shape = bodies.shapes()[i];
    const Box<T>* plain = plain_box(shape);
    const Sphere<T>* round = plain_ball(shape);
    const bool stands = bodies.fixed()[i] != 0, moved = bodies.changed()[i] != 0;
    seen_[i] = {plain ? static_cast<const void*>(plain) : round, bodies.margins()[i],
                static_cast<std::uint8_t>((plain ? box : 0) | (round ? ball : 0) |
                                          (plain_half_space(shape) ? plane : 0) | (moved ? changed : 0) |
                                          (bodies.triggers()[i] != 0 ? trigger : 0) | (stands ? fixed : 0))};
    ground_ += stands;
    ground_changed_ |= stands && moved;
  }
}

/// Finds what is known of each pair from the last call: both lists are sorted.
template <class T>
void ManifoldFinder<T>::remember(std::span<const IdPair> pairs) {
  last_pairs_.swap(pairs_);
  last_memory_.swap(memory_);
  pairs_.assign(pairs.begin(), pairs.end());
  memory_.resize(pairs.size());
  std::size_t known = 0;
  const std::size_t count = last_pairs_.size();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    while (known < count && last_pairs_[known] < pairs[i]) ++known;
    const bool same = known < count && last_pairs_[known] == pairs[i];
    memory_[i] = same ? last_memory_[known] : Memory{};
    known += same;
  }
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
bool ManifoldFinder<T>::find(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, Executor& executor) {
  const bool same_pairs = std::equal(pairs.begin(), pairs.end(), pairs_.begin(), pairs_.end());
  if (same_pairs && bodies.unsorted_changes().empty()) return false;
  SerialExecutor serial;
  const bool alone = executor.concurrency() == 1;
  // Three parts of about the same length that know nothing of each other.
  const auto prepare = [&](std::size_t part) {
    if (part == 0) look(bodies);
    if (part == 1 && !same_pairs) remember(pairs);
    if (part == 2) bin_pairs<T>(pairs, bodies.shapes(), bins_);
  };
  (pairs.size() < few_pairs ? serial : executor).run(3, prepare);
  std::swap(last_, now_);
  if (ground_ > 1) find_neighbours(bodies);

  results_.resize(pairs_.size());
  const std::size_t tasks = (pairs_.size() + pairs_per_task - 1) / pairs_per_task;
  begin_blocks(alone ? 1 : tasks, alone);
  for_each_chunk(alone ? serial : executor, pairs_.size(), pairs_per_task,
                 [&](std::size_t begin, std::size_t end, std::size_t task) {
                   find_some(bodies, std::span(bins_.order).subspan(begin, end - begin),
                             alone ? 0 : static_cast<std::uint32_t>(task));
                 });
  gather(alone ? 1 : tasks, alone, executor);
  return true;
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

/// What moves goes over the fixed bodies as over one; those that it may touch count among them the one of this pair.
template <class T>
Surroundings<T> ManifoldFinder<T>::beside(const IdPair& pair) const {
  Surroundings<T> beside;
  if (ground_ < 2) return beside;
  if ((seen_[pair.a].traits & fixed) != 0) beside.of_a = neighbours_of(pair.b);
  if ((seen_[pair.b].traits & fixed) != 0) beside.of_b = neighbours_of(pair.a);
  if (beside.of_a.size() < 2) beside.of_a = {};
  if (beside.of_b.size() < 2) beside.of_b = {};
  return beside;
}

/// Pairs of boxes, of balls and of a box and a half-space that are to be asked about anew are put together for the
/// kernels, all others taken one by one.
template <class T>
void ManifoldFinder<T>::find_some(const BodyArrays<T>& bodies, std::span<const std::uint32_t> places,
                                  std::uint32_t block) {
  Waiting<T> boxes, balls, rests;
  Run kept;
  const Pose<T>* const poses = bodies.poses().data();
  for (const std::uint32_t place : places) {
    const IdPair& pair = pairs_[place];
    const Seen &a = seen_[pair.a], &b = seen_[pair.b];
    const int either = a.traits | b.traits, both = a.traits & b.traits;
    if ((either & changed) == 0 && memory_[place].contact != unknown && !(ground_changed_ && (either & fixed) != 0)) {
      keep_last(place, kept, block);
      continue;
    }
    const bool rest = (either & (box | plane)) == (box | plane);
    if (((both & (box | ball)) == 0 && !rest) || (either & trigger) != 0 ||
        ((either & fixed) != 0 && !beside(pair).empty())) {
      copy_last(kept, block);
      find_one(bodies, place, block);
      continue;
    }
    const T margin = least(a.margin, b.margin);
    if ((a.traits & plane) != 0)
      rests.add({b.concrete, a.concrete, poses + pair.b, poses + pair.a, margin}, place);
    else
      (rest                ? rests
       : (both & box) != 0 ? boxes
                           : balls)
          .add({a.concrete, b.concrete, poses + pair.a, poses + pair.b, margin}, place);
  }
  copy_last(kept, block);
  find_boxes(bodies, boxes, block);
  find_balls(balls, block);
  find_rests(rests, block);
  for (const std::uint32_t place : places) found_[block].contacts += results_[place].touches();
}

/// Where what is found of a pair from now on stands.
template <class T>
typename ManifoldFinder<T>::Result& ManifoldFinder<T>::begin(std::uint32_t place, std::uint32_t block) {
  return results_[place] = {block, static_cast<std::uint32_t>(found_[block].manifolds.size()), 0, 0};
}

template <class T>
void ManifoldFinder<T>::keep_apart(std::uint32_t place) {
  results_[place] = {};
  memory_[place].contact = apart;
}

/// Notes the one manifold of a pair, whose points are the last ones that were found.
template <class T>
void ManifoldFinder<T>::keep(std::uint32_t place, std::uint32_t block, bool overlap, const Vec3<T>& normal,
                             std::size_t points) {
  Found& found = found_[block];
  const std::size_t first = found.points.size() - points;
  Result& result = begin(place, block);
  result.manifold_count = 1;
  result.overlap = overlap;
  found.manifolds.push_back({normal, 0, 0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(points)});
  carry_one(memory_[place], std::span(found.points).subspan(first));
}

template <class T>
void ManifoldFinder<T>::find_boxes(const BodyArrays<T>& bodies, const Waiting<T>& boxes, std::uint32_t block) {
  visit_box_contacts(
      boxes.pairs, boxes.count, [&](std::size_t i) { keep_apart(boxes.places[i]); },
      [&](std::size_t i, T distance, const Vec3<T>& normal, const BoxPoints<T>& points) {
        const std::size_t count = points.append(found_[block].points);
        keep(boxes.places[i], block, distance <= T(0), normal, count);
      },
      [&](std::size_t i) { find_one(bodies, boxes.places[i], block); });
}

template <class T>
void ManifoldFinder<T>::find_balls(const Waiting<T>& balls, std::uint32_t block) {
  visit_ball_contacts(
      balls.pairs, balls.count, [&](std::size_t i) { keep_apart(balls.places[i]); },
      [&](std::size_t i, const Vec3<T>& normal, const ContactPoint<T>& point) {
        found_[block].points.push_back({point, {}});
        keep(balls.places[i], block, point.distance <= T(0), normal, 1);
      });
}

template <class T>
void ManifoldFinder<T>::find_rests(const Waiting<T>& rests, std::uint32_t block) {
  visit_rest_contacts(
      rests.pairs, rests.count, [&](std::size_t i) { return (seen_[pairs_[rests.places[i]].a].traits & plane) != 0; },
      [&](std::size_t i) { keep_apart(rests.places[i]); },
      [&](std::size_t i, T distance, const RestPoints<T>& points) {
        const std::size_t count = points.append(found_[block].points);
        keep(rests.places[i], block, distance <= T(0), points.normal(), count);
      });
}

/// Appends a manifold.
template <class T>
void ManifoldFinder<T>::add(const Manifold<T>& manifold, std::uint32_t block) {
  Found& found = found_[block];
  found.manifolds.push_back({manifold.normal, manifold.piece_a, manifold.piece_b,
                             static_cast<std::uint32_t>(found.points.size()),
                             static_cast<std::uint32_t>(manifold.points.size())});
  for (const ContactPoint<T>& p : manifold.points) found.points.push_back({p, {}});
}

template <class T>
void ManifoldFinder<T>::find_one(const BodyArrays<T>& bodies, std::uint32_t place, std::uint32_t block) {
  const IdPair pair = pairs_[place];
  Memory& memory = memory_[place];
  const Seen &seen_a = seen_[pair.a], &seen_b = seen_[pair.b];
  const int either = seen_a.traits | seen_b.traits;
  const Surroundings<T> beside = this->beside(pair);
  const bool anew = (either & changed) != 0 || (ground_changed_ && !beside.empty());
  if (!anew && memory.contact != unknown) {
    Run run;
    keep_last(place, run, block);
    return copy_last(run, block);
  }

  Found& found = found_[block];
  Result& result = begin(place, block);
  const Shape<T>&a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
  const Pose<T>&pose_a = bodies.poses()[pair.a], &pose_b = bodies.poses()[pair.b];
  if ((either & trigger) != 0) {
    result.overlap = any_overlap<T>(a, pose_a, b, pose_b, nullptr);
    if (!result.overlap) keep_apart(place);
    return;
  }
  const std::size_t first_point = found.points.size();
  T margin = least(seen_a.margin, seen_b.margin);
  if (!(margin < std::numeric_limits<T>::infinity())) margin = T(0);
  const bool convex = a.convex() && b.convex();
  if (convex) {
    if (memory.axis != Vec3<T>{} && still_apart(a, pose_a, b, pose_b, memory.axis, margin)) return keep_apart(place);
    Manifold<T> manifold;
    result.overlap = convex_contacts<T>(a, pose_a, b, pose_b, margin, manifold, nullptr) <= T(0);
    const bool none = manifold.points.empty();
    memory.axis = none ? rotate(conjugate(pose_a.rotation), manifold.normal) : Vec3<T>{};
    if (none && !result.overlap) return keep_apart(place);
    if (none) return;
    if (beside.empty()) {
      add(manifold, block);
      result.manifold_count = 1;
      return carry_one(memory, std::span(found.points).subspan(first_point));
    }
  }
  found.composite.clear();
  const T distance = any_contacts<T>(a, pose_a, b, pose_b, margin, found.composite, nullptr, beside);
  if (!convex) result.overlap = distance <= T(0);
  if (!result.overlap && found.composite.empty()) return keep_apart(place);
  for (const Manifold<T>& m : found.composite) add(m, block);
  result.manifold_count = static_cast<std::uint32_t>(found.composite.size());
  carry_many(memory, std::span(found.points).subspan(first_point), found.sorted);
}

/// A pair of which nothing changed has what it had. What stood one behind the other is copied as one.
template <class T>
void ManifoldFinder<T>::keep_last(std::uint32_t place, Run& run, std::uint32_t block) {
  const std::uint32_t contact = memory_[place].contact;
  if (contact == apart) {
    results_[place] = {};
    return;
  }
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
    memory_[i].contact = r.touches() ? place : apart;
    place += r.touches();
  }
}

/// What a pair had after the last call; its points stand one behind the other.
template <class T>
std::span<const SolverPoint<T>> ManifoldFinder<T>::last_points(const Memory& memory) const {
  if (memory.contact >= apart) return {};
  const auto manifolds = last_.manifolds_of(last_.pairs[memory.contact]);
  if (manifolds.empty()) return {};
  const std::size_t first = manifolds.front().first_point;
  return std::span(last_.points).subspan(first, manifolds.back().first_point + manifolds.back().point_count - first);
}

/// To points of the same features, which are single in the one manifold of two convex shapes; mostly they are the same
/// ones in the same order.
template <class T>
void ManifoldFinder<T>::carry_one(const Memory& memory, std::span<SolverPoint<T>> points) const {
  const auto last = last_points(memory);
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
void ManifoldFinder<T>::carry_many(const Memory& memory, std::span<SolverPoint<T>> points,
                                   std::vector<SolverPoint<T>>& sorted) const {
  const auto last = last_points(memory);
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
  std::size_t sum = bytes(seen_) + bytes(bins_.order) + bytes(bins_.bins) + bytes(bins_.types) +
                    bytes(first_neighbour_) + bytes(neighbours_) + bytes(found_) + bytes(pairs_) + bytes(last_pairs_) +
                    bytes(memory_) + bytes(last_memory_) + bytes(results_) + bytes(places_);
  for (const Found& found : found_)
    sum += bytes(found.manifolds) + bytes(found.points) + bytes(found.composite) + bytes(found.sorted);
  for (const ContactArrays<T>* arrays : {&now_, &last_})
    sum += bytes(arrays->pairs) + bytes(arrays->manifolds) + bytes(arrays->points);
  return sum;
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;

}  // namespace graze
