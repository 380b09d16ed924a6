#include "graze/world/manifolds.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "world/shares.hpp"
#include "world/waiting.hpp"

namespace graze {

namespace {

/// The number of pairs by which bodies are fetched ahead: some hundred nanoseconds.
constexpr std::size_t ahead = 16;

/// The number of pairs below which work of a nanosecond or two for each is done by one thread.
constexpr std::size_t few_pairs = 4096;

}  // namespace

template <class T, class Space>
void ManifoldFinder<T, Space>::look_at(const BodyArrays<T, Space>& bodies, std::uint32_t i) {
  const Shape& shape = bodies.shapes()[i];
  const bool stands = bodies.fixed()[i] != 0, moved = bodies.changed()[i] != 0;
  const std::uint32_t generation = bodies.id(i).generation;
  const bool another = std::exchange(generations_[i], generation) != generation;
  if constexpr (Space::joins_fixed) {
    const bool stood = (seen_[i].traits & fixed) != 0;  // perhaps as another body of that index
    ground_ += stands;
    ground_ -= stood;
    ground_changed_ |= moved && (stands || stood);
  }
  seen_[i] = {PairContacts<T, Space>::concrete(shape), bodies.margins()[i],
              static_cast<std::uint8_t>((moved ? changed : 0) | (bodies.triggers()[i] != 0 ? trigger : 0) |
                                        (stands ? fixed : 0) | (another ? fresh : 0))};
}

/// Whether no body in the pairs has got a shape of another kind.
template <class T, class Space>
bool ManifoldFinder<T, Space>::kinds_stay(const BodyArrays<T, Space>& bodies) const {
  const std::span<const std::uint32_t> changes = bodies.unsorted_changes();
  return bins_.types.size() == bodies.size() && std::all_of(changes.begin(), changes.end(), [&](std::uint32_t i) {
           return bins_.types[i] == Bins::unseen || bins_.types[i] == bodies.shapes()[i].index();
         });
}

/// Looks at the bodies that changed, or at all where they have come to stand elsewhere in memory.
template <class T, class Space>
void ManifoldFinder<T, Space>::look(const BodyArrays<T, Space>& bodies) {
  ground_changed_ = false;
  generations_.resize(bodies.size());
  const std::span<const std::uint32_t> changes = bodies.unsorted_changes();
  if (bodies.shapes().data() == shapes_ && seen_.size() == bodies.size()) {
    for (const std::uint32_t i : last_changes_) seen_[i].traits &= static_cast<std::uint8_t>(~(changed | fresh));
    for (const std::uint32_t i : changes) look_at(bodies, i);
  } else {
    shapes_ = bodies.shapes().data();
    seen_.assign(bodies.size(), {});
    ground_changed_ = ground_ > 0;  // what stood where is forgotten
    ground_ = 0;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) look_at(bodies, i);
  }
  last_changes_.assign(changes.begin(), changes.end());
}

template <class T, class Space>
auto ManifoldFinder<T, Space>::neighbours_of(std::uint32_t index) const -> std::span<const PlacedRef> {
  return std::span(neighbours_).subspan(around_[index].first, around_[index].count);
}

template <class T, class Space>
void ManifoldFinder<T, Space>::find(const BodyArrays<T, Space>& bodies, std::span<const IdPair> pairs,
                                    Executor& executor, const std::function<void()>& paired) {
  const bool same_pairs = std::equal(pairs.begin(), pairs.end(), pairs_.begin(), pairs_.end());
  if (same_pairs && bodies.unsorted_changes().empty()) return paired();
  const bool same_bins = same_pairs && kinds_stay(bodies);
  SerialExecutor serial;
  Executor& some = pairs.size() < few_pairs ? serial : executor;
  // Three parts that do not depend on each other; the longest, which takes as long as the other two, comes first.
  some.run(3, [&](std::size_t part) {
    if (part == 0 && !same_bins) bin_pairs<T, Space>(pairs, bodies.shapes(), bins_);
    if (part == 1 && !same_pairs) remember(pairs);
    if (part == 2) look(bodies);
  });
  keep_axes_where_of_use();
  std::swap(last_, now_);
  if (ground_ > 1) find_neighbours(bodies);
  ground_changed_ = ground_changed_ || (ground_ > 1 && !same_pairs && ground_pairs_differ());
  if (same_bins && mend(bodies)) return paired();
  find_on_threads(bodies, executor);
  join_pairs(some);
  join_tasks(some, paired);
}

