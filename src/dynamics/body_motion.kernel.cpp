#include <cstddef>

#include "dynamics/body_kernels.hpp"
#include "dynamics/free_turning.hpp"
#include "simd/lane_struct.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Some bodies of a block, from `first` on, as many as there are lanes: those behind the last are the last, and are
/// written nowhere.
template <class S, class Space>
class BodyLanes {
 public:
  using T = typename LaneOf<S>::type;
  using Over = SpaceOver<Space, S>;

  [[gnu::always_inline]] BodyLanes(std::size_t first, std::size_t count) : first_(first), count_(count) {}

  /// The struct of lanes of the members that begin with this one.
  template <class Struct, class Body, class Member>
  [[gnu::always_inline]] Struct load(const Body* bodies, Member Body::*member) const {
    return gathered<S, Struct>([&](std::size_t lane) __attribute__((always_inline)) {
      const std::size_t i = first_ + lane;
      return &(bodies[i < count_ ? i : count_ - 1].*member);
    });
  }
  template <class Struct, class Body, class Member>
  [[gnu::always_inline]] void store(const Struct& s, Body* bodies, Member Body::*member) const {
    T nowhere[sizeof(Struct) / sizeof(S)];
    scatter_struct<S>(
        s, [&](std::size_t lane) __attribute__((always_inline)) {
          const std::size_t i = first_ + lane;
          return i < count_ ? static_cast<void*>(&(bodies[i].*member)) : static_cast<void*>(nowhere);
        });
  }

 private:
  std::size_t first_, count_;
};

template <class S>
[[gnu::always_inline]] inline auto same(const Vec3<S>& a, const Vec3<S>& b) {
  return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
}
template <class S>
[[gnu::always_inline]] inline auto same(const S& a, const S& b) {
  return a == b;
}
template <class S>
[[gnu::always_inline]] inline auto same(const Quat<S>& a, const Quat<S>& b) {
  return same(a.vector(), b.vector()) & (a.w == b.w);
}
template <class S>
[[gnu::always_inline]] inline auto same(const plane::Rot2<S>& a, const plane::Rot2<S>& b) {
  return (a.cosine == b.cosine) & (a.sine == b.sine);
}
/// The velocity that moves a body in this sub-step: the mean of those before and after it, which is exact under gravity
/// and sliding friction. Along the normal that presses the body it is the one after, for which the rows were solved; so
/// it is in all directions where several normals press or friction holds. The mean would make a wall that sways on
/// friction gain energy: with forces of the old place it grows by 1 + (h w)² / 4 a sub-step.
template <class S, class Over>
[[gnu::always_inline]] inline typename Over::Vec
moving_velocity(const typename Over::Vec& before, const typename Over::Vec& after, const Pressure<S, Over>& pressure) {
  using Vec = typename Over::Vec;
  const Vec half = (before - after) / S(2);
  const Vec across = half - pressure.normal * dot(half, pressure.normal);
  const Vec mean = after + select(pressure.kind == S(pressure.none), half, across);
  return select(pressure.kind == S(pressure.everywhere), after, mean);
}

/// The angular momentum that a change of the angular velocity adds: exactly none where there was no change.
template <class S, class Over>
[[gnu::always_inline]] inline typename Over::Turning gained(const InertiaIn<Over>& inertia,
                                                            const RowVelocity<S, Over>& before,
                                                            const RowVelocity<S, Over>& after, const S& part) {
  const typename Over::Turning change = inertia * (after.angular - before.angular);
  return select(same(after.angular, before.angular), typename Over::Turning{}, change * part);
}

/// Calls `f` with the lanes of all bodies of a block.
template <class S, class T, class Space, class F>
[[gnu::always_inline]] inline void for_lanes(const BodyBlock<T, Space>& block, const F& f) {
  for (std::size_t first = 0; first < block.count; first += lanes_in<S>) f(BodyLanes<S, Space>(first, block.count));
}

/// A velocity after a time in which it is damped and gains `gain`; `damped` is the damping times the time. By the
/// trapezoidal rule, with which a free body goes as far as it should and falls as fast; where that would turn the
/// velocity round, nothing of it is left.
template <class S, class Vec>
[[gnu::always_inline]] inline Vec damped_velocity(const Vec& v, const Vec& gain, const S& damped) {
  const S half = damped / S(2), one(1);
  return (v * greatest(one - half, S(0)) + gain) * (one / greatest(one + half, damped));
}

