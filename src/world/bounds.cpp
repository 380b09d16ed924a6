#include "graze/world/bounds.hpp"

#include "graze/plane/space.hpp"

namespace graze {

namespace {

/// Bodies in a task: some microseconds of work.
constexpr std::size_t bodies_per_task = 512;

}  // namespace

template <class T, class Space>
void find_bounds(std::span<const typename Space::Shape> shapes, std::span<const typename Space::Pose> poses,
                 std::span<const T> margins, std::span<const std::uint32_t> which, std::span<Aabb<T>> boxes,
                 Executor& executor) {
  for_each_chunk(executor, which.size(), bodies_per_task, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = which[k];
      boxes[i] = bounds_with_margin<T, Space>(shapes[i], poses[i], margins[i]);
    }
  });
}

#define GRAZE_INSTANTIATE(T, Space)                                                                                    \
  template void find_bounds<T, Space<T>>(std::span<const Space<T>::Shape>, std::span<const Space<T>::Pose>,            \
                                         std::span<const T>, std::span<const std::uint32_t>, std::span<Aabb<T>>,       \
                                         Executor&);
GRAZE_INSTANTIATE(float, Space)
GRAZE_INSTANTIATE(double, Space)
GRAZE_INSTANTIATE(float, plane::Space)
GRAZE_INSTANTIATE(double, plane::Space)
#undef GRAZE_INSTANTIATE

}  // namespace graze