/// Finds the contacts of all pairs. The tasks of the first thread follow each other from the first one on, and its
/// results stay where they are found. All others are put there when everything is found.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_on_threads(const BodyArrays<T, Space>& bodies, Executor& executor) {
  static_assert(pairs_per_task <= most_chunk);
  const std::size_t tasks = (pairs_.size() + pairs_per_task - 1) / pairs_per_task;
  const std::size_t threads = std::clamp<std::size_t>(tasks, 1, executor.concurrency());
  const std::size_t taken_by_first = threads;  // where the first thread puts what it finds of the others' tasks
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

/// Kernels do not use an axis, and for pairs that have one it would be as much memory again as all else about them.
template <class T, class Space>
void ManifoldFinder<T, Space>::keep_axes_where_of_use() {
  using Contacts = PairContacts<T, Space>;
  if (keeps_axes_ || !Contacts::has_axes) return;
  keeps_axes_ = std::any_of(bins_.bins.begin(), bins_.bins.end(), [](const Bin& bin) {
    return !Contacts::has_kernel(Contacts::lanes(bin.type_a, bin.type_b));
  });
  if (keeps_axes_) axes_.assign(pairs_.size(), {});
}

/// The fixed bodies beside a pair. A body that moves goes over the fixed bodies as over one; those that it may touch
/// include the one of this pair.
template <class T, class Space>
auto ManifoldFinder<T, Space>::beside(const IdPair& pair) const -> Surroundings<T, PlacedRef> {
  Surroundings<T, PlacedRef> beside;
  if (ground_ < 2) return beside;
  if ((seen_[pair.a].traits & fixed) != 0) beside.of_a = neighbours_of(pair.b);
  if ((seen_[pair.b].traits & fixed) != 0) beside.of_b = neighbours_of(pair.a);
  if (beside.of_a.size() < 2) beside.of_a = {};
  if (beside.of_b.size() < 2) beside.of_b = {};
  return beside;
}

template <class T, class Space>
void ManifoldFinder<T, Space>::run_task(const BodyArrays<T, Space>& bodies, std::size_t number, std::size_t found) {
  const Refilled<ContactManifold<T, Space>>& manifolds = found_[found].manifolds;
  const Refilled<SolverPoint<T, Space>>& points = found_[found].points;
  Task task{.number = number, .found = found, .first_manifold = manifolds.size(), .first_point = points.size()};
  find_some(bodies, task);
  task.manifold_count = manifolds.size() - task.first_manifold;
  task.point_count = points.size() - task.first_point;
  tasks_[number] = task;
}

/// Finds the contacts of a task's pairs, which follow each other in the bins' order, kind by kind.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_some(const BodyArrays<T, Space>& bodies, Task& task) {
  const std::size_t begin = task.number * pairs_per_task, end = std::min(pairs_.size(), begin + pairs_per_task);
  Waiting<T, Space> waiting;
  const auto ends_before = [](std::size_t place, const Bin& bin) { return place < bin.end; };
  auto bin = std::upper_bound(bins_.bins.begin(), bins_.bins.end(), begin, ends_before);
  for (; bin != bins_.bins.end() && bin->begin < end; ++bin) {
    waiting.lanes = PairContacts<T, Space>::lanes(bin->type_a, bin->type_b);
    const std::size_t first = std::max<std::size_t>(begin, bin->begin), last = std::min<std::size_t>(end, bin->end);
    find_of_a_kind(bodies, std::span(bins_.order).subspan(first, last - first), waiting, task);
  }
}

/// Finds the contacts of pairs of one kind. Pairs that have to be computed anew are put together for the
/// kernel of their kinds, if there is one; all others are taken one by one, and so are those whose contacts
/// the bodies beside may change.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_of_a_kind(const BodyArrays<T, Space>& bodies, std::span<const std::uint32_t> places,
                                              Waiting<T, Space>& waiting, Task& task) {
  using Contacts = PairContacts<T, Space>;
  using Pair = typename Contacts::Pair;
  Run kept;
  const bool together = Contacts::has_kernel(waiting.lanes);
  const Pose* const poses = bodies.poses().data();
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
    waiting.pairs[waiting.count++] = Contacts::is_turned(waiting.lanes)
                                         ? Pair{b.concrete, a.concrete, poses + pair.b, poses + pair.a, margin}
                                         : Pair{a.concrete, b.concrete, poses + pair.a, poses + pair.b, margin};
  }
  copy_last(kept, task);
  find_waiting(bodies, waiting, task);
}

