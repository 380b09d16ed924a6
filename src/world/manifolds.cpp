#include "graze/world/manifolds.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "composite/composite.hpp"
#include "composite/internal_edges/face_contact.hpp"
#include "narrow/batch/lane_pairs.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/sat/cached_axis.hpp"
#include "world/shares.hpp"

namespace graze {

namespace {

/// Pairs ahead of the one that is looked at, of which the bodies are fetched: some hundred nanoseconds.
constexpr std::size_t ahead = 16;

/// Pairs below which no second thread is asked for what takes each a nanosecond or two.
constexpr std::size_t few_pairs = 4096;

}  // namespace

/// Pairs that wait for a kernel, all for the same.
template <class T>
struct Waiting {
  LanesFor lanes;
  std::size_t count = 0;
  PairRef<T> pairs[most_chunk];
  std::uint32_t places[most_chunk];
};

template <class T>
void ManifoldFinder<T>::look_at(const BodyArrays<T>& bodies, std::uint32_t i) {
  const Shape<T>& shape = bodies.shapes()[i];
  const bool stands = bodies.fixed()[i] != 0, moved = bodies.changed()[i] != 0;
  const std::uint32_t generation = bodies.id(i).generation;
  const bool another = std::exchange(generations_[i], generation) != generation;
  ground_ += stands;
  ground_ -= (seen_[i].traits & fixed) != 0;
  seen_[i] = {concrete_for_lanes(shape), bodies.margins()[i],
              static_cast<std::uint8_t>((moved ? changed : 0) | (bodies.triggers()[i] != 0 ? trigger : 0) |
                                        (stands ? fixed : 0) | (another ? fresh : 0))};
  ground_changed_ |= stands && moved;
}

/// Looks at what changed, or at all bodies where they have come to stand elsewhere in memory.
template <class T>
void ManifoldFinder<T>::look(const BodyArrays<T>& bodies) {
  ground_changed_ = false;
  generations_.resize(bodies.size());
  const std::span<const std::uint32_t> changes = bodies.unsorted_changes();
  if (bodies.shapes().data() == shapes_ && seen_.size() == bodies.size()) {
    for (const std::uint32_t i : last_changes_) seen_[i].traits &= static_cast<std::uint8_t>(~(changed | fresh));
    for (const std::uint32_t i : changes) look_at(bodies, i);
  } else {
    shapes_ = bodies.shapes().data();
    seen_.assign(bodies.size(), {});
    ground_ = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) look_at(bodies, i);
  }
  last_changes_.assign(changes.begin(), changes.end());
}

template <class T>
std::span<const PlacedRef<T>> ManifoldFinder<T>::neighbours_of(std::uint32_t index) const {
  return std::span(neighbours_).subspan(around_[index].first, around_[index].count);
}

template <class T>
void ManifoldFinder<T>::find(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, Executor& executor,
                             const std::function<void()>& paired) {
  if (bodies.unsorted_changes().empty() && std::equal(pairs.begin(), pairs.end(), pairs_.begin(), pairs_.end()))
    return paired();
  SerialExecutor serial;
  Executor& some = pairs.size() < few_pairs ? serial : executor;
  // Three parts that know nothing of each other, the longest, which takes as long as the other two, first.
  bool same_pairs = false;
  some.run(3, [&](std::size_t part) {
    if (part == 0) bin_pairs<T>(pairs, bodies.shapes(), bins_);
    if (part == 1) same_pairs = !remember(pairs);
    if (part == 2) look(bodies);
  });
  keep_axes_where_of_use();
  std::swap(last_, now_);
  if (ground_ > 1) find_neighbours(bodies);
  ground_changed_ = ground_changed_ || (ground_ > 1 && !same_pairs && ground_pairs_differ());
  find_on_threads(bodies, executor);
  join_pairs(some);
  join_tasks(some, paired);
}

