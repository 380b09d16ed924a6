// Kernels that solve contacts across lanes: as many manifolds at a time as a register has numbers, no two of them of
// the same body that can be pushed; or one alone, by the same code.
//
// Guarantee: the same bits whatever the number of lanes, and whatever the other lanes hold.
#pragma once

#include "dynamics/contact_rows.hpp"
#include "dynamics/space_kernels.hpp"
#include "graze/world/manifolds.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// Two bodies, by their places in the island, and what acts between them.
template <class T, class Space>
struct TouchingBodies {
  std::uint32_t a{}, b{};
  Touching<T, Space> between{};
  typename Space::Turning* rolling{};  ///< `LaneSource::rolling` of the first manifold, and then the others'
};

/// A lane's bodies.
struct LanePlaces {
  std::uint32_t a, b;
};

/// The bodies and the manifold from which a lane's rows are made.
template <class T, class Space>
struct LaneSource {
  const TouchingBodies<T, Space>* touching;
  const ContactManifold<T, Space>* found;
  /// The angular impulse that resists rolling: of the last step, and then of this one; null where nothing resists it.
  typename Space::Turning* rolling;
};

/// Manifolds that are solved at a time.
template <class T, class Space>
struct ContactBundle {
  void* rows;                ///< `ManifoldRows` over the kernel's lanes, and behind it the rows of the points
  const LanePlaces* places;  ///< of each lane; those without a manifold have the first's
  const LaneSource<T, Space>* sources;  ///< as `places`
  std::uint32_t row_count;              ///< of the manifold that has most
  std::uint32_t filled;                 ///< the first so many lanes have a manifold
  std::uint32_t pushed_a, pushed_b;     ///< the lanes that have one whose body A, or B, can be pushed, as bits
  bool alone;                           ///< for the kernels of one lane
  bool roll;                            ///< whether anything resists rolling
};

/// The kernels for one number of lanes.
template <class T, class Space>
struct ContactKernels {
  using Bundle = ContactBundle<T, Space>;
  using Body = SolverBody<T, Space>;
  using Point = SolverPoint<T, Space>;

  std::uint32_t lanes;
  std::size_t manifold_bytes, row_bytes;

  /// Sets up the rows for a step of duration `step`.
  void (*prepare)(const Bundle&, const Body* bodies, const Point* points, T step, const WarmStart<T>& warm);
  void (*warm_start)(const Bundle&, Body* bodies);
  /// One pass. With `bias` it records the normals along which bodies are pressed.
  void (*solve)(const Bundle&, Body* bodies, const ContactStep<T>& step, bool bias);
  /// The fastest approach of a point that pushes.
  T (*approach)(const Bundle&, const Body* bodies);
  /// The greatest speed at which a point that pushes parts.
  T (*parting)(const Bundle&, const Body* bodies);
  /// Writes the impulses of the points and those that resist rolling, `times` as large.
  void (*store)(const Bundle&, T times, Point* points);
};

/// The kernels across lanes, and those of one.
template <class T, class Space>
struct ContactKernelPair {
  ContactKernels<T, Space> together, alone;
};

GRAZE_DECLARE_KERNEL(const SpaceKernels<ContactKernelPair>& contact_kernels();)

}  // namespace graze
