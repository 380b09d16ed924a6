#include "dynamics/surfaces.hpp"

#include <cmath>
#include <string>

#include "dynamics/simulation_parts.hpp"
#include "graze/plane/proximity.hpp"
#include "graze/query.hpp"

namespace graze {

namespace {

/// The part of the smaller body's size up to which a point may be off the surface of its piece, by rounding and by the
/// faces of a floor that are laid together.
template <class T>
constexpr T off_surface = T(0.001);

/// The number of pieces that `ContactManifold::piece_a` counts: 0 for shapes that have no numbered pieces.
template <class T>
std::size_t piece_count(const Shape<T>& shape) {
  if (const auto* mesh = shape.template as<Mesh<T>>()) return mesh->triangles().size();
  if (const auto* field = shape.template as<HeightField<T>>()) return 2 * (field->columns() - 1) * (field->rows() - 1);
  if (const auto* compound = shape.template as<Compound<T>>()) return compound->children().size();
  return 0;
}
template <class T>
std::size_t piece_count(const plane::Shape<T>& shape) {
  if (const auto* chain = shape.template as<plane::Chain<T>>()) return chain->pieces().size();
  if (const auto* compound = shape.template as<plane::Compound<T>>()) return compound->children().size();
  return 0;
}

/// Room for the pieces that are near a point, of shapes of either space.
template <class T>
std::vector<PieceDistance<T>> room_for_pieces(const Shape<T>*);
template <class T>
std::vector<plane::PieceDistance<T>> room_for_pieces(const plane::Shape<T>*);
template <class Shape>
using NearPieces = decltype(room_for_pieces(static_cast<const Shape*>(nullptr)));

template <class T>
void find_pieces(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, T near,
                 NearPieces<Shape<T>>& pieces) {
  near_pieces(shape, pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{point, {}}, near, pieces);
}
template <class T>
void find_pieces(const plane::Shape<T>& shape, const plane::Pose2<T>& pose, const plane::Vec2<T>& point, T near,
                 NearPieces<plane::Shape<T>>& pieces) {
  near_pieces(shape, pose, plane::Shape<T>(plane::Circle<T>(T(0))), plane::Pose2<T>{point, {}}, near, pieces);
}

/// The piece whose surface is nearest to a point, of several the first; `known` where none is within `near`. `pieces`
/// is overwritten: room that is kept from point to point.
template <class Shape, class Pose, class Vec, class T>
std::uint32_t piece_at(const Shape& shape, const Pose& pose, const Vec& point, T near, std::uint32_t known,
                       NearPieces<Shape>& pieces) {
  pieces.clear();
  find_pieces(shape, pose, point, near, pieces);
  T least_gap = near;
  bool found = false;
  for (const auto& piece : pieces) {
    const T gap = std::abs(piece.distance.distance);
    if (found ? gap > least_gap || (gap == least_gap && piece.piece_a >= known) : gap > least_gap) continue;
    found = true;
    least_gap = gap;
    known = piece.piece_a;
  }
  return known;
}

/// Throws `InvalidValue` for materials that are not those of the shape's pieces.
template <class T, class Space>
void check_pieces(const typename Space::Shape& shape, std::span<const MaterialIn<T, Space>> materials,
                  std::span<const std::uint32_t> of_piece) {
  for (std::size_t i = 0; i < materials.size(); ++i) try {
      check(materials[i]);
    } catch (const InvalidValue& e) {
      throw e.below("materials[" + std::to_string(i) + "]");
    }
  const std::size_t count = piece_count(shape);
  if (count == 0)
    throw InvalidValue("body", "one whose shape has pieces: a compound, mesh, height field or chain",
                       std::string("a ") + shape.name());
  if (of_piece.size() != count)
    throw InvalidValue("of_piece", "a number for each of the " + std::to_string(count) + " pieces",
                       std::to_string(of_piece.size()));
  for (std::size_t i = 0; i < count; ++i)
    if (of_piece[i] >= materials.size())
      throw InvalidValue("of_piece[" + std::to_string(i) + "]",
                         "the place of one of the " + std::to_string(materials.size()) + " materials",
                         std::to_string(of_piece[i]));
}

}  // namespace

/// Cuts the manifolds of pairs of which either body has materials of its pieces.
template <class T, class Space>
void SimulationParts<T, Space>::cut_manifolds() {
  const ContactArrays<T, Space>& contacts = world.contacts();
  const auto shapes = world.bodies().shapes();
  NearPieces<typename Space::Shape> near_point;
  const auto material_at = [&](std::uint32_t index, const typename Space::Vec& point, T near, std::uint32_t piece,
                               bool alone) {
    const SimulatedBody<T, Space>& body = bodies[index];
    if (!body.pieces) return &body.material;
    if (!alone) piece = piece_at(shapes[index], found_at[index], point, near, piece, near_point);
    const auto& of_piece = body.pieces->of_piece;
    return piece < of_piece.size() ? &body.pieces->materials[of_piece[piece]] : &body.material;
  };
  for (std::size_t i = 0; i < contacts.pairs.size(); ++i) {
    const ContactPair<T>& pair = contacts.pairs[i];
    if (!bodies[pair.a].pieces && !bodies[pair.b].pieces) continue;
    const T near = off_surface<T> * least(bodies[pair.a].size, bodies[pair.b].size);
    const auto first = static_cast<std::uint32_t>(cut.manifolds.size());
    for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair)) {
      const auto points = contacts.points_of(m);
      for (std::uint32_t p = 0; p < m.point_count; ++p) {
        const typename CutManifolds<T, Space>::Sides sides{
            material_at(pair.a, points[p].a, near, m.piece_a, m.point_count == 1),
            material_at(pair.b, points[p].b, near, m.piece_b, m.point_count == 1)};
        if (p > 0 && sides == cut.sides.back()) {
          ++cut.manifolds.back().point_count;
          continue;
        }
        cut.manifolds.push_back({m.normal, m.piece_a, m.piece_b, m.first_point + p, 1});
        cut.sides.push_back(sides);
      }
    }
    const auto count = static_cast<std::uint32_t>(cut.manifolds.size()) - first;
    cut.pairs.push_back({static_cast<std::uint32_t>(i), first, count});
  }
}

template <class T, class Space>
void Simulation<T, Space>::set_materials(BodyId id, std::span<const MaterialIn<T, Space>> materials,
                                         std::span<const std::uint32_t> of_piece) {
  const std::uint32_t index = parts_->checked(id);
  check_pieces<T, Space>(parts_->world.bodies().shapes()[index], materials, of_piece);
  auto pieces = std::make_shared<PieceMaterials<T, Space>>();
  pieces->materials.assign(materials.begin(), materials.end());
  pieces->of_piece.assign(of_piece.begin(), of_piece.end());
  parts_->bodies[index].pieces = std::move(pieces);
  parts_->wake_around(index);
}

#define GRAZE_SURFACES(T, Space)                                                                                       \
  template void SimulationParts<T, Space>::cut_manifolds();                                                            \
  template void Simulation<T, Space>::set_materials(BodyId, std::span<const MaterialIn<T, Space>>,                     \
                                                    std::span<const std::uint32_t>);
GRAZE_SURFACES(float, Space<float>)
GRAZE_SURFACES(double, Space<double>)
GRAZE_SURFACES(float, plane::Space<float>)
GRAZE_SURFACES(double, plane::Space<double>)
#undef GRAZE_SURFACES

}  // namespace graze
