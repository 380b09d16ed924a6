// One manifold for each flat face that a surface's pieces make together.
//
// A body on a floor of pieces meets each of them by itself: their corners and edges cut its own face, and under a
// lean of milliradians these points come and go. Where each of the points that the body has on the half-space below the
// pieces' common plane stands on a piece that lies in this plane, cutting says nothing: the body stands on the plane,
// and its points and their feature numbers are those on the half-space.
//
// Guarantee: a face takes the place of its pieces' contacts only where nothing of the surface is missing below any of
// its points; which pieces, in which order, and how the surface is cut, changes none of these. Pieces lie in one plane
// up to `level_sine` and to what coordinates lose by rounding. Triangles inside a known face are passed over before
// they are asked, which changes no bit of a manifold.
#pragma once

#include "composite/internal_edges/leaf_in_context.hpp"
#include "composite/leaf_pairs.hpp"
#include "composite/triangle_pair.hpp"
#include "graze/contact.hpp"

namespace graze {

/// The flat faces of one surface that bodies were found to stand on, for the time of one question.
template <class T>
class FlatFaces {
 public:
  /// The faces of a pair whose pieces are met with this margin. The surface is the one of A and B that is a mesh or
  /// height field, or else a compound, while the other is not; else there are no faces. The larger of two meshes is the
  /// surface, if the other bounds a body.
  /// `alone`: nothing is beside A and B.
  FlatFaces(const Part<T>& a, const Part<T>& b, T margin, bool alone);

  /// Whether any triangle may be passed over: a body was found to stand on a face of a surface that lies alone.
  bool knows_faces() const { return alone_ && !faces_.empty(); }
  /// Whether a triangle of the surface needs no contact of its own with a body, and says nothing of whether the two
  /// touch: the body stands on a face that the triangle is inside of, as it lies level with all around it. `touching`:
  /// the shapes are known to touch. Where they are not, the body has to be clear of the plane, and with it of the
  /// triangle.
  bool passes_over(std::uint32_t triangle, const Corners<T>& corners, const Part<T>& body, bool touching) const;
  /// Whether the triangle of a pair of pieces needs no contact of its own with the pair's body.
  bool passes_over(const Part<T>& a, const Part<T>& b, bool touching) const;

  /// The fate of a piece's contact: it stays; it becomes the whole face's, the first time; or it is left out.
  enum class Standing { on_piece, on_face, on_known_face };
  /// Puts the face's contact in place of one that stands on the flat of a piece, the first time.
  Standing stand(const Part<T>& a, const Part<T>& b, Manifold<T>& manifold);
  /// The leaves that the contact of a pair's face is of: the whole surface and the body.
  LeafPair leaves_on_face(const Part<T>& a, const Part<T>& b) const {
    const std::uint32_t body = body_of(a, b).leaf;
    return surface_is_a_ ? LeafPair{surface_->leaf, body} : LeafPair{body, surface_->leaf};
  }

 private:
  struct Face {
    Vec3<T> normal{}, point{};  ///< outward, unit, and a point of the plane; in the world
    const Shape<T>* body = nullptr;
    Pose<T> body_pose{};
    T body_noise{};  ///< the rounding error of coordinates of the body's size
    bool whole = false;
    bool clear = false;  ///< if whole: the body is above the plane, by more than rounding
  };
  /// On more a body does not rest: it lies in rubble, where every try costs a contact and a search.
  static constexpr std::size_t most = 4;

  bool is_level_with(const Face& face, const Vec3<T>& normal, const Vec3<T>& place, T noise) const;
  bool of_body(const Face& face, const Part<T>& body) const {
    return face.body == &body.shape && face.body_pose == body.pose;
  }
  bool rests_on(const Face& face, const Part<T>& body, Manifold<T>& manifold) const;
  /// The contact of a body with the half-space below a face; false where a mesh has more than one, or none.
  bool meets_plane(const Face& face, const Part<T>& body, Manifold<T>& manifold) const;
  /// The surface's piece of a pair, and the body that may stand on it: a piece, or a whole mesh.
  const Part<T>& piece_of(const Part<T>& a, const Part<T>& b) const { return surface_is_a_ ? a : b; }
  const Part<T>& body_of(const Part<T>& a, const Part<T>& b) const { return skin_ ? *skin_ : surface_is_a_ ? b : a; }

  const Part<T>* surface_ = nullptr;
  const Part<T>* skin_ = nullptr;  ///< the body, if it is a mesh
  bool surface_is_a_ = false, alone_;
  T margin_;
  SmallVector<Face, 4> faces_;
};

}  // namespace graze
