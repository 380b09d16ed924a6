#include "graze/batch.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "narrow/ball_batch.hpp"
#include "narrow/box_batch.hpp"
#include "narrow/closed_form.hpp"
#include "narrow/convex_pair.hpp"
#include "narrow/pair_kernels.hpp"

namespace graze {

namespace {

using detail::kind_of;

/// What is loaded for one kernel is near when the next one wants it.
constexpr std::size_t chunk = box_chunk;

/// Pairs that wait for a kernel, with their places in the batch.
template <class T>
struct Queue {
  std::array<PairRef<T>, chunk> pairs;
  std::array<std::size_t, chunk> places;
  std::size_t count = 0;

  void add(const PairRef<T>& pair, std::size_t place) {
    pairs[count] = pair;
    places[count++] = place;
  }
  bool full() const { return count == chunk; }
};

template <class T>
PairRef<T> pair_ref(const Batch<T>& batch, const IdPair& p, T margin) {
  return {batch.a().concrete(p.a), batch.b().concrete(p.b), &batch.a().pose(p.a), &batch.b().pose(p.b), margin};
}
template <class T>
PairRef<T> swapped(const PairRef<T>& pair) {
  return {pair.b, pair.a, pair.pose_b, pair.pose_a, pair.margin};
}

/// Whether a body is what kernels take for its kind: not rounded, a capsule even, a box with a length along every side.
template <class T>
bool plain(const Bodies<T>& bodies, std::size_t i, std::size_t kind, const void* concrete) {
  if (bodies.margin(i) != T(0)) return false;
  if (kind == kind_of<Capsule<T>, T>()) return !static_cast<const Capsule<T>*>(concrete)->tapered();
  if (kind == kind_of<Box<T>, T>()) return regular_box(static_cast<const Box<T>*>(concrete)->half_extents());
  return kind == kind_of<Sphere<T>, T>();
}

/// The two kinds of a pair as one number.
template <class T>
constexpr std::size_t both(std::size_t kind_a, std::size_t kind_b) {
  return kind_a * Shape<T>::count + kind_b;
}
template <class A, class B, class T>
constexpr std::size_t both() {
  return both<T>(kind_of<A, T>(), kind_of<B, T>());
}

/// Goes through the batch in chunks. `queue_of(kinds)` says for which of the `queues` a pair of plain shapes is, as
/// their number or -1, and whether it has to be turned round; `run(queue number, queue)` asks a kernel; `single(i)` asks
/// about one pair.
template <std::size_t queues, class T, class QueueOf, class Run, class Single>
void visit_batch(const Batch<T>& batch, T margin, const QueueOf& queue_of, const Run& run, const Single& single) {
  std::array<Queue<T>, queues> waiting;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const std::size_t kind_a = batch.a().kind(p.a), kind_b = batch.b().kind(p.b);
    const auto [queue, turned] = queue_of(both<T>(kind_a, kind_b));
    if (queue < 0) {
      single(i);
      continue;
    }
    const PairRef<T> pair = pair_ref(batch, p, margin);
    if (!plain(batch.a(), p.a, kind_a, pair.a) || !plain(batch.b(), p.b, kind_b, pair.b)) {
      single(i);
      continue;
    }
    const auto number = static_cast<std::size_t>(queue);
    waiting[number].add(turned ? swapped(pair) : pair, i);
    if (!waiting[number].full()) continue;
    run(number, waiting[number]);
    waiting[number].count = 0;
  }
  for (std::size_t number = 0; number < queues; ++number)
    if (waiting[number].count > 0) run(number, waiting[number]);
}

/// Which kernel of `closed_distances` answers for two kinds, and whether for the pair the other way round.
template <class T>
std::pair<int, bool> closed_form_of(std::size_t kinds) {
  using B = Box<T>;
  using C = Capsule<T>;
  using S = Sphere<T>;
  if (kinds == both<S, S, T>()) return {0, false};
  if (kinds == both<S, C, T>()) return {1, false};
  if (kinds == both<C, S, T>()) return {1, true};
  if (kinds == both<B, S, T>()) return {2, false};
  if (kinds == both<S, B, T>()) return {2, true};
  if (kinds == both<C, C, T>()) return {3, false};
  return {-1, false};
}

template <class T>
void run_closed_form(std::size_t number, const Queue<T>& queue, Distance<T>* found) {
  const Isa level = chosen_isa();
  using Kernel = void (*)(const PairRef<T>*, std::size_t, Distance<T>*);
  const Kernel kernels[] = {GRAZE_KERNEL(level, closed_distances<Sphere<T>, Sphere<T>, T>),
                            GRAZE_KERNEL(level, closed_distances<Sphere<T>, Capsule<T>, T>),
                            GRAZE_KERNEL(level, closed_distances<Box<T>, Sphere<T>, T>),
                            GRAZE_KERNEL(level, closed_distances<Capsule<T>, Capsule<T>, T>)};
  kernels[number](queue.pairs.data(), queue.count, found);
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

template <class T>
void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch) {
  touch.resize(batch.size());
  constexpr int spheres = 0, boxes = 1;
  constexpr auto queue_of = [](std::size_t kinds) {
    return std::pair{kinds == both<Sphere<T>, Sphere<T>, T>() ? spheres
                     : kinds == both<Box<T>, Box<T>, T>()     ? boxes
                                                              : -1,
                     false};
  };
  const Isa level = chosen_isa();
  visit_batch<2>(
      batch, T(0), queue_of,
      [&](std::size_t number, const Queue<T>& queue) {
        std::array<std::uint8_t, chunk> found;
        const auto kernel =
            number == spheres ? GRAZE_KERNEL(level, sphere_overlaps<T>) : GRAZE_KERNEL(level, box_overlaps<T>);
        kernel(queue.pairs.data(), queue.count, found.data());
        for (std::size_t k = 0; k < queue.count; ++k) touch[queue.places[k]] = found[k];
      },
      [&](std::size_t i) {
        const IdPair p = batch[i];
        touch[i] =
            overlap(batch.a().shape(p.a), batch.a().pose(p.a), batch.b().shape(p.b), batch.b().pose(p.b)) ? 1 : 0;
      });
}

template <class T>
void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances) {
  distances.resize(batch.size());
  visit_batch<4>(
      batch, T(0), closed_form_of<T>,
      [&](std::size_t number, const Queue<T>& queue) {
        std::array<Distance<T>, chunk> found;
        run_closed_form(number, queue, found.data());
        for (std::size_t k = 0; k < queue.count; ++k) {
          const IdPair p = batch[queue.places[k]];
          const bool turned = closed_form_of<T>(both<T>(batch.a().kind(p.a), batch.b().kind(p.b))).second;
          distances[queue.places[k]] = turned ? mirrored(found[k]) : found[k];
        }
      },
      [&](std::size_t i) {
        const IdPair p = batch[i];
        distances[i] = distance(batch.a().shape(p.a), batch.a().pose(p.a), batch.b().shape(p.b), batch.b().pose(p.b));
      });
}

