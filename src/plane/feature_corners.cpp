#include "graze/plane/feature_corners.hpp"

#include <algorithm>

#include "plane/core.hpp"

namespace graze::plane {

namespace {

/// The number of feature numbers: larger ones do not fit into a feature.
constexpr std::uint32_t most_numbers = 1u << graze::detail::feature_number_bits;

template <class T>
using Corners = SmallVector<Vec2<T>, 2>;

template <class T>
Corners<T> corners_of(const Core<T>& core, const Feature& feature) {
  Corners<T> corners;
  if (feature.number >= core.count || core.count > most_numbers) return corners;
  if (feature.kind == FeatureKind::vertex || feature.kind == FeatureKind::edge)
    corners.push_back(plane::converted<T>(core.vertex(feature.number)));
  if (feature.kind == FeatureKind::edge) corners.push_back(plane::converted<T>(core.vertex(core.next(feature.number))));
  return corners;
}

/// Corners of a capsule: the centres of its discs, also where it is tapered.
template <class T>
Corners<T> corners_of(const Capsule<T>& capsule, const Feature& feature) {
  const T h = capsule.half_height();
  return corners_of(polygon_core<T>(0, Vec2<T>{T(0), -h}, Vec2<T>{T(0), h}), feature);
}

/// Corners of one piece, whose features have the numbers of the whole outline. Both edges of a chain's segment are one
/// feature.
template <class T>
Corners<T> corners_of(const Pieces<T>& pieces, std::uint32_t piece, const Feature& feature) {
  const Core<T> core = piece_core(pieces, piece);
  for (std::uint32_t i = 0; i < core.count; ++i)
    if (core.outline[i].number == feature.number &&
        (feature.kind == FeatureKind::vertex || core.outline[i].outer || core.count == 2))
      return corners_of(core, {feature.kind, i});
  return {};
}

template <class T>
std::uint32_t largest_number(const Pieces<T>& pieces) {
  std::uint32_t largest = 0;
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = 0; k < pieces.vertices(i).size(); ++k)
      largest = greatest(largest, pieces.outline(i)[k].number);
  return largest;
}

/// Corners of the piece that touches; else of any, where no two pieces have different parts of that name.
template <class T>
Corners<T> corners_in(const Pieces<T>& pieces, std::uint32_t piece, const Feature& feature) {
  if (largest_number(pieces) >= most_numbers) return {};
  Corners<T> corners;
  if (piece < pieces.size()) corners = corners_of(pieces, piece, feature);
  if (!corners.empty()) return corners;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Corners<T> found = corners_of(pieces, i, feature);
    if (found.empty()) continue;
    if (!corners.empty() && !std::equal(found.begin(), found.end(), corners.begin(), corners.end())) return {};
    corners = found;
  }
  return corners;
}

/// Corners of a child in its compound's frame. None in a compound within a compound, whose child is not known.
template <class T>
Corners<T> corners_in(const Compound<T>& compound, std::uint32_t piece, const Feature& feature) {
  if (piece >= compound.children().size()) return {};
  const Placed<T>& child = compound.children()[piece];
  if (child.shape.template as<Compound<T>>()) return {};
  constexpr std::uint32_t unknown = ~0u;
  Corners<T> corners = feature_corners(child.shape, unknown, feature);
  for (Vec2<T>& corner : corners) corner = transform(child.pose, corner);
  return corners;
}

/// Whether shapes of the kind C have corners: not where they are round or endless.
template <class C>
inline constexpr bool has_corners = true;
template <class T>
inline constexpr bool has_corners<Circle<T>> = false;
template <class T>
inline constexpr bool has_corners<Ellipse<T>> = false;
template <class T>
inline constexpr bool has_corners<UserConvex<T>> = false;
template <class T>
inline constexpr bool has_corners<HalfPlane<T>> = false;

}  // namespace

template <class T>
SmallVector<Vec2<T>, 2> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature) {
  return shape.visit([&](const auto& concrete) -> Corners<T> {
    using C = std::decay_t<decltype(concrete)>;
    if constexpr (std::is_same_v<C, Compound<T>>)
      return corners_in(concrete, piece, feature);
    else if constexpr (has_pieces<C>)
      return corners_in(concrete.pieces(), piece, feature);
    else if constexpr (std::is_same_v<C, Capsule<T>>)
      return corners_of(concrete, feature);
    else if constexpr (has_corners<C>)
      return corners_of(core_of(concrete), feature);
    else
      return {};
  });
}

template SmallVector<Vec2<float>, 2> feature_corners(const Shape<float>&, std::uint32_t, Feature);
template SmallVector<Vec2<double>, 2> feature_corners(const Shape<double>&, std::uint32_t, Feature);

}  // namespace graze::plane
