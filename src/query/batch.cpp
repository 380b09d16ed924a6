#include "graze/batch.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "narrow/pairs/closed_form.hpp"
#include "query/batch_portals.hpp"
#include "query/batch_rows.hpp"

namespace graze {

namespace {

/// Asks `question(a, pose_a, b, pose_b)` about one pair.
template <class T, class Question>
auto ask(const Batch<T>& batch, std::size_t i, const Question& question) {
  const IdPair p = batch[i];
  return batch.a().visit(p.a, [&](const Shape<T>& a) {
    return batch.b().visit(p.b,
                           [&](const Shape<T>& b) { return question(a, batch.a().pose(p.a), b, batch.b().pose(p.b)); });
  });
}

template <class T>
void check_poses(const Bodies<T>& bodies, const char* name, std::size_t place, std::size_t i) {
  if (i < bodies.size()) return;
  std::string path = "pairs[";
  path += std::to_string(place);
  path += "].";
  path += name;
  std::string expectation = "a place below ";
  expectation += std::to_string(bodies.size());
  validate::fail(path, expectation, static_cast<double>(i));
}

}  // namespace

template <class T>
Batch<T>::Batch(const Bodies<T>& a, const Bodies<T>& b, std::span<const IdPair> pairs)
    : a_(a), b_(b), pairs_(pairs), size_(pairs.size()) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    check_poses(a, "a", i, pairs[i].a);
    check_poses(b, "b", i, pairs[i].b);
  }
}

template <class T>
Batch<T>::Batch(const Bodies<T>& a, const Bodies<T>& b)
    : a_(a),
      b_(b),
      size_(a.size() == 1   ? b.size()
            : b.size() == 1 ? a.size()
                            : std::max(a.size(), b.size())) {
  if (a.size() != b.size() && a.size() != 1 && b.size() != 1)
    validate::fail("b", "as many bodies as a, or one", static_cast<double>(b.size()));
}

namespace {

/// The kernel that tells whether pairs of A and B touch.
template <class A, class B, class T>
auto overlap_kernel() {
  if constexpr (std::is_same_v<A, Capsule<T>> && std::is_same_v<B, Box<T>>)
    return GRAZE_KERNEL(chosen_isa(), capsule_box_row_overlaps<T>);
  else if constexpr (is_sphere_capsule_and_triangle<A, B>)
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_overlaps<A, T>);
  else
    return GRAZE_KERNEL(chosen_isa(), row_overlaps<A, B, T>);
}
/// And the one for their distances.
template <class A, class B, class T>
auto distance_kernel() {
  if constexpr (std::is_same_v<A, Triangle<T>> && std::is_same_v<B, Triangle<T>>)
    return GRAZE_KERNEL(chosen_isa(), triangle_row_distances<T>);
  else if constexpr (std::is_same_v<B, Box<T>> && !is_sphere_capsule_pair<A, B>)
    return GRAZE_KERNEL(chosen_isa(), box_row_distances<A, B, T>);
  else if constexpr (is_sphere_capsule_and_triangle<A, B>)
    return GRAZE_KERNEL(chosen_isa(), sphere_capsule_triangle_row_distances<A, T>);
  else
    return GRAZE_KERNEL(chosen_isa(), row_distances<A, B, T>);
}

/// A query that has one answer for each pair.
template <class T>
struct Overlaps {
  using Answer = std::uint8_t;
  const Batch<T>& batch;

  template <class A, class B>
  static constexpr bool has_kernel = !std::is_same_v<A, Triangle<T>> || !std::is_same_v<B, Triangle<T>>;
  Answer single(std::size_t i) const {
    return ask(batch, i, [](const auto&... pair) { return overlap(pair...); }) ? 1 : 0;
  }
  template <class A, class B>
  std::uint32_t many(const PairRows<T>& rows, std::size_t count, bool, Answer* to, std::uint8_t* unknown) const {
    return overlap_kernel<A, B, T>()(rows, count, to, unknown);
  }
};
template <class T>
struct Distances {
  using Answer = Distance<T>;
  const Batch<T>& batch;

