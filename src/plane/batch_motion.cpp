// Casts of many moving pairs, in blocks for kernels where they do not turn, and the points of one shape nearest to many
// one by one. Both in chunks for threads.
#include <algorithm>

#include "plane/batch_parts.hpp"
#include "plane/outline_hit.hpp"
#include "plane/pairs/cast_kernels.hpp"
#include "plane/pairs/pair_queues.hpp"
#include "plane/rounded_time.hpp"

namespace graze::plane {

namespace {

/// Velocities of a side's bodies: one each, or one for all.
template <class T>
class Velocities {
 public:
  Velocities(std::span<const Velocity<T>> all, const Bodies<T>& bodies, const char* name) : all_(all) {
    if (all.size() != bodies.size() && all.size() != 1)
      validate::fail(name, "as many as bodies, or one", static_cast<double>(all.size()));
  }
  const Velocity<T>& operator[](std::size_t i) const { return all_.size() == 1 ? all_[0] : all_[i]; }

 private:
  std::span<const Velocity<T>> all_;
};

/// The moving pairs of a batch.
template <class T>
struct MovingBatch {
  const Batch<T>& batch;
  Velocities<T> a, b;
  T duration;
  const CastOptions& options;

  std::optional<CastHit<T>> contact(std::size_t i) const {
    const IdPair p = batch[i];
    return batch.visit(
        i, [&](const Shape<T>& shape_a, const Pose2<T>& pose_a, const Shape<T>& shape_b, const Pose2<T>& pose_b) {
          return cast(shape_a, pose_a, a[p.a], shape_b, pose_b, b[p.b], duration, options);
        });
  }
  /// Whether the i-th cast is one of bodies that do not turn, of which every contact counts.
  bool straight(std::size_t i) const {
    const IdPair p = batch[i];
    return options.separating == Separating::hit && a[p.a].angular == T(0) && b[p.b].angular == T(0);
  }
  /// Writes the velocities of a block's pairs; up to a full register the last one is repeated.
  void load(const PairBlock& block, const LoadKernels<T>& kernels, MotionColumns& to) const {
    const Velocity<T>*of_a[block_pairs], *of_b[block_pairs];
    for (std::size_t k = 0; k < block_pairs; ++k) {
      const IdPair p = batch[block.place[std::min(k, block.count - 1)]];
      of_a[k] = &a[p.a];
      of_b[k] = &b[p.b];
    }
    kernels.velocities(of_a, block.count, to.a);
    kernels.velocities(of_b, block.count, to.b);
  }
};

/// The kernels of the level that the machine runs at.
const CastKernels& cast_kernels() {
  static const CastKernels& chosen = GRAZE_KERNEL(chosen_isa(), plane_cast_kernels)();
  return chosen;
}

/// The first contacts of a block's pairs. Returns whether a kernel has answered.
template <class T>
bool find_contacts(const MovingBatch<T>& moving, const PairBlock& block, const LoadKernels<T>& load,
                   CastColumns& found) {
  const CastKernels::OfEntry of_entry = cast_kernels().entries[block.entry.place][block.entry.turned ? 1 : 0];
  if (!block.polygons && !of_entry) return false;
  MotionColumns motion;
  moving.load(block, load, motion);
  if (block.polygons)
    cast_kernels().polygons(*block.polygons, motion, block.count, found);
  else
    of_entry(*block.columns, motion, block.count, found);
  return true;
}

/// The answer that a column holds, for times up to `duration`.
template <class T>
std::optional<CastHit<T>> hit_at(const CastColumns& found, std::size_t k, T duration) {
  if (!(found.t[k] <= double(duration)) || found.t[k] == never) return {};
  return CastHit<T>{rounded_down<T>(found.t[k]),
                    {static_cast<T>(found.point[0][k]), static_cast<T>(found.point[1][k])},
                    {static_cast<T>(found.normal[0][k]), static_cast<T>(found.normal[1][k])},
                    T(0),
                    Status::converged,
                    0,
                    0};
}

/// The casts of the pairs of a chunk: in blocks the straight ones.
template <class T>
void cast_chunk(const MovingBatch<T>& moving, std::size_t begin, std::size_t end,
                std::vector<std::optional<CastHit<T>>>& hits) {
  PairQueues<T> queues;
  CastColumns found;
  const auto block = [&](const PairBlock& pairs) {
    const bool answered = find_contacts(moving, pairs, queues.load(), found);
    for (std::size_t k = 0; k < pairs.count; ++k) {
      const std::size_t i = pairs.place[k];
      hits[i] = answered && found.known[k] != 0 ? hit_at(found, k, moving.duration) : moving.contact(i);
    }
  };
  for (std::size_t i = begin; i < end; ++i)
    if (!moving.straight(i) || !queues.add(moving.batch, i, cast_kernels().polygons_pay, block))
      hits[i] = moving.contact(i);
  queues.finish(block);
}

}  // namespace

template <class T>
void cast(const Batch<T>& batch, std::type_identity_t<std::span<const Velocity<T>>> velocities_a,
          std::type_identity_t<std::span<const Velocity<T>>> velocities_b, std::type_identity_t<T> duration,
          std::vector<std::optional<CastHit<T>>>& hits, const CastOptions& options, Executor* executor) {
  const MovingBatch<T> moving{
      batch, {velocities_a, batch.a(), "velocities_a"}, {velocities_b, batch.b(), "velocities_b"}, duration, options};
  hits.resize(batch.size());
  for_chunks(executor, batch.size(),
             [&](std::size_t begin, std::size_t end, std::size_t) { cast_chunk(moving, begin, end, hits); });
}

template <class T>
void closest(const Shape<T>& shape, const Pose2<T>& pose, std::type_identity_t<std::span<const Vec2<T>>> points,
             std::type_identity_t<std::span<Closest<T>>> found, Executor* executor) {
  for_chunks(executor, std::min(points.size(), found.size()), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) found[i] = closest(shape, pose, points[i]);
  });
}

#define GRAZE_MOTION(T)                                                                                                \
  template void cast(const Batch<T>&, std::type_identity_t<std::span<const Velocity<T>>>,                              \
                     std::type_identity_t<std::span<const Velocity<T>>>, std::type_identity_t<T>,                      \
                     std::vector<std::optional<CastHit<T>>>&, const CastOptions&, Executor*);                          \
  template void closest(const Shape<T>&, const Pose2<T>&, std::type_identity_t<std::span<const Vec2<T>>>,              \
                        std::type_identity_t<std::span<Closest<T>>>, Executor*);
GRAZE_MOTION(float)
GRAZE_MOTION(double)
#undef GRAZE_MOTION

}  // namespace graze::plane
