#include <cstddef>
#include <cstring>

#include "dynamics/contact_kernels.hpp"
#include "simd/lane_struct.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// A bundle's rows and bodies as lanes of S see them.
template <class S, class Space>
class BundleLanes {
 public:
  using T = typename LaneOf<S>::type;
  using Over = SpaceOver<Space, S>;
  using Manifold = ManifoldRows<S, Over>;
  using Row = PointRow<S, Over>;
  using Bodies = RowBodies<S, Over>;
  using Body = SolverBody<T, Space>;
  using Bundle = ContactBundle<T, Space>;
  static constexpr std::size_t lanes = lanes_in<S>;

  [[gnu::always_inline]] BundleLanes(const Bundle& bundle, const Body* bodies) : bundle_(bundle), bodies_(bodies) {}

  [[gnu::always_inline]] Manifold& manifold() const { return *static_cast<Manifold*>(bundle_.rows); }
  [[gnu::always_inline]] std::span<Row> rows() const {
    return {reinterpret_cast<Row*>(static_cast<Manifold*>(bundle_.rows) + 1), bundle_.row_count};
  }

  [[gnu::always_inline]] Bodies bodies() const {
    Bodies bodies;
    bodies.a = velocity(&LanePlaces::a);
    bodies.b = velocity(&LanePlaces::b);
    bodies.place_a = place(&LanePlaces::a);
    bodies.place_b = place(&LanePlaces::b);
    bodies.roll = bundle_.roll;
    return bodies;
  }
  [[gnu::always_inline]] RowBody<S, Over> body(std::uint32_t LanePlaces::*which) const {
    const auto center = [&](std::size_t lane) __attribute__((always_inline)) { return &at(which, lane).first_center; };
    const auto mass = [&](std::size_t lane) __attribute__((always_inline)) { return &at(which, lane).mass; };
    return {gathered<S, typename Over::Vec>(center), gathered<S, InverseMassIn<Over>>(mass), velocity(which)};
  }

  /// Writes the velocities that rows changed to the bodies that can be pushed.
  [[gnu::always_inline]] void store(const Bodies& changed, Body* bodies) const {
    store_one(changed.a, &LanePlaces::a, bundle_.pushed_a, bodies);
    store_one(changed.b, &LanePlaces::b, bundle_.pushed_b, bodies);
  }
  template <class Mask>
  [[gnu::always_inline]] void note_pressure(const Mask& presses, const Mask& slides, Body* bodies) const {
    add_pressure(presses, slides, &LanePlaces::a, bundle_.pushed_a, bodies);
    add_pressure(presses, slides, &LanePlaces::b, bundle_.pushed_b, bodies);
  }

 private:
  [[gnu::always_inline]] const Body& at(std::uint32_t LanePlaces::*which, std::size_t lane) const {
    return bodies_[bundle_.places[lane].*which];
  }
  /// The velocities of one body of each lane. The sum with zero makes a negative zero positive.
  [[gnu::always_inline]] RowVelocity<S, Over> velocity(std::uint32_t LanePlaces::*which) const {
    static_assert(sizeof(RowVelocity<T, Space>) == offsetof(Body, moved));
    const auto row = [&](std::size_t lane) __attribute__((always_inline)) { return &at(which, lane).linear; };
    auto v = gathered<S, RowVelocity<S, Over>>(row);
    v.linear += typename Over::Vec{};
    v.angular += typename Over::Turning{};
    return v;
  }
  [[gnu::always_inline]] RowPlace<S, Over> place(std::uint32_t LanePlaces::*which) const {
    static_assert(sizeof(RowPlace<T, Space>) == offsetof(Body, pressure) - offsetof(Body, moved));
    const auto row = [&](std::size_t lane) __attribute__((always_inline)) { return &at(which, lane).moved; };
    return gathered<S, RowPlace<S, Over>>(row);
  }
  [[gnu::always_inline]] void store_one(const RowVelocity<S, Over>& v, std::uint32_t LanePlaces::*which,
                                        std::uint32_t pushed, Body* bodies) const {
    RowVelocity<T, Space> nowhere;
    const auto row = [&](std::size_t lane) __attribute__((always_inline)) {
      return pushed >> lane & 1 ? static_cast<void*>(&bodies[bundle_.places[lane].*which].linear)
                                : static_cast<void*>(&nowhere);
    };
    scatter_struct<S>(v, row);
  }
  template <class Mask>
  [[gnu::always_inline]] void add_pressure(const Mask& presses, const Mask& slides, std::uint32_t LanePlaces::*which,
                                           std::uint32_t pushed, Body* bodies) const {
    using Lanewise = Pressure<S, Over>;
    static_assert(sizeof(Lanewise) == lanes * sizeof(Pressure<T, Space>));
    Pressure<T, Space> nowhere;
    const auto row = [&](std::size_t lane) __attribute__((always_inline)) {
      return pushed >> lane & 1 ? static_cast<void*>(&bodies[bundle_.places[lane].*which].pressure)
                                : static_cast<void*>(&nowhere);
    };
    auto pressure = gathered<S, Lanewise>(row);
    pressure.add(manifold().normal, presses, slides);
    scatter_struct<S>(pressure, row);
  }

