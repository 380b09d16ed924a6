// Many configurations of a chain of bodies in a scene that stands still: a robot's poses, spread over ranks.
//
// Guarantee: as `sweep_lines`: the answers stand in the order of the configurations, byte for byte the same whatever
// the number of ranks, and with a journal a sweep that was killed goes on where it was.
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "graze/mpi/sweep.hpp"
#include "graze/world.hpp"

namespace graze::mpi {

/// Bodies whose poses a configuration says.
template <class T>
struct Chain {
  std::vector<Shape<T>> links;  ///< one for each pose of a configuration
  /// Of links that must not touch each other either, by number; neighbours at a joint usually do.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

/// The nearest two of a configuration, 16 bytes: of all links against all bodies of the scene, and the chain's pairs.
struct NearestOfChain {
  /// Signed: negative where they overlap; infinite where nothing is within the limit; not a number where a pose is
  /// none.
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t link = 0;  ///< the link that is nearest
  /// The other of the two: a link, or behind all links the index of a body of the scene. No meaning without a distance.
  std::uint32_t other = 0;
};

/// Answers one configuration: `poses`, of each link in the world; a rotation is turned to unit length. Of equal
/// distances the first link's counts, and the scene's before the chain's own. What is further than `limit` is not
/// looked at.
template <class T>
GRAZE_API NearestOfChain nearest_of_chain(const Chain<T>& chain, const World<T>& scene, std::span<const Pose<T>> poses,
                                          T limit = std::numeric_limits<T>::infinity());

/// Answers all configurations of a file, `settings.questions`: for each, and for each of its links, seven numbers of
/// `double` in this machine's order of bytes, the translation's x, y, z and the rotation's x, y, z, w (what NumPy's
/// `tofile` writes of an array of N x links x 7). The answers are `NearestOfChain`s, one behind the other. All ranks,
/// with the same chain and scene: a journal knows them by kinds, bounds and places, and by `settings.kind`. Errors of
/// the report are configurations with a pose that is none. Throws as `sweep_lines`, and `CommonError` for a file that
/// does not end with a configuration, and for a chain without links or of pairs that it has not.
template <class T>
GRAZE_API SweepReport sweep_configurations(MPI_Comm comm, SweepSettings settings, const Chain<T>& chain,
                                           const World<T>& scene, std::ostream& stream,
                                           T limit = std::numeric_limits<T>::infinity());

}  // namespace graze::mpi
