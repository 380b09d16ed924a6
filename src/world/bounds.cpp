#include "graze/world/bounds.hpp"

namespace graze {

namespace {

/// Bodies a task: some microseconds of work.
constexpr std::size_t bodies_per_task = 512;

}  // namespace

template <class T>
void find_bounds(std::span<const Shape<T>> shapes, std::span<const Pose<T>> poses, std::span<const T> margins,
                 std::span<const std::uint32_t> which, std::span<Aabb<T>> boxes, Executor& executor) {
  for_each_chunk(executor, which.size(), bodies_per_task, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = which[k];
      const T margin = margins[i] < std::numeric_limits<T>::infinity() ? margins[i] : T(0);
      boxes[i] = inflated(bounds(shapes[i], poses[i]), margin);
    }
  });
}

template void find_bounds(std::span<const Shape<float>>, std::span<const Pose<float>>, std::span<const float>,
                          std::span<const std::uint32_t>, std::span<Aabb<float>>, Executor&);
template void find_bounds(std::span<const Shape<double>>, std::span<const Pose<double>>, std::span<const double>,
                          std::span<const std::uint32_t>, std::span<Aabb<double>>, Executor&);

}  // namespace graze