  const Bundle& bundle_;
  const Body* bodies_;
};

/// The points of a bundle's manifolds; a manifold without so many has its last one again, without an impulse.
template <class S, class Space>
class BundlePoints {
  using T = typename LaneOf<S>::type;
  using Over = SpaceOver<Space, S>;
  using Point = SolverPoint<T, Space>;

 public:
  [[gnu::always_inline]] BundlePoints(const ContactBundle<T, Space>& bundle, const Point* points, const S& count)
      : bundle_(bundle), points_(points), count_(count) {}

  [[gnu::always_inline]] FoundPoint<S, Over> operator[](std::size_t i) const {
    using Vec = typename Over::Vec;
    const auto a = [&](std::size_t lane) __attribute__((always_inline)) { return &at(lane, i).a; };
    const auto b = [&](std::size_t lane) __attribute__((always_inline)) { return &at(lane, i).b; };
    const auto weight = [&](std::size_t lane) __attribute__((always_inline)) { return &at(lane, i).weight; };
    const auto distance = [&](std::size_t lane) __attribute__((always_inline)) { return &at(lane, i).distance; };
    const auto impulse = [&](std::size_t lane) __attribute__((always_inline)) { return &at(lane, i).impulse; };
    const Vec from = gathered<S, Vec>(a);
    const auto present = S(static_cast<T>(i)) < count_;
    return {from + (gathered<S, Vec>(b) - from) * gathered<S, S>(weight),
            select(present, gathered<S, Vec>(impulse), Vec{}), gathered<S, S>(distance)};
  }

 private:
  [[gnu::always_inline]] const Point& at(std::size_t lane, std::size_t i) const {
    const ContactManifold<T, Space>& m = *bundle_.sources[lane].found;
    return points_[m.first_point + (i < m.point_count ? i : m.point_count - 1)];
  }

  const ContactBundle<T, Space>& bundle_;
  const Point* points_;
  S count_;
};

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] void prepare(const ContactBundle<T, Space>& bundle, const SolverBody<T, Space>* bodies,
                              const SolverPoint<T, Space>* points, T step, const WarmStart<T>& warm) {
  using Lanewise = BundleLanes<S, Space>;
  using Over = typename Lanewise::Over;
  const Lanewise in(bundle, bodies);
  const auto between = [&](std::size_t lane) __attribute__((always_inline)) {
    return &bundle.sources[lane].touching->between;
  };
  const auto normal = [&](std::size_t lane) __attribute__((always_inline)) {
    return &bundle.sources[lane].found->normal;
  };
  T counts[Lanewise::lanes] = {};
  for (std::size_t lane = 0; lane < bundle.filled; ++lane)
    counts[lane] = static_cast<T>(bundle.sources[lane].found->point_count);
  const S count = loaded_lanes<S>(counts);
  auto& m = in.manifold();
  m.normal = gathered<S, typename Over::Vec>(normal);
  m.touching = gathered<S, Touching<S, Over>>(between);
  m.prepare(in.body(&LanePlaces::a), in.body(&LanePlaces::b), BundlePoints<S, Space>(bundle, points, count), count,
            step, warm, in.rows());
  if (!bundle.roll) return;
  const typename Space::Turning none{};
  const auto rolling = [&](std::size_t lane) __attribute__((always_inline)) {
    return bundle.sources[lane].rolling ? bundle.sources[lane].rolling : &none;
  };
  const auto last = gathered<S, typename Over::Turning>(rolling);
  m.friction.take_over_rolling(last * S(warm.share), in.rows(), m.touching.material);
}

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] void warm_start(const ContactBundle<T, Space>& bundle, SolverBody<T, Space>* bodies) {
  const BundleLanes<S, Space> in(bundle, bodies);
  auto pushed = in.bodies();
  in.manifold().warm_start(in.rows(), pushed);
  in.store(pushed, bodies);
}

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] void solve(const ContactBundle<T, Space>& bundle, SolverBody<T, Space>* bodies,
                            const ContactStep<T>& step, bool bias) {
  const BundleLanes<S, Space> in(bundle, bodies);
  auto pushed = in.bodies();
  auto& m = in.manifold();
  const auto slides = m.solve(in.rows(), step, bias, pushed);
  in.store(pushed, bodies);
  if (bias) in.note_pressure(m.presses(in.rows()), slides, bodies);
}