/// The tasks of the first thread follow each other from the first one on: what it finds of them stands where it stays.
/// All else is put there when everything is found, from wherever its thread had it.
template <class T>
void ManifoldFinder<T>::find_on_threads(const BodyArrays<T>& bodies, Executor& executor) {
  static_assert(pairs_per_task <= most_chunk);
  const std::size_t tasks = (pairs_.size() + pairs_per_task - 1) / pairs_per_task;
  const std::size_t threads = std::clamp<std::size_t>(tasks, 1, executor.concurrency());
  const std::size_t taken_by_first = threads;  // what the first thread takes of the others' tasks
  if (found_.size() < threads + 1) found_.resize(threads + 1);
  now_.manifolds.swap(found_[0].manifolds.room());
  now_.points.swap(found_[0].points.room());
  for (Found& found : found_) {
    found.manifolds.clear();
    found.points.clear();
  }
  tasks_.resize(tasks);
  touches_.resize(tasks * pairs_per_task);
  Shares shares(tasks, threads);
  executor.run(threads, [&](std::size_t thread) {
    std::size_t task = 0;
    while (shares.take_own(thread, task)) run_task(bodies, task, thread);
    while (shares.take_other(thread, task)) run_task(bodies, task, thread == 0 ? taken_by_first : thread);
  });
  now_.manifolds.swap(found_[0].manifolds.room());
  now_.points.swap(found_[0].points.room());
}

/// Kernels do not look at an axis, and for pairs that have one it would be as much memory again as all else about them.
template <class T>
void ManifoldFinder<T>::keep_axes_where_of_use() {
  if (keeps_axes_) return;
  keeps_axes_ = std::any_of(bins_.bins.begin(), bins_.bins.end(), [](const Bin& bin) {
    return !with_contact_lanes(lane_table<T>(bin.type_a, bin.type_b).pair);
  });
  if (keeps_axes_) axes_.assign(pairs_.size(), {});
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

template <class T>
void ManifoldFinder<T>::run_task(const BodyArrays<T>& bodies, std::size_t number, std::size_t found) {
  const Refilled<ContactManifold<T>>& manifolds = found_[found].manifolds;
  const Refilled<SolverPoint<T>>& points = found_[found].points;
  Task task{.number = number, .found = found, .first_manifold = manifolds.size(), .first_point = points.size()};
  find_some(bodies, task);
  task.manifold_count = manifolds.size() - task.first_manifold;
  task.point_count = points.size() - task.first_point;
  tasks_[number] = task;
}

/// The pairs of a task, which follow each other in the bins' order, kind by kind.
template <class T>
void ManifoldFinder<T>::find_some(const BodyArrays<T>& bodies, Task& task) {
  const std::size_t begin = task.number * pairs_per_task, end = std::min(pairs_.size(), begin + pairs_per_task);
  Waiting<T> waiting;
  const auto ends_before = [](std::size_t place, const Bin& bin) { return place < bin.end; };
  auto bin = std::upper_bound(bins_.bins.begin(), bins_.bins.end(), begin, ends_before);
  for (; bin != bins_.bins.end() && bin->begin < end; ++bin) {
    waiting.lanes = lane_table<T>(bin->type_a, bin->type_b);
    const std::size_t first = std::max<std::size_t>(begin, bin->begin), last = std::min<std::size_t>(end, bin->end);
    find_of_a_kind(bodies, std::span(bins_.order).subspan(first, last - first), waiting, task);
  }
}

/// Pairs of kinds with a kernel that are to be asked about anew are put together for it, all others taken one by one;
/// so are those whose contacts what stands beside may change.
template <class T>
void ManifoldFinder<T>::find_of_a_kind(const BodyArrays<T>& bodies, std::span<const std::uint32_t> places,
                                       Waiting<T>& waiting, Task& task) {
  Run kept;
  const bool together = with_contact_lanes(waiting.lanes.pair);
  const Pose<T>* const poses = bodies.poses().data();
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k + ahead < places.size()) fetch(bodies, pairs_[places[k + ahead]].b);
    const std::uint32_t place = places[k];
    const IdPair& pair = pairs_[place];
    const Seen &a = seen_[pair.a], &b = seen_[pair.b];
    const int either = a.traits | b.traits;
    if ((either & fresh) != 0) contact_[place] = unknown;
    if ((either & changed) == 0 && contact_[place] != unknown && !(ground_changed_ && (either & fixed) != 0)) {
      keep_last(place, kept, task);
      continue;
    }
    if (!together || !a.concrete || !b.concrete || (either & trigger) != 0) {
      copy_last(kept, task);
      find_one(bodies, place, task);
      continue;
    }
    const T margin = least(a.margin, b.margin);
    waiting.places[waiting.count] = place;
    waiting.pairs[waiting.count++] = waiting.lanes.turned
                                         ? PairRef<T>{b.concrete, a.concrete, poses + pair.b, poses + pair.a, margin}
                                         : PairRef<T>{a.concrete, b.concrete, poses + pair.a, poses + pair.b, margin};
  }
  copy_last(kept, task);
  find_waiting(bodies, waiting, task);
}

