// The partition of space among ranks: recursive coordinate bisection (Berger and Bokhari 1987), by Zoltan.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

#include "graze/aabb.hpp"

struct Zoltan_Struct;

namespace graze::mpi {

/// A body in the form that the partition needs.
struct Load {
  Vec3<double> place;
  double weight;
};

/// The regions of the ranks. Guarantee: every point belongs to one rank, and a rank whose region a box meets is among
/// those of the box; so is the rank of any point in it.
class Partition {
 public:
  explicit Partition(MPI_Comm comm);
  ~Partition();
  Partition(const Partition&) = delete;
  Partition& operator=(const Partition&) = delete;

  /// Draws the borders so that each rank has about the same weight. All ranks, each with its own loads.
  void draw(std::span<const Load> loads);
  bool drawn() const { return drawn_; }

  /// The rank of a point. Costs next to nothing for one inside the region of this rank.
  int rank_of_point(const Vec3<double>& point) const;
  /// Appends the ranks whose regions a box meets.
  void ranks_of_box(const Aabb<double>& box, std::vector<int>& out) const;
  /// The region of this rank.
  const Aabb<double>& region() const { return region_; }

 private:
  Zoltan_Struct* zoltan_ = nullptr;
  MPI_Comm comm_;
  int own_;
  std::span<const Load> loads_;  ///< while borders are drawn
  Aabb<double> region_ = Aabb<double>::everything();
  mutable std::vector<int> processes_, parts_;
  bool drawn_ = false;
};

}  // namespace graze::mpi