/// Fetches the data of a body that a pair needs. Pairs are sorted by the first of their two, so the second is the one
/// that may stand anywhere.
template <class T, class Space>
void ManifoldFinder<T, Space>::fetch(const BodyArrays<T, Space>& bodies, std::uint32_t i) const {
  __builtin_prefetch(seen_.data() + i);
  __builtin_prefetch(bodies.poses().data() + i);
  __builtin_prefetch(bodies.shapes().data() + i);
}

/// Records a pair that touches, whose manifolds stand one behind the other among those of its thread. The link to its
/// contacts of the last call is overwritten.
template <class T, class Space>
void ManifoldFinder<T, Space>::touch(std::uint32_t place, Task& task, std::size_t first_manifold, std::size_t manifolds,
                                     bool overlap) {
  const auto number = static_cast<std::uint32_t>(task.number * pairs_per_task + task.contacts++);
  touches_[number] = {static_cast<std::uint32_t>(first_manifold - task.first_manifold),
                      static_cast<std::uint32_t>(manifolds), overlap};
  contact_[place] = number;
}

template <class T, class Space>
void ManifoldFinder<T, Space>::keep_apart(std::uint32_t place) {
  contact_[place] = apart;
}

/// Whether the contacts of two convex bodies stay the same when all fixed bodies beside either count.
template <class T, class Space>
bool ManifoldFinder<T, Space>::stays(const BodyArrays<T, Space>& bodies, const IdPair& pair, const Vec& normal,
                                     std::span<const SolverPoint<T, Space>> points) const {
  if constexpr (Space::joins_fixed) {
    const Surroundings<T, PlacedRef> beside = this->beside(pair);
    const auto placed = [&](std::uint32_t i) { return PlacedRef{&bodies.shapes()[i], &bodies.poses()[i]}; };
    return beside.empty() || PairContacts<T, Space>::stays(placed(pair.a), placed(pair.b), beside, normal, points);
  } else {
    return true;
  }
}

/// Records the one manifold of a pair of convex bodies, whose points are the last ones that were found.
template <class T, class Space>
void ManifoldFinder<T, Space>::keep(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task, bool overlap,
                                    const Vec& normal, std::size_t points) {
  Found& found = found_[task.found];
  const std::size_t first = found.points.size() - points;
  const std::span<SolverPoint<T, Space>> of_pair = found.points.filled().subspan(first);
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

/// The sink (`narrow/batch/contact_sink.hpp`) of a task: carries the impulses of a pair on from the last call.
template <class T, class Space>
class ManifoldFinder<T, Space>::TaskSink {
 public:
  using Scalar = T;
  static constexpr std::size_t most = most_chunk;

  TaskSink(ManifoldFinder& finder, const BodyArrays<T, Space>& bodies, const Waiting<T, Space>& waiting, Task& task)
      : finder_(finder),
        bodies_(bodies),
        places_(waiting.places),
        task_(task),
        points_(finder.found_[task.found].points) {}

  void apart(std::size_t i) { finder_.keep_apart(places_[i]); }
  void unknown(std::size_t i) { finder_.find_one(bodies_, places_[i], task_); }
  template <class Contact>
  void one(std::size_t i, const Contact& contact) {
    points_.push_back({contact.point, {}});
    keep(i, contact.point.distance, contact.normal, 1);
  }
  template <class Points>
  void several(std::size_t i, T distance, const Vec& normal, const Points& points, std::size_t) {
    keep(i, distance, normal, points.append(points_));
  }
  /// Takes a pair of the plane: a row of two points, of which those exist whose bits are set.
  template <class Row>
  void row(std::size_t i, bool overlap, const Row& row, unsigned filled) {
    std::size_t points = 0;
    for (unsigned k = 0; k < 2; ++k)
      if ((filled >> k & 1) != 0) {
        points_.push_back({row.points[k], {}});
        ++points;
      }
    finder_.keep(bodies_, places_[i], task_, overlap, row.normal, points);
  }
  template <class Met>
  void met(const Met& some, bool turned) {
    const auto* from = some.points;
    for (std::size_t k = 0; k < some.count; ++k) {
      const std::uint32_t size = some.points_of(k);
      SolverPoint<T, Space>* p = points_.extend(size);
      for (const auto* const end = from + size; from < end; ++from, ++p) *p = {turned ? mirrored(*from) : *from, {}};
      const Vec normal = some.normal(k);
      keep(some.place(k), some.distance(k), turned ? -normal : normal, size);
    }
    fetch_for_writing(points_.data() + points_.size(), some.point_count);
  }

 private:
  void keep(std::size_t i, T distance, const Vec& normal, std::size_t points) {
    finder_.keep(bodies_, places_[i], task_, distance <= T(0), normal, points);
  }

  ManifoldFinder& finder_;
  const BodyArrays<T, Space>& bodies_;
  const std::uint32_t* places_;
  Task& task_;
  Refilled<SolverPoint<T, Space>>& points_;
};

/// Passes the pairs that wait for the kernel to it, and empties the list.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_waiting(const BodyArrays<T, Space>& bodies, Waiting<T, Space>& waiting,
                                            Task& task) {
  const std::size_t count = std::exchange(waiting.count, 0);
  if (count == 0) return;
  TaskSink sink(*this, bodies, waiting, task);
  PairContacts<T, Space>::visit(waiting.lanes, waiting.pairs, count, sink);
}

