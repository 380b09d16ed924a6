// Casts of many moving pairs, and the points of one shape nearest to many, one by one in chunks for threads. Pairs are
// not grouped by kind: reading memory out of order costs more than predicted branches save.
#include <algorithm>

#include "plane/batch_parts.hpp"

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
};

}  // namespace

template <class T>
void cast(const Batch<T>& batch, std::type_identity_t<std::span<const Velocity<T>>> velocities_a,
          std::type_identity_t<std::span<const Velocity<T>>> velocities_b, std::type_identity_t<T> duration,
          std::vector<std::optional<CastHit<T>>>& hits, const CastOptions& options, Executor* executor) {
  const MovingBatch<T> moving{
      batch, {velocities_a, batch.a(), "velocities_a"}, {velocities_b, batch.b(), "velocities_b"}, duration, options};
  hits.resize(batch.size());
  for_chunks(executor, batch.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) hits[i] = moving.contact(i);
  });
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
