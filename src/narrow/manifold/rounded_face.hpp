// The surface of a rounded face, the face plus a ball, intersected by a line along the contact normal.
//
// Guarantee: the returned point lies on the surface of the rounded face to double's rounding, whatever the face's lean:
// over its inside on the plane that is offset by the radius, beyond that on the cylinder of an edge or the ball of a
// vertex, whichever the line leaves last.
#pragma once

#include <optional>

#include "narrow/manifold/clip_faces.hpp"

namespace graze {

class RoundedFace {
 public:
  /// `outward` is the unit direction in which the lines leave: the contact normal for A, its opposite for B.
  RoundedFace(const PlacedFace& face, const Vec3d& outward, double radius);

  struct Exit {
    double rise;    ///< distance from `from`
    bool on_plane;  ///< over the inside of the face
  };
  /// The point where the line from a place on the face (or beside an edge) leaves the surface; nothing where it misses.
  /// Costs a few products over the inside, three roots for each edge that lies between it and the foot.
  std::optional<Exit> exit(const Vec3d& from) const;

 private:
  double leaves_edge(const Vec3d& from, const Vec3d& start, const Vec3d& end) const;

  const PlacedFace& face_;
  Vec3d outward_, normal_{};
  double radius_, up_ = 0;
};

}  // namespace graze