/// The smaller margin of two bodies; none where neither has a size.
template <class T, class Space>
T ManifoldFinder<T, Space>::margin_of(const IdPair& pair) const {
  const T margin = least(seen_[pair.a].margin, seen_[pair.b].margin);
  return margin < std::numeric_limits<T>::infinity() ? margin : T(0);
}

template <class T, class Space>
void ManifoldFinder<T, Space>::find_one(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task) {
  const IdPair pair = pairs_[place];
  const int either = seen_[pair.a].traits | seen_[pair.b].traits;
  const Shape &a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
  const Pose &pose_a = bodies.poses()[pair.a], &pose_b = bodies.poses()[pair.b];
  using Contacts = PairContacts<T, Space>;
  if ((either & trigger) != 0) {
    const bool overlap = Contacts::overlap(a, pose_a, b, pose_b);
    if (!overlap) return keep_apart(place);
    return touch(place, task, found_[task.found].manifolds.size(), 0, true);
  }
  if constexpr (Contacts::has_axes)
    if (Contacts::is_single(a, b)) return find_single(bodies, place, task);
  find_composite(bodies, place, task);
}

/// Finds the contacts of two convex bodies: the axis in which they were apart is tried first.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_single(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task) {
  const IdPair pair = pairs_[place];
  const Shape &a = bodies.shapes()[pair.a], &b = bodies.shapes()[pair.b];
  const Pose &pose_a = bodies.poses()[pair.a], &pose_b = bodies.poses()[pair.b];
  using Contacts = PairContacts<T, Space>;
  if constexpr (Contacts::has_axes) {
    const T margin = margin_of(pair);
    Vec* const axis = keeps_axes_ ? &axes_[place] : nullptr;
    if (axis && *axis != Vec{} && Contacts::still_apart(a, pose_a, b, pose_b, *axis, margin)) return keep_apart(place);
    typename Space::Manifold manifold;
    const bool overlap = Contacts::single(a, pose_a, b, pose_b, margin, manifold);
    const bool none = manifold.points.empty();
    if (axis) *axis = none ? Contacts::in_frame(pose_a, manifold.normal) : Vec{};
    if (none && !overlap) return keep_apart(place);
    if (none) return touch(place, task, found_[task.found].manifolds.size(), 0, true);
    for (const auto& p : manifold.points) found_[task.found].points.push_back({p, {}});
    keep(bodies, place, task, overlap, manifold.normal, manifold.points.size());
  }
}

/// Finds the contacts of a body that consists of pieces, or meets several fixed bodies as if they were one.
template <class T, class Space>
void ManifoldFinder<T, Space>::find_composite(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task) {
  const IdPair pair = pairs_[place];
  Found& found = found_[task.found];
  const std::size_t first_point = found.points.size();
  found.composite.clear();
  const bool overlap =
      PairContacts<T, Space>::all(bodies.shapes()[pair.a], bodies.poses()[pair.a], bodies.shapes()[pair.b],
                                  bodies.poses()[pair.b], margin_of(pair), found.composite, beside(pair));
  if (!overlap && found.composite.empty()) return keep_apart(place);
  const std::size_t first_manifold = found.manifolds.size();
  for (const auto& m : found.composite) {
    found.manifolds.push_back({m.normal, m.piece_a, m.piece_b, static_cast<std::uint32_t>(found.points.size()),
                               static_cast<std::uint32_t>(m.points.size())});
    for (const auto& p : m.points) found.points.push_back({p, {}});
  }
  if (found.points.size() - first_point > points_per_pair_) reduce_many(found, first_manifold, first_point);
  carry_many(place, found.points.filled().subspan(first_point), found.sorted);
  touch(place, task, first_manifold, found.manifolds.size() - first_manifold, overlap);
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;
template class ManifoldFinder<float, plane::Space<float>>;
template class ManifoldFinder<double, plane::Space<double>>;

}  // namespace graze