/// Fetches what a pair asks of a body. Pairs are sorted by the first of their two, so the second is the one that may
/// stand anywhere.
template <class T>
void ManifoldFinder<T>::fetch(const BodyArrays<T>& bodies, std::uint32_t i) const {
  __builtin_prefetch(seen_.data() + i);
  __builtin_prefetch(bodies.poses().data() + i);
  __builtin_prefetch(bodies.shapes().data() + i);
}

/// Notes a pair that touches, whose manifolds stand one behind the other among what its thread found. What is known of
/// it from the last call is forgotten.
template <class T>
void ManifoldFinder<T>::touch(std::uint32_t place, Task& task, std::size_t first_manifold, std::size_t manifolds,
                              bool overlap) {
  const auto number = static_cast<std::uint32_t>(task.number * pairs_per_task + task.contacts++);
  touches_[number] = {static_cast<std::uint32_t>(first_manifold - task.first_manifold),
                      static_cast<std::uint32_t>(manifolds), overlap};
  contact_[place] = number;
}

template <class T>
void ManifoldFinder<T>::keep_apart(std::uint32_t place) {
  contact_[place] = apart;
}

/// Whether the contacts of two convex bodies are what they are of all that stands still beside either, too.
template <class T>
bool ManifoldFinder<T>::stays(const BodyArrays<T>& bodies, const IdPair& pair, const Vec3<T>& normal,
                              std::span<const SolverPoint<T>> points) const {
  const Surroundings<T> beside = this->beside(pair);
  if (beside.empty()) return true;
  const auto piece = [&](std::uint32_t i, std::span<const PlacedRef<T>> around) {
    const Shape<T>& shape = bodies.shapes()[i];
    const Pose<T>& pose = bodies.poses()[i];
    return LeafInContext<T>{shape, pose, shape, pose, around};
  };
  const LeafInContext<T> a = piece(pair.a, beside.of_a), b = piece(pair.b, beside.of_b);
  return (a.beside.empty() || stands_clear(a, b, normal, standing_point(points, &ContactPoint<T>::a))) &&
         (b.beside.empty() || stands_clear(b, a, -normal, standing_point(points, &ContactPoint<T>::b)));
}

/// Notes the one manifold of a pair of convex bodies, whose points are the last ones that were found.
template <class T>
void ManifoldFinder<T>::keep(const BodyArrays<T>& bodies, std::uint32_t place, Task& task, bool overlap,
                             const Vec3<T>& normal, std::size_t points) {
  Found& found = found_[task.found];
  const std::size_t first = found.points.size() - points;
  const std::span<SolverPoint<T>> of_pair = found.points.filled().subspan(first);
  if (!stays(bodies, pairs_[place], normal, of_pair)) {
    found.points.shorten(first);
    return find_composite(bodies, place, task);
  }
  if (points > points_per_pair_) points = reduce_one(found, normal, first);
  if (points == 0) return touch(place, task, found.manifolds.size(), 0, overlap);
  carry_one(place, of_pair.first(points));
  touch(place, task, found.manifolds.size(), 1, overlap);
  found.manifolds.push_back({normal, 0, 0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(points)});
}

/// The sink (`narrow/batch/contact_sink.hpp`) of a task: carries on what is kept of a pair from the last call.
template <class T>
class ManifoldFinder<T>::TaskSink {
 public:
  using Scalar = T;
  static constexpr std::size_t most = most_chunk;

  TaskSink(ManifoldFinder& finder, const BodyArrays<T>& bodies, const Waiting<T>& waiting, Task& task)
      : finder_(finder),
        bodies_(bodies),
        places_(waiting.places),
        task_(task),
        points_(finder.found_[task.found].points) {}

  void apart(std::size_t i) { finder_.keep_apart(places_[i]); }
  void unknown(std::size_t i) { finder_.find_one(bodies_, places_[i], task_); }
  void one(std::size_t i, const PointContact<T>& contact) {
    points_.push_back({contact.point, {}});
    keep(i, contact.point.distance, contact.normal, 1);
  }
  template <class Points>
  void several(std::size_t i, T distance, const Vec3<T>& normal, const Points& points, std::size_t) {
    keep(i, distance, normal, points.append(points_));
  }
  void met(const MetPairs<T>& some, bool turned) {
    const ContactPoint<T>* from = some.points;
    for (std::size_t k = 0; k < some.count; ++k) {
      const std::uint32_t size = some.points_of(k);
      SolverPoint<T>* p = points_.extend(size);
      for (const ContactPoint<T>* const end = from + size; from < end; ++from, ++p)
        *p = {turned ? mirrored(*from) : *from, {}};
      const Vec3<T> normal = some.normal(k);
      keep(some.place(k), some.distance(k), turned ? -normal : normal, size);
    }
    fetch_for_writing(points_.data() + points_.size(), some.point_count);
  }

