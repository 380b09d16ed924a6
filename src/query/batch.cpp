#include "graze/batch.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "narrow/closed_form.hpp"
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

/// Whether pairs touch whose sides are both arrays of A; `single(i)` answers for those that kernels do not take.
template <class A, class T, class Single>
void overlap_rows(const Batch<T>& batch, std::uint8_t* touch, const Single& single) {
  constexpr std::uint8_t unknown = 2;
  const auto kernel = GRAZE_KERNEL(chosen_isa(), row_overlaps<A, T>);
  visit_rows<A, A>(batch, false, [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
    kernel(rows, count, touch + first);
    std::uint8_t all = 0;
    for (std::size_t i = first; i < first + count; ++i) all |= touch[i];
    for (std::size_t i = first; all >= unknown && i < first + count; ++i)
      if (touch[i] == unknown) single(i);
  });
}

}  // namespace

template <class T>
void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch) {
  touch.resize(batch.size());
  const auto single = [&](std::size_t i) {
    touch[i] = ask(batch, i, [](const auto&... pair) { return overlap(pair...); }) ? 1 : 0;
  };
  const Route route_of_all = route_of(even_queue(batch));
  if (route_of_all == Route::sphere_sphere) return overlap_rows<Sphere<T>>(batch, touch.data(), single);
  if (route_of_all == Route::box_box) return overlap_rows<Box<T>>(batch, touch.data(), single);
  const Isa level = chosen_isa();
  visit_batch(
      batch, T(0), [](Route route) { return route == Route::sphere_sphere || route == Route::box_box; }, true,
      [&](Route route, bool, const Queue<T>& queue) {
        std::array<std::uint8_t, box_chunk> found;
        const auto kernel = route == Route::sphere_sphere ? GRAZE_KERNEL(level, sphere_overlaps<T>)
                                                          : GRAZE_KERNEL(level, box_overlaps<T>);
        kernel(queue.pairs.data(), queue.count, found.data());
        // Not asked of the queue each time: what is written could for all the compiler knows be part of it.
        const std::size_t count = queue.count, *const places = queue.places.data();
        std::uint8_t* const to = touch.data();
        std::uint8_t all = 0;
        for (std::size_t k = 0; k < count; ++k) {
          to[places[k]] = found[k];
          all |= found[k];
        }
        for (std::size_t k = 0; all > 1 && k < count; ++k)
          if (found[k] > 1) single(places[k]);
      },
      single);
}

template <class T>
void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances) {
  distances.resize(batch.size());
  const Isa level = chosen_isa();
  const auto single = [&](std::size_t i) {
    distances[i] = ask(batch, i, [](const auto&... pair) { return distance(pair...); });
  };
  visit_batch(
      batch, T(0), [](Route route) { return route <= Route::box_box; }, false,
      [&](Route route, bool turned, const Queue<T>& queue) {
        std::array<Distance<T>, bundled(box_chunk)> found;
        std::array<std::uint8_t, box_chunk> proven;
        const auto ask_kernel = [&]<class A, class B>() {
          if constexpr (is_round_pair<A, B>) {
            GRAZE_KERNEL(level, round_distances<A, B, T>)(queue.pairs.data(), queue.count, found.data());
            proven.fill(1);
          } else {
            GRAZE_KERNEL(level, box_distances<A, B, T>)(queue.pairs.data(), queue.count, found.data(), proven.data());
          }
        };
        if (route == Route::box_box)
          ask_kernel.template operator()<Box<T>, Box<T>>();
        else
          with_round_kinds<T>(route, ask_kernel);
        for (std::size_t k = 0; k < queue.count; ++k) {
          if (proven[k])
            distances[queue.places[k]] = turned ? mirrored(found[k]) : found[k];
          else
            single(queue.places[k]);
        }
      },
      single);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template class Batch<T>;                                                                                             \
  template void overlap(const Batch<T>&, std::vector<std::uint8_t>&);                                                  \
  template void distance(const Batch<T>&, std::vector<Distance<T>>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