/// The greatest number of a bundle's lanes that have a manifold.
template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::always_inline]] inline T greatest_of(const ContactBundle<T, Space>& bundle, const S& speed) {
  T speeds[lanes_in<S>], fastest(0);
  std::memcpy(speeds, &speed, sizeof speeds);
  for (std::size_t lane = 0; lane < bundle.filled; ++lane) fastest = greatest(fastest, speeds[lane]);
  return fastest;
}

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] T approach(const ContactBundle<T, Space>& bundle, const SolverBody<T, Space>* bodies) {
  const BundleLanes<S, Space> in(bundle, bodies);
  return greatest_of<S, Space>(bundle, in.manifold().approach(in.rows(), in.bodies()));
}

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] T parting(const ContactBundle<T, Space>& bundle, const SolverBody<T, Space>* bodies) {
  const BundleLanes<S, Space> in(bundle, bodies);
  return greatest_of<S, Space>(bundle, in.manifold().parting(in.rows(), in.bodies()));
}

template <class S, class Space, class T = typename LaneOf<S>::type>
[[gnu::flatten]] void store(const ContactBundle<T, Space>& bundle, T times, SolverPoint<T, Space>* points) {
  using Vec = typename Space::Vec;
  const BundleLanes<S, Space> in(bundle, nullptr);
  in.manifold().store(
      in.rows(), times, [&](std::size_t i, const auto& impulse) __attribute__((always_inline)) {
        // Rows behind a manifold's last are written nowhere.
        Vec nowhere;
        scatter_struct<S>(
            impulse, [&](std::size_t lane) __attribute__((always_inline)) {
              const ContactManifold<T, Space>& m = *bundle.sources[lane].found;
              return lane < bundle.filled && i < m.point_count ? static_cast<void*>(&points[m.first_point + i].impulse)
                                                               : static_cast<void*>(&nowhere);
            });
      });
  if (!bundle.roll) return;
  typename Space::Turning nowhere;
  scatter_struct<S>(
      in.manifold().friction.rolling() * S(times), [&](std::size_t lane) __attribute__((always_inline)) {
        typename Space::Turning* const rolling = bundle.sources[lane].rolling;
        return lane < bundle.filled && rolling ? static_cast<void*>(rolling) : static_cast<void*>(&nowhere);
      });
}

template <class S, class Space>
constexpr ContactKernels<typename LaneOf<S>::type, Space> kernels_of() {
  using In = BundleLanes<S, Space>;
  return {static_cast<std::uint32_t>(In::lanes),
          sizeof(typename In::Manifold),
          sizeof(typename In::Row),
          prepare<S, Space>,
          warm_start<S, Space>,
          solve<S, Space>,
          approach<S, Space>,
          parting<S, Space>,
          store<S, Space>};
}
template <class T, class Space>
constexpr ContactKernelPair<T, Space> pair_of() {
  return {kernels_of<Lanes<T>, Space>(), kernels_of<T, Space>()};
}
constexpr SpaceKernels<ContactKernelPair> kernels{pair_of<float, Space<float>>(), pair_of<double, Space<double>>(),
                                                  pair_of<float, plane::Space<float>>(),
                                                  pair_of<double, plane::Space<double>>()};

}  // namespace

const SpaceKernels<ContactKernelPair>& contact_kernels() { return kernels; }

}  // namespace graze::GRAZE_ISA