 private:
  void keep(std::size_t i, T distance, const Vec3<T>& normal, std::size_t points) {
    finder_.keep(bodies_, places_[i], task_, distance <= T(0), normal, points);
  }

  ManifoldFinder& finder_;
  const BodyArrays<T>& bodies_;
  const std::uint32_t* places_;
  Task& task_;
  Refilled<SolverPoint<T>>& points_;
};

/// Asks the kernel about the pairs that wait for it; then none do.
template <class T>
void ManifoldFinder<T>::find_waiting(const BodyArrays<T>& bodies, Waiting<T>& waiting, Task& task) {
  const std::size_t count = std::exchange(waiting.count, 0);
  if (count == 0) return;
  TaskSink sink(*this, bodies, waiting, task);
  visit_lane_contacts(waiting.lanes, waiting.pairs, count, sink);
}

/// Of two bodies the smaller margin; none of two that have no size.
template <class T>
T ManifoldFinder<T>::margin_of(const IdPair& pair) const {
  const T margin = least(seen_[pair.a].margin, seen_[pair.b].margin);
  return margin < std::numeric_limits<T>::infinity() ? margin : T(0);
}

template <class T>
void ManifoldFinder<T>::find_one(const BodyArrays<T>& bodies, std::uint32_t place, Task& task) {
  const IdPair pair = pairs_[place];
  const int either = seen_[pair.a].traits | seen_[pair.b].traits;
  const Shape<T>&a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
  const Pose<T>&pose_a = bodies.poses()[pair.a], &pose_b = bodies.poses()[pair.b];
  if ((either & trigger) != 0) {
    const bool overlap = any_overlap<T>(a, pose_a, b, pose_b);
    if (!overlap) return keep_apart(place);
    return touch(place, task, found_[task.found].manifolds.size(), 0, true);
  }
  if (!a.convex() || !b.convex()) return find_composite(bodies, place, task);
  const T margin = margin_of(pair);
  Vec3<T>* const axis = keeps_axes_ ? &axes_[place] : nullptr;
  if (axis && *axis != Vec3<T>{} && still_apart(a, pose_a, b, pose_b, *axis, margin)) return keep_apart(place);
  Manifold<T> manifold;
  const bool overlap = convex_contacts<T>(a, pose_a, b, pose_b, margin, manifold) <= T(0);
  const bool none = manifold.points.empty();
  if (axis) *axis = none ? rotate(conjugate(pose_a.rotation), manifold.normal) : Vec3<T>{};
  if (none && !overlap) return keep_apart(place);
  if (none) return touch(place, task, found_[task.found].manifolds.size(), 0, true);
  for (const ContactPoint<T>& p : manifold.points) found_[task.found].points.push_back({p, {}});
  keep(bodies, place, task, overlap, manifold.normal, manifold.points.size());
}

/// What consists of pieces, or meets several bodies that stand still as if they were one.
template <class T>
void ManifoldFinder<T>::find_composite(const BodyArrays<T>& bodies, std::uint32_t place, Task& task) {
  const IdPair pair = pairs_[place];
  Found& found = found_[task.found];
  const std::size_t first_point = found.points.size();
  found.composite.clear();
  const T distance = any_contacts<T>(bodies.shapes()[pair.a], bodies.poses()[pair.a], bodies.shapes()[pair.b],
                                     bodies.poses()[pair.b], margin_of(pair), found.composite, beside(pair));
  const bool overlap = distance <= T(0);
  if (!overlap && found.composite.empty()) return keep_apart(place);
  const std::size_t first_manifold = found.manifolds.size();
  for (const Manifold<T>& m : found.composite) {
    found.manifolds.push_back({m.normal, m.piece_a, m.piece_b, static_cast<std::uint32_t>(found.points.size()),
                               static_cast<std::uint32_t>(m.points.size())});
    for (const ContactPoint<T>& p : m.points) found.points.push_back({p, {}});
  }
  if (found.points.size() - first_point > points_per_pair_) reduce_many(found, first_manifold, first_point);
  carry_many(place, found.points.filled().subspan(first_point), found.sorted);
  touch(place, task, first_manifold, found.manifolds.size() - first_manifold, overlap);
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;

}  // namespace graze
