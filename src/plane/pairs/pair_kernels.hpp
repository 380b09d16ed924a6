// The special pairs of the plane as kernels: a block of pairs of one entry at a time, or one pair.
//
// Guarantee: a pair has the same bits in both, at every level of the instruction set.
#pragma once

#include "plane/pairs/pair_list.hpp"
#include "simd/dispatch.hpp"

namespace graze {

namespace plane {

/// Pairs in a block.
inline constexpr std::size_t block_pairs = 64;

/// Two shapes in place as columns of numbers, for N pairs.
template <std::size_t N>
struct PairColumns {
  alignas(64) double a[shape_columns][N], b[shape_columns][N];
};

/// Distances of N pairs, in the world. `known` is 1 or 0, as are all flags in columns.
template <std::size_t N>
struct DistanceColumns {
  alignas(64) double known[N];
  double distance[N], normal[2][N], a[2][N], b[2][N];
};
/// The numbers of a point: a, b, distance, feature, weight.
inline constexpr std::size_t point_columns = 7;
template <std::size_t N>
struct ContactColumns {
  alignas(64) double known[N];
  double overlap[N], filled[N];  ///< the latter 1 for the first point, 2 for the second
  double normal[2][N];
  double points[2][point_columns][N];
};
template <std::size_t N>
struct OverlapColumns {
  alignas(64) double known[N];
  double overlap[N];
};

/// The kernels of one entry of the list, for a pair alone.
struct AloneKernels {
  void (*overlap)(const PairColumns<1>&, OverlapColumns<1>&);
  void (*distance)(const PairColumns<1>&, DistanceColumns<1>&);
  void (*contacts)(const PairColumns<1>&, double margin, ContactColumns<1>&);
};

/// The kernels of one entry of the list, for a block of pairs. Each pair has a margin of its own for its contacts.
struct PairKernels {
  void (*overlaps)(const PairColumns<block_pairs>&, std::size_t count, OverlapColumns<block_pairs>&);
  void (*distances)(const PairColumns<block_pairs>&, std::size_t count, DistanceColumns<block_pairs>&);
  void (*contacts)(const PairColumns<block_pairs>&, std::size_t count, const double (&margins)[block_pairs],
                   ContactColumns<block_pairs>&);
};

}  // namespace plane

/// The kernels of the list's entries, in its order.
GRAZE_DECLARE_KERNEL(const plane::AloneKernels* plane_alone_kernels(); const plane::PairKernels* plane_pair_kernels();)

}  // namespace graze