  template <class A, class B>
  static constexpr bool has_kernel =
      !std::is_same_v<B, Triangle<T>> || is_sphere_capsule_and_triangle<A, B> || std::is_same_v<A, Triangle<T>>;
  Answer single(std::size_t i) const {
    return ask(batch, i, [](const auto&... pair) { return distance(pair...); });
  }
  template <class A, class B>
  std::uint32_t many(const PairRows<T>& rows, std::size_t count, bool turned, Answer* to, std::uint8_t* unknown) const {
    return distance_kernel<A, B, T>()(rows, count, turned, to, unknown);
  }
};

/// Calls `f` with the kinds of a route where the query has a kernel for them.
template <class Query, class T, class F>
constexpr void with_kernel_kinds(Route route, const F& f) {
  with_kinds<T>(route, [&]<class A, class B>() {
    if constexpr (Query::template has_kernel<A, B>) f.template operator()<A, B>();
  });
}

/// For which routes it has.
template <class Query, class T>
struct KernelRoutes {
  bool has[route_count + 1]{};
  constexpr KernelRoutes() {
    for (std::size_t i = 0; i < route_count; ++i)
      with_kernel_kinds<Query, T>(static_cast<Route>(i), [this, i]<class A, class B>() { has[i] = true; });
  }
  constexpr bool operator()(Route route) const { return has[static_cast<std::size_t>(route)]; }
};

/// The answers of a batch whose sides are of one kind each: kernels write them where they are to stand.
template <class Query, class T>
void answer_rows(const Query& query, std::uint8_t queue, typename Query::Answer* answers) {
  const bool turned = is_turned(queue);
  with_kernel_kinds<Query, T>(route_of(queue), [&]<class A, class B>() {
    visit_rows<A, B>(query.batch, turned, [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
      std::uint8_t unknown[row_chunk];
      const std::uint32_t left = query.template many<A, B>(rows, count, turned, answers + first, unknown);
      for (std::uint32_t k = 0; k < left; ++k) answers[first + unknown[k]] = query.single(first + unknown[k]);
    });
  });
}

/// Those of the pairs of a queue.
template <class Query, class T>
void answer_queue(const Query& query, Route route, bool turned, const Queue<T>& queue,
                  typename Query::Answer* answers) {
  with_kernel_kinds<Query, T>(route, [&]<class A, class B>() {
    const QueueRows<A, B, T> copies(queue);
    std::array<typename Query::Answer, row_chunk> found;
    std::uint8_t unknown[row_chunk];
    const std::uint32_t left = query.template many<A, B>(copies.rows(), queue.count, turned, found.data(), unknown);
    for (std::size_t k = 0; k < queue.count; ++k) answers[queue.places[k]] = found[k];
    for (std::uint32_t k = 0; k < left; ++k) answers[queue.places[unknown[k]]] = query.single(queue.places[unknown[k]]);
  });
}

/// The answers of all pairs of a batch, for which there is room. Kernels tell themselves which pairs they do not answer
/// for; `other(i)` answers for a pair of kinds that have none.
template <class Query, class T, class Other>
void answer(const Query& query, const Batch<T>& batch, std::vector<typename Query::Answer>& answers,
            const Other& other) {
  static constexpr KernelRoutes<Query, T> has_kernel;
  const std::uint8_t queue = even_queue(batch);
  if (has_kernel(route_of(queue))) return answer_rows<Query, T>(query, queue, answers.data());
  visit_batch(
      batch, T(0), has_kernel, [](Route) { return true; },
      [&](Route route, bool turned, const Queue<T>& waiting) {
        answer_queue<Query, T>(query, route, turned, waiting, answers.data());
      },
      other);
}

}  // namespace

template <class T>
void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch) {
  touch.resize(batch.size());
  const Overlaps<T> query{batch};
  Portals portals(batch, touch.data(), [&](std::size_t i) { return query.single(i); });
  answer(query, batch, touch, [&](std::size_t i) { portals.add(i); });
  portals.finish();
}

template <class T>
void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances) {
  distances.resize(batch.size());
  const Distances<T> query{batch};
  answer(query, batch, distances, [&](std::size_t i) { distances[i] = query.single(i); });
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template class Batch<T>;                                                                                             \
  template void overlap(const Batch<T>&, std::vector<std::uint8_t>&);                                                  \
  template void distance(const Batch<T>&, std::vector<Distance<T>>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
