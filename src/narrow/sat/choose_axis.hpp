// The choice between the best axis of a face and the best product of edges, and the normal of contacts among the faces
// that are about as good, for one pair and across lanes.
#pragma once

#include "graze/detail/lane_vector.hpp"
#include "simd/lane_of.hpp"

namespace graze {

/// Preference of faces over edges, relative to the smaller shape: the normal of a face is chosen if the overlap along
/// it exceeds the least depth by no more than this, and if its points are further apart than the nearest ones by no
/// more than this. A resting box of size 1 leans by milliradians and sinks in by millimetres; the least depth then
/// changes between faces and edges from frame to frame, and a solver needs the face. The decision whether shapes
/// overlap is independent of it, and every point carries its true distance along the chosen normal.
inline constexpr double face_preference = 1.0 / 200;

/// The best axis of a face and the best one of edges, compared twice: the distance is that of the better one, and
/// contacts prefer the face.
template <class S>
struct AxisChoice {
  using Mask = decltype(S() < S());

  S separation;      ///< along the better of the two
  Mask edge_best;    ///< the edges' axis is better by more than rounding
  Mask edge_chosen;  ///< it is better by more than `face_preference` of the smaller size: contacts stand on it

  /// The signed distance: zero for shapes that touch within `noise`, the rounding of a separation.
  S distance(const S& noise) const {
    using std::abs;
    return select(abs(separation) <= noise, S(0), separation);
  }
  /// Whether the reference axis is that of the edges: outside the margin the better one counts, for lack of contacts.
  Mask by_edge(const Mask& outside) const { return (outside & edge_best) | ((!outside) & edge_chosen); }
};

/// Whether contacts stand on the axis of edges. `smaller`: size of the smaller shape.
template <class S>
auto edge_chosen(const S& face, const S& edge, const S& smaller) {
  return edge > face + S(typename LaneOf<S>::type(face_preference)) * smaller;
}

/// `noise`: rounding of a separation; `smaller`: size of the smaller shape.
template <class S>
AxisChoice<S> choose_axis(const S& face, const S& edge, const S& noise, const S& smaller) {
  const auto edge_best = edge > face + noise;
  return {select(edge_best, edge, face), edge_best, edge_chosen(face, edge, smaller)};
}

/// The best normal of contacts seen so far: a face's, where it separates the shapes about as far as that of least
/// depth.
template <class S>
struct PreferredNormal {
  S most;  ///< largest separation along a face, or the least that one needs
  Vec3<S> best;

  PreferredNormal(const S& distance, const Vec3<S>& normal, const S& smaller)
      : most(distance - S(typename LaneOf<S>::type(face_preference)) * smaller), best(normal) {}

  /// Takes a face's normal along which the shapes are `separation` apart, where `is` says that there is one.
  template <class Mask>
  void consider(const Mask& is, const Vec3<S>& normal, const S& separation) {
    const decltype(S() < S()) better = is & (separation >= most);
    most = select(better, separation, most);
    best = select(better, normal, best);
  }
};

}  // namespace graze
