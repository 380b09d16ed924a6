#include "lanes/gather.hpp"
#include "narrow/pair_kernels.hpp"
#include "narrow/pairs/box_manifold.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// A bundle of pairs of boxes, one a lane. Lanes without a pair repeat the last one.
template <class T>
struct Bundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  Pose<S> pose_a, pose_b;
  BoxPair<S> boxes;
  S margin;
  std::size_t count;

  [[gnu::always_inline]] Bundle(const PairRef<T>* pairs, std::size_t left) : count(left < lanes ? left : lanes) {
    const void* rows[4][lanes];
    for (std::size_t i = 0; i < lanes; ++i) {
      const PairRef<T>& pair = pairs[i < count ? i : count - 1];
      rows[0][i] = pair.a;
      rows[1][i] = pair.b;
      rows[2][i] = pair.pose_a;
      rows[3][i] = pair.pose_b;
      margin.set(static_cast<int>(i), pair.margin);
    }
    boxes.half_a = vector(rows[0]);
    boxes.half_b = vector(rows[1]);
    pose_a = pose(rows[2]);
    pose_b = pose(rows[3]);
    const RelativeFrame<S> b_in_a = relative_frame(pose_a, pose_b);
    boxes.translation = b_in_a.translation;
    boxes.rotation = b_in_a.rotation;
  }

 private:
  [[gnu::always_inline]] static Vec3<S> vector(const void* const* rows) {
    S v[3];
    gather<T>(rows, 0, v);
    return {v[0], v[1], v[2]};
  }
  [[gnu::always_inline]] static Pose<S> pose(const void* const* rows) {
    S q[4];
    gather<T>(rows, 3 * sizeof(T), q);
    return {vector(rows), {q[0], q[1], q[2], q[3]}};
  }
};

/// Writes the lanes that hold a pair.
template <class T>
[[gnu::always_inline]] inline void put(T* column, const Lanes<T>& v, std::size_t count) {
  if (count == static_cast<std::size_t>(lanes_of<T>)) return v.store(column);
  for (std::size_t i = 0; i < count; ++i) column[i] = v[static_cast<int>(i)];
}

}  // namespace

template <class T>
[[gnu::flatten]] void box_axes(const PairRef<T>* pairs, std::size_t count, BoxAxisNumber<T>* axes) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Bundle<T>::lanes) {
    const Bundle<T> bundle(pairs + first, count - first);
    const BoxChoice<S> choice = box_choice(bundle.boxes, bundle.margin);
    for (std::size_t i = 0; i < bundle.count; ++i) {
      const int lane = static_cast<int>(i);
      axes[first + i] = {choice.distance[lane], choice.axis[lane], choice.closest[lane]};
    }
  }
}

template <class T>
[[gnu::flatten]] void box_points(const PairRef<T>* pairs, const BoxAxisNumber<T>* axes, std::size_t count,
                                 BoxPointBlock<T>& points) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Bundle<T>::lanes) {
    const Bundle<T> bundle(pairs + first, count - first);
    BoxChoice<S> choice;
    for (std::size_t i = 0; i < Bundle<T>::lanes; ++i) {
      const BoxAxisNumber<T>& of = axes[first + (i < bundle.count ? i : bundle.count - 1)];
      const int lane = static_cast<int>(i);
      choice.distance.set(lane, of.distance);
      choice.axis.set(lane, of.axis);
      choice.closest.set(lane, of.closest);
    }
    const BoxManifold<S> found = box_manifold(bundle.boxes, choice, bundle.margin, bundle.pose_a, bundle.pose_b);
    const auto vector = [&](auto& columns, const Vec3<S>& v) {
      for (std::size_t k = 0; k < 3; ++k) put(columns[k] + first, v[k], bundle.count);
    };
    vector(points.normal, found.normal);
    put(points.filled + first, found.filled, bundle.count);
    put(points.known + first, found.known, bundle.count);
    for (std::size_t i = 0; i < most_box_points; ++i) {
      const auto& slot = found.slots[i];
      vector(points.slots[i].a, slot.a);
      vector(points.slots[i].b, slot.b);
      put(points.slots[i].distance + first, slot.distance, bundle.count);
      put(points.slots[i].part_a + first, slot.part_a, bundle.count);
      put(points.slots[i].part_b + first, slot.part_b, bundle.count);
    }
  }
}

template <class T>
[[gnu::flatten]] void box_overlaps(const PairRef<T>* pairs, std::size_t count, std::uint8_t* touch) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Bundle<T>::lanes) {
    const Bundle<T> bundle(pairs + first, count - first);
    const S noise = box_noise(bundle.boxes, length(bundle.boxes.half_a), length(bundle.boxes.half_b));
    const auto apart = boxes_apart(bundle.boxes, noise);
    for (std::size_t i = 0; i < bundle.count; ++i) touch[first + i] = !apart[static_cast<int>(i)];
  }
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void box_axes(const PairRef<T>*, std::size_t, BoxAxisNumber<T>*);                                           \
  template void box_points(const PairRef<T>*, const BoxAxisNumber<T>*, std::size_t, BoxPointBlock<T>&);                \
  template void box_overlaps(const PairRef<T>*, std::size_t, std::uint8_t*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
