// Configurations of a chain of bodies in a static scene, many of them: a robot's poses, spread over ranks.
//
// Guarantee: that of `sweep_lines`: the answers are in the order of the configurations, byte for byte the same whatever
// the number of ranks, and with a journal a sweep that was killed goes on where it was.
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "graze/mpi/sweep.hpp"
#include "graze/world.hpp"

namespace graze::mpi {

/// A chain of bodies, whose poses a configuration gives.
template <class T>
struct Chain {
  std::vector<Shape<T>> links;  ///< the shapes, one for each pose of a configuration
  /// Pairs of links that are tested against each other, by number; neighbours at a joint usually touch and are left
  /// out.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

/// The nearest two bodies of a configuration, in 16 bytes: among all links against all bodies of the scene, and the
/// chain's own pairs.
struct NearestOfChain {
  /// Signed distance: negative where the two overlap; infinite where nothing is within the limit; NaN where a pose is
  /// invalid.
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t link = 0;  ///< the nearest link
  /// The other body: a link, or behind all links the index of a body of the scene. Meaningless without a distance.
  std::uint32_t other = 0;
};

/// Answers one configuration. `poses` holds the pose of each link in the world; rotations are turned to unit length.
/// For equal distances the first link counts, and the scene before the chain's own pairs. Bodies further away than
/// `limit` are not visited.
template <class T>
GRAZE_API NearestOfChain nearest_of_chain(const Chain<T>& chain, const World<T>& scene, std::span<const Pose<T>> poses,
                                          T limit = std::numeric_limits<T>::infinity());

/// Answers all configurations of the file `settings.questions`: for each, and for each of its links, seven numbers of
/// `double` in this machine's order of bytes, the translation's x, y, z and the rotation's x, y, z, w (the bytes that
/// NumPy's `tofile` writes for an array of N x links x 7). The answers are `NearestOfChain`s, one behind the other. All
/// ranks call it, with the same chain and scene: a journal identifies these by kinds, bounds and poses, and by
/// `settings.kind`. Errors of the report are configurations with an invalid pose. Throws as `sweep_lines` does, and
/// `CommonError` for a file that does not end with a whole configuration, for a chain without links, and for pairs of
/// links that do not exist.
template <class T>
GRAZE_API SweepReport sweep_configurations(MPI_Comm comm, SweepSettings settings, const Chain<T>& chain,
                                           const World<T>& scene, std::ostream& stream,
                                           T limit = std::numeric_limits<T>::infinity());

}  // namespace graze::mpi