template <class T>
void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found) {
  found.pairs.resize(batch.size());
  found.manifolds.clear();
  found.points.clear();
  const auto begin = [&](std::size_t i) -> typename BatchContacts<T>::Pair& {
    return found.pairs[i] = {false, static_cast<std::uint32_t>(found.manifolds.size()), 0};
  };
  const auto add = [&](const Vec3<T>& normal, std::uint32_t piece_a, std::uint32_t piece_b,
                       const ContactPoint<T>* points, std::size_t count) {
    found.manifolds.push_back(
        {normal, piece_a, piece_b, static_cast<std::uint32_t>(found.points.size()), static_cast<std::uint32_t>(count)});
    found.points.insert(found.points.end(), points, points + count);
  };
  Manifolds<T> several;
  const auto single = [&](std::size_t i) {
    const IdPair p = batch[i];
    auto& pair = begin(i);
    several.clear();
    pair.overlap =
        contacts(batch.a().shape(p.a), batch.a().pose(p.a), batch.b().shape(p.b), batch.b().pose(p.b), margin, several);
    for (const Manifold<T>& m : several) add(m.normal, m.piece_a, m.piece_b, m.points.data(), m.points.size());
    pair.manifold_count = static_cast<std::uint32_t>(several.size());
  };
  constexpr int boxes = 0, spheres = 1;
  const auto found_boxes = [&](const Queue<T>& queue) {
    visit_box_contacts(
        queue.pairs.data(), queue.count, [&](std::size_t k) { begin(queue.places[k]); },
        [&](std::size_t k, T distance, const Vec3<T>& normal, const BoxPoints<T>& points) {
          auto& pair = begin(queue.places[k]);
          pair.overlap = distance <= T(0);
          pair.manifold_count = 1;
          const auto first = static_cast<std::uint32_t>(found.points.size());
          found.manifolds.push_back({normal, 0, 0, first, static_cast<std::uint32_t>(points.append(found.points))});
        },
        [&](std::size_t k) { single(queue.places[k]); });
  };
  const auto found_spheres = [&](const Queue<T>& queue) {
    visit_ball_contacts(
        queue.pairs.data(), queue.count, [&](std::size_t k) { begin(queue.places[k]); },
        [&](std::size_t k, const Vec3<T>& normal, const ContactPoint<T>& point) {
          auto& pair = begin(queue.places[k]);
          pair.overlap = point.distance <= T(0);
          pair.manifold_count = 1;
          add(normal, 0, 0, &point, 1);
        });
  };
  visit_batch<2>(
      batch, margin,
      [](std::size_t kinds) {
        return std::pair{kinds == both<Box<T>, Box<T>, T>()         ? boxes
                         : kinds == both<Sphere<T>, Sphere<T>, T>() ? spheres
                                                                    : -1,
                         false};
      },
      [&](std::size_t number, const Queue<T>& queue) { number == boxes ? found_boxes(queue) : found_spheres(queue); },
      single);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template class Batch<T>;                                                                                             \
  template void overlap(const Batch<T>&, std::vector<std::uint8_t>&);                                                  \
  template void distance(const Batch<T>&, std::vector<Distance<T>>&);                                                  \
  template void contacts(const Batch<T>&, T, BatchContacts<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
