#include "graze/world/impacts.hpp"

#include <algorithm>
#include <tuple>

#include "composite/sweep.hpp"
#include "graze/plane/space.hpp"

namespace graze {

namespace {

constexpr std::size_t fast_bodies_per_task = 16;

/// The largest way of any point of a body in a unit of time.
template <class T, class Space>
T speed_of(const BodyArrays<T, Space>& bodies, std::uint32_t i) {
  return length(bodies.linear()[i]) + Space::speed_of_turning(bodies.shapes()[i], bodies.angular()[i]);
}

/// The space that the body sweeps, however it turns on the way.
template <class T, class Space>
Sweep<T> sweep_of(const BodyArrays<T, Space>& bodies, std::uint32_t i, T duration, T room) {
  return safe_sweep(Space::bounds_turning(bodies.shapes()[i], bodies.poses()[i], bodies.angular()[i]),
                    Space::among_boxes(bodies.linear()[i] * duration), room);
}

/// The box of all that a sweep passes.
template <class T>
Aabb<T> way_of(const Sweep<T>& sweep) {
  return merged(sweep.box, Aabb<T>{sweep.box.lower + sweep.motion, sweep.box.upper + sweep.motion});
}

template <class T, class Space>
bool before(const Impact<T, Space>& p, const Impact<T, Space>& q) {
  return std::tie(p.hit.t, p.a, p.b) < std::tie(q.hit.t, q.a, q.b);
}

}  // namespace

template <class T, class Space>
void find_impacts(const BodyArrays<T, Space>& bodies, const DynamicTree<T>& tree, T duration,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& allowed, Executor& executor,
                  std::vector<Impact<T, Space>>& out) {
  out.clear();
  std::vector<std::uint32_t> fast;
  T fastest(0);  // the speed of bodies that are not fast, platforms among them: so far they come towards a sweep
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies.alive()[i] == 0) continue;
    if (bodies.fast()[i] != 0)
      fast.push_back(i);
    else
      fastest = greatest(fastest, speed_of(bodies, i));
  }
  // Two fast bodies can meet anywhere on their ways: a tree of these, since in a crowd that is blown apart all are
  // fast.
  DynamicTree<T> ways;
  for (std::uint32_t k = 0; k < fast.size(); ++k) ways.insert(k, way_of(sweep_of(bodies, fast[k], duration, T(0))));
  std::vector<std::vector<Impact<T, Space>>> found((fast.size() + fast_bodies_per_task - 1) / fast_bodies_per_task);
  const auto meet = [&](std::uint32_t i, std::uint32_t j, std::vector<Impact<T, Space>>& impacts) {
    if (i == j || !allowed(i, j)) return;
    const std::uint32_t a = std::min(i, j), b = std::max(i, j);
    const auto velocity = [&](std::uint32_t k) {
      return typename Space::Velocity{bodies.linear()[k], bodies.angular()[k]};
    };
    const auto hit = Space::cast(bodies.shapes()[a], bodies.poses()[a], velocity(a), bodies.shapes()[b],
                                 bodies.poses()[b], velocity(b), duration, CastOptions{Separating::ignored});
    const bool trigger = bodies.triggers()[a] != 0 || bodies.triggers()[b] != 0;
    if (hit) impacts.push_back({bodies.id(a), bodies.id(b), trigger, *hit});
  };
  for_each_chunk(executor, fast.size(), fast_bodies_per_task,
                 [&](std::size_t begin, std::size_t end, std::size_t task) {
                   for (std::size_t k = begin; k < end; ++k) {
                     const std::uint32_t i = fast[k];
                     const Sweep<T> sweep = sweep_of(bodies, i, duration, fastest * duration);
                     const auto passes = [&](const Aabb<T>& box) { return entry(box, sweep) <= T(1); };
                     tree.visit(passes, [&](std::uint32_t j, const Aabb<T>&) {
                       if (bodies.fast()[j] == 0) meet(i, j, found[task]);
                     });
                     ways.visit(passes, [&](std::uint32_t other, const Aabb<T>&) {
                       if (other > k) meet(i, fast[other], found[task]);
                     });
                   }
                 });
  for (const auto& of_task : found) out.insert(out.end(), of_task.begin(), of_task.end());
  std::sort(out.begin(), out.end(), before<T, Space>);
}

#define GRAZE_INSTANTIATE(T, Space)                                                                                    \
  template void find_impacts(const BodyArrays<T, Space<T>>&, const DynamicTree<T>&, T,                                 \
                             const std::function<bool(std::uint32_t, std::uint32_t)>&, Executor&,                      \
                             std::vector<Impact<T, Space<T>>>&);
GRAZE_INSTANTIATE(float, Space)
GRAZE_INSTANTIATE(double, Space)
GRAZE_INSTANTIATE(float, plane::Space)
GRAZE_INSTANTIATE(double, plane::Space)
#undef GRAZE_INSTANTIATE

}  // namespace graze
