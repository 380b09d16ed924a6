#include "plane/pairs/load_kernels.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

/// Writes lanes to a column, in double.
template <class T>
[[gnu::always_inline]] inline void put(const Lanes<T>& x, double* column) {
  lanes_in_double<0>(x).store(column);
  if constexpr (lanes_of < T >> lanes_of<double>) lanes_in_double<1>(x).store(column + lanes_of<double>);
}

/// Gathers `count` numbers at the head of each row.
template <class T, std::size_t numbers, class Row, class F>
[[gnu::always_inline]] inline void for_bundles(const Row* rows, std::size_t count, const F& f) {
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    Lanes<T> n[numbers];
    gather<T>(
        [&](std::size_t lane) __attribute__((always_inline)) { return rows[first + lane]; }, 0, n);
    f(n, first);
  }
}

template <class T>
[[gnu::flatten]] void load_poses(const Pose2<T>* const* rows, std::size_t count, BlockColumns& to) {
  static_assert(sizeof(Pose2<T>) == pose_columns * sizeof(T));
  for_bundles<T, pose_columns>(rows, count, [&](const Lanes<T>* n, std::size_t first) {
    for (std::size_t k = 0; k < pose_columns; ++k) put<T>(n[k], to[k] + first);
  });
}

template <class T>
[[gnu::flatten]] void load_velocities(const plane::Velocity<T>* const* rows, std::size_t count,
                                      double (&to)[2][block_pairs]) {
  static_assert(sizeof(plane::Velocity<T>) == 3 * sizeof(T) && offsetof(plane::Velocity<T>, linear) == 0);
  for_bundles<T, 2>(rows, count, [&](const Lanes<T>* n, std::size_t first) {
    for (std::size_t k = 0; k < 2; ++k) put<T>(n[k], to[k] + first);
  });
}

constexpr std::size_t radius_column = shape_columns - 1;

template <class T>
[[gnu::always_inline]] inline void load(const void* const* rows, std::size_t count, BlockColumns& to,
                                        const Circle<T>*) {
  static_assert(sizeof(Circle<T>) == sizeof(T));
  for_bundles<T, 1>(rows, count,
                    [&](const Lanes<T>* n, std::size_t first) { put<T>(n[0], to[radius_column] + first); });
}
template <class T>
[[gnu::always_inline]] inline void load(const void* const* rows, std::size_t count, BlockColumns& to,
                                        const Capsule<T>*) {
  static_assert(sizeof(Capsule<T>) == 3 * sizeof(T));
  for_bundles<T, 3>(rows, count, [&](const Lanes<T>* n, std::size_t first) {
    put<T>(Lanes<T>(T(0)), to[pose_columns] + first);
    put<T>(-n[0], to[pose_columns + 1] + first);
    put<T>(Lanes<T>(T(0)), to[pose_columns + 2] + first);
    put<T>(n[0], to[pose_columns + 3] + first);
    put<T>(n[2], to[radius_column] + first);
  });
}
template <class T>
[[gnu::always_inline]] inline void load(const void* const* rows, std::size_t count, BlockColumns& to,
                                        const Segment<T>*) {
  static_assert(sizeof(Segment<T>) == size_columns * sizeof(T));
  for_bundles<T, size_columns>(rows, count, [&](const Lanes<T>* n, std::size_t first) {
    for (std::size_t k = 0; k < size_columns; ++k) put<T>(n[k], to[pose_columns + k] + first);
    put<T>(Lanes<T>(T(0)), to[radius_column] + first);
  });
}
template <class T>
[[gnu::always_inline]] inline void load(const void* const* rows, std::size_t count, BlockColumns& to, const Box<T>*) {
  static_assert(sizeof(Box<T>) == 2 * sizeof(T));
  for_bundles<T, 2>(rows, count, [&](const Lanes<T>* n, std::size_t first) {
    put<T>(n[0], to[pose_columns] + first);
    put<T>(n[1], to[pose_columns + 1] + first);
    put<T>(Lanes<T>(T(0)), to[radius_column] + first);
  });
}
template <class T>
[[gnu::always_inline]] inline void load(const void* const*, std::size_t count, BlockColumns& to, const HalfPlane<T>*) {
  for (std::size_t i = 0; i < count; ++i) to[radius_column][i] = 0;
}

template <class C>
[[gnu::flatten]] void load_shapes(const void* const* rows, std::size_t count, BlockColumns& to) {
  load(rows, count, to, static_cast<const C*>(nullptr));
}

template <class C>
constexpr auto loader_of() -> void (*)(const void* const*, std::size_t, BlockColumns&) {
  if constexpr (lane_core<C>.has_value())
    return load_shapes<C>;
  else
    return nullptr;
}
template <class T, std::size_t... I>
constexpr LoadKernels<T> kernels_of(std::index_sequence<I...>) {
  return {load_poses<T>, {loader_of<std::variant_alternative_t<I, ShapeList<T>>>()...}, load_velocities<T>};
}
constexpr AllLoadKernels load_kernels{kernels_of<float>(std::make_index_sequence<Shape<float>::count>()),
                                      kernels_of<double>(std::make_index_sequence<Shape<double>::count>())};

}  // namespace

const AllLoadKernels& plane_load_kernels() { return load_kernels; }

}  // namespace graze::GRAZE_ISA
