// The results of threads, put one behind the other.
#include <algorithm>
#include <utility>

#include "composite/composite.hpp"
#include "graze/plane/space.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

namespace {

/// Pairs in a range, and tasks that are copied at a time: some microseconds of work each.
constexpr std::size_t pairs_per_range = 4096, tasks_per_copy = 8;

}  // namespace

/// Lists the pairs that touch, in their order.
template <class T, class Space>
void ManifoldFinder<T, Space>::join_pairs(Executor& executor) {
  std::size_t manifolds = 0, points = 0;
  for (Task& task : tasks_) {
    task.to_manifold = std::exchange(manifolds, manifolds + task.manifold_count);
    task.to_point = std::exchange(points, points + task.point_count);
  }
  now_.manifolds.resize(manifolds);
  now_.points.resize(points);

  std::uint32_t contacts = 0;
  first_contacts_.clear();
  const auto touches = [](std::uint32_t contact) { return contact < apart; };
  for (std::size_t first = 0; first < pairs_.size(); first += pairs_per_range) {
    const auto some = std::span(contact_).subspan(first, std::min(pairs_.size() - first, pairs_per_range));
    first_contacts_.push_back(contacts);
    contacts += static_cast<std::uint32_t>(std::count_if(some.begin(), some.end(), touches));
  }
  now_.pairs.resize(contacts);
  for_each_chunk(executor, pairs_.size(), pairs_per_range, [&](std::size_t begin, std::size_t end, std::size_t range) {
    join_pairs(begin, end, first_contacts_[range]);
  });
}

/// Lists the touching pairs of those from `begin` to `end`, the first at `place`.
template <class T, class Space>
void ManifoldFinder<T, Space>::join_pairs(std::size_t begin, std::size_t end, std::uint32_t place) {
  // A branch on which pairs touch would be mispredicted often: each is written down, and written over by the next one
  // where it does not.
  std::uint32_t touching[pairs_per_range];
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    touching[count] = static_cast<std::uint32_t>(i);
    count += contact_[i] < apart ? 1 : 0;
  }
  for (const std::uint32_t i : std::span(touching).first(count)) {
    const std::uint32_t number = std::exchange(contact_[i], place);
    const Touch& touch = touches_[number];
    const std::size_t first = tasks_[number / pairs_per_task].to_manifold + touch.first_manifold;
    now_.pairs[place++] = {pairs_[i].a, pairs_[i].b, touch.overlap, static_cast<std::uint32_t>(first),
                           touch.manifold_count};
  }
}

/// Copies the manifolds and points, task by task; beside that `paired` runs, the caller's own work on the pairs, which
/// takes longer than any of the copies and is begun first.
template <class T, class Space>
void ManifoldFinder<T, Space>::join_tasks(Executor& executor, const std::function<void()>& paired) {
  const bool in_place = std::all_of(tasks_.begin(), tasks_.end(), [](const Task& task) { return task.found == 0; });
  if (in_place) return paired();
  executor.run(1 + (tasks_.size() + tasks_per_copy - 1) / tasks_per_copy, [&](std::size_t i) {
    if (i == 0) return paired();
    const std::size_t begin = (i - 1) * tasks_per_copy, end = std::min(tasks_.size(), begin + tasks_per_copy);
    for (const Task& task : std::span(tasks_).subspan(begin, end - begin))
      if (task.found != 0) join_task(task);
  });
}

template <class T, class Space>
void ManifoldFinder<T, Space>::join_task(const Task& task) {
  const Found& found = found_[task.found];
  const auto shift = static_cast<std::uint32_t>(task.to_point - task.first_point);  // modulo its range
  ContactManifold<T, Space>* to = now_.manifolds.data() + task.to_manifold;
  for (ContactManifold<T, Space> m : found.manifolds.filled().subspan(task.first_manifold, task.manifold_count)) {
    m.first_point += shift;
    *to++ = m;
  }
  std::copy_n(found.points.filled().data() + task.first_point, task.point_count, now_.points.data() + task.to_point);
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;
template class ManifoldFinder<float, plane::Space<float>>;
template class ManifoldFinder<double, plane::Space<double>>;

}  // namespace graze