template <class T, class Space>
[[gnu::flatten]] void begin(const BodyBlock<T, Space>& block, const SubStep<T>& time) {
  using S = Lanes<T>;
  using State = IslandBody<T, Space>;
  using Body = SolverBody<T, Space>;
  using Over = SpaceOver<Space, S>;
  using Velocity = RowVelocity<T, Space>;
  using Place = RowPlace<T, Space>;
  static_assert(offsetof(Body, angular) - offsetof(Body, linear) == offsetof(Velocity, angular));
  static_assert(offsetof(Body, angular_before) - offsetof(Body, linear_before) == offsetof(Velocity, angular));
  static_assert(offsetof(Body, turned) - offsetof(Body, moved) == offsetof(Place, turned));
  for_lanes<S>(
      block, [&](const BodyLanes<S, Space>& at) __attribute__((always_inline)) {
        const auto free = at.template load<FreeBodyIn<Over>>(block.states, &State::free);
        const auto acting = at.template load<Influences<S, Over>>(block.states, &State::influences);
        const auto inertia = at.template load<InverseMassIn<Over>>(block.bodies, &Body::mass).inertia;
        const RowVelocity<S, Over> before{free.linear, spin_of(free)};
        const S h = acting.share * S(time.h);
        RowVelocity<S, Over> v;
        v.linear = damped_velocity(before.linear, acting.acceleration * h, acting.linear_damping * h);
        v.angular = damped_velocity(before.angular, inertia * (acting.torque * h), acting.angular_damping * h);
        at.store(v, block.bodies, &Body::linear);
        at.store(before, block.bodies, &Body::linear_before);
        at.store(Pressure<S, Over>(), block.bodies, &Body::pressure);
      });
}

template <class T, class Space>
[[gnu::flatten]] void move(const BodyBlock<T, Space>& block, const SubStep<T>& time) {
  using S = Lanes<T>;
  using State = IslandBody<T, Space>;
  using Body = SolverBody<T, Space>;
  using Over = SpaceOver<Space, S>;
  using Vec = typename Over::Vec;
  using Rotation = RotationIn<Over>;
  for_lanes<S>(
      block, [&](const BodyLanes<S, Space>& at) __attribute__((always_inline)) {
        auto free = at.template load<FreeBodyIn<Over>>(block.states, &State::free);
        const auto inertia = at.template load<InertiaIn<Over>>(block.states, &State::world_inertia);
        const auto acting = at.template load<Influences<S, Over>>(block.states, &State::influences);
        const auto before = at.template load<RowVelocity<S, Over>>(block.bodies, &Body::linear_before);
        const auto after = at.template load<RowVelocity<S, Over>>(block.bodies, &Body::linear);
        const auto pressure = at.template load<Pressure<S, Over>>(block.bodies, &Body::pressure);
        const S h = acting.share * S(time.h), one(T(1)), half(T(0.5));
        const auto momentum = free.angular_momentum;
        free.angular_momentum +=
            gained<S, Over>(inertia, before, after, select(pressure.kind == S(pressure.none), half, one));
        free.center += moving_velocity<S, Over>(before.linear, after.linear, pressure) * h;
        turn(free, h);
        free.linear = after.linear;
        free.angular_momentum = momentum + gained<S, Over>(inertia, before, after, one);
        at.store(free, block.states, &State::free);

        const auto first_center = at.template load<Vec>(block.bodies, &Body::first_center);
        const auto first_rotation = at.template load<Rotation>(block.bodies, &Body::first_rotation);
        const auto turned =
            select(same(free.rotation, first_rotation), Rotation{}, free.rotation * conjugate(first_rotation));
        const RowVelocity<S, Over> v{free.linear, spin_of(free)};
        at.store(v, block.bodies, &Body::linear);
        at.store(v, block.bodies, &Body::linear_before);
        at.store(RowPlace<S, Over>{free.center - first_center, turned}, block.bodies, &Body::moved);
        at.store(free.center, block.bodies, &Body::center);
        at.store(free.rotation, block.bodies, &Body::rotation);
      });
}

template <class T, class Space>
[[gnu::flatten]] void end(const BodyBlock<T, Space>& block) {
  using S = Lanes<T>;
  using State = IslandBody<T, Space>;
  using Body = SolverBody<T, Space>;
  using Over = SpaceOver<Space, S>;
  for_lanes<S>(
      block, [&](const BodyLanes<S, Space>& at) __attribute__((always_inline)) {
        auto free = at.template load<FreeBodyIn<Over>>(block.states, &State::free);
        const auto inertia = at.template load<InertiaIn<Over>>(block.states, &State::world_inertia);
        const auto before = at.template load<RowVelocity<S, Over>>(block.bodies, &Body::linear_before);
        const auto after = at.template load<RowVelocity<S, Over>>(block.bodies, &Body::linear);
        free.linear = after.linear;
        free.angular_momentum += gained<S, Over>(inertia, before, after, S(T(1)));
        at.store(free, block.states, &State::free);
      });
}

template <class T, class Space>
constexpr BodyKernels<T, Space> kernels_of() {
  return {begin<T, Space>, move<T, Space>, end<T, Space>};
}
constexpr SpaceKernels<BodyKernels> kernels{kernels_of<float, Space<float>>(), kernels_of<double, Space<double>>(),
                                            kernels_of<float, plane::Space<float>>(),
                                            kernels_of<double, plane::Space<double>>()};

}  // namespace

const SpaceKernels<BodyKernels>& body_kernels() { return kernels; }

}  // namespace graze::GRAZE_ISA
