#include <algorithm>

#include "graze/plane/shape.hpp"
#include "plane/compound_data.hpp"
#include "plane/core.hpp"
#include "plane/orientation.hpp"

namespace graze::plane {

namespace {

template <class T>
bool turns_left(const Vec2<T>& a, const Vec2<T>& b, const Vec2<T>& c) {
  return orientation(converted<double>(a), converted<double>(b), converted<double>(c)) > 0;
}

/// The hull of points sorted from the lowest up, counter-clockwise (Andrew 1979, "Another efficient algorithm for
/// convex hulls in two dimensions").
template <class T>
std::vector<Vec2<T>> hull_of_sorted(const std::vector<Vec2<T>>& points) {
  if (points.size() < 3) return points;
  std::vector<Vec2<T>> hull;
  const auto append = [&](const Vec2<T>& p, std::size_t from) {
    while (hull.size() >= from + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2<T>& p : points) append(p, 0);
  const std::size_t turn = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) append(points[i], turn);
  hull.pop_back();  // the first point again
  return hull;
}

}  // namespace

template <class T>
ConvexPolygon<T>::ConvexPolygon(std::span<const Vec2<T>> points) {
  if (points.empty()) throw InvalidValue("points", "at least one point", "none");
  std::vector<Vec2<T>> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2<T> p = detail::checked_point(points[i], "points[" + std::to_string(i) + "]");
    sorted.push_back({p.x + T(0), p.y + T(0)});  // no negative zero
    extent_ = greatest(extent_, length(p));
  }
  std::sort(sorted.begin(), sorted.end(),
            [](const Vec2<T>& a, const Vec2<T>& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());

  std::vector<Vec2<T>> hull = hull_of_sorted(sorted);
  count_ = hull.size();
  if (count_ <= in_place)
    std::copy(hull.begin(), hull.end(), inside_.begin());
  else
    outside_ = std::make_shared<const std::vector<Vec2<T>>>(std::move(hull));
}

template <class T>
Compound<T>::Compound(std::vector<Placed<T>> children) {
  if (children.empty()) throw InvalidValue("children", "at least one child", "none");
  auto data = std::make_shared<CompoundData<T>>();
  for (std::size_t i = 0; i < children.size(); ++i) {
    Placed<T>& child = children[i];
    const std::string path = "children[" + std::to_string(i) + "]";
    detail::checked_point(child.pose.translation, path + ".translation");
    const Rot2<T> turn = child.pose.rotation;
    if (!(max_abs(Vec2<T>{turn.cosine, turn.sine}) > T(0) && std::isfinite(turn.cosine) && std::isfinite(turn.sine)))
      throw InvalidValue(path + ".rotation", "a finite direction that is not zero",
                         "[" + validate::number(static_cast<double>(turn.cosine)) + ", " +
                             validate::number(static_cast<double>(turn.sine)) + "]");
    child.pose.rotation = normalized(turn);
    const T reach = length(child.pose.translation) + plane::extent(child.shape);
    // The reaches of compounds within compounds add up.
    constexpr T furthest = T(8) * largest_magnitude<T>;
    if (!(reach <= furthest))
      validate::fail(path, "a child that reaches at most " + validate::number(static_cast<double>(furthest)),
                     static_cast<double>(reach));
    extent_ = greatest(extent_, reach);
    data->nesting.add_child(bounded_nesting<Compound<T>>(child, path));
  }
  data->children = std::move(children);
  data_ = std::move(data);
}

template <class T>
std::span<const Placed<T>> Compound<T>::children() const {
  return data_->children;
}

namespace {

/// The bounds of a convex core; `extent` is that of the shape that it belongs to.
template <class T>
Aabb2<T> core_bounds(const Core<T>& core, T extent, const Pose2<T>& pose) {
  constexpr T inf = std::numeric_limits<T>::infinity();
  if (core.kind == CoreKind::half_plane) {
    const Vec2<T> n = rotate(pose.rotation, Vec2<T>{T(0), T(1)});
    Aabb2<T> half{{-inf, -inf}, {inf, inf}};
    const T moved = static_cast<T>(core.radius);
    if (n.x == T(0)) (n.y > T(0) ? half.upper : half.lower).y = pose.translation.y + n.y * moved;
    if (n.y == T(0)) (n.x > T(0) ? half.upper : half.lower).x = pose.translation.x + n.x * moved;
    return half;
  }
  const Rot2d turn = converted<double>(pose.rotation);
  const auto reach = [&](const Vec2d& d) {
    return dot(support(core, inverse_rotate(turn, d)).point, inverse_rotate(turn, d)) + core.radius;
  };
  const Vec2d upper{reach({1, 0}), reach({0, 1})}, lower{-reach({-1, 0}), -reach({0, -1})};
  // Four roundings of numbers as large as the extent or the translation: rotation, sum and conversion.
  const T slack = T(4) * std::numeric_limits<T>::epsilon() * (extent + max_abs(pose.translation));
  return {pose.translation + converted<T>(lower) - Vec2<T>{slack, slack},
          pose.translation + converted<T>(upper) + Vec2<T>{slack, slack}};
}

/// The bounds of a shape with the rounding `grown` of the compounds that it is in.
template <class T>
Aabb2<T> bounds_grown(const Shape<T>& shape, const Pose2<T>& pose, T grown) {
  constexpr T inf = std::numeric_limits<T>::infinity();
  Aabb2<T> all{{inf, inf}, {-inf, -inf}};
  if (const auto* compound = shape.template as<Compound<T>>()) {
    for (const Placed<T>& child : compound->children())
      all = merged(all, bounds_grown(child.shape, compose(pose, child.pose), shape.rounding() + grown));
    return all;
  }
  const T size = extent(shape) + grown;
  const auto* polygon = shape.template as<Polygon<T>>();
  const auto* chain = shape.template as<Chain<T>>();
  if (!polygon && !chain) {
    Core<T> core = convex_core(shape);
    core.radius += double(grown);
    return core_bounds(core, size, pose);
  }
  const Pieces<T>& pieces = polygon ? polygon->pieces() : chain->pieces();
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    Core<T> core = piece_core(pieces, i);
    core.radius = double(shape.rounding()) + double(grown);
    all = merged(all, core_bounds(core, size, pose));
  }
  return all;
}

}  // namespace

template <class T>
Aabb2<T> bounds(const Shape<T>& shape, const Pose2<T>& pose) {
  return bounds_grown(shape, pose, T(0));
}

template class ConvexPolygon<float>;
template class ConvexPolygon<double>;
template class Compound<float>;
template class Compound<double>;
template Aabb2<float> bounds(const Shape<float>&, const Pose2<float>&);
template Aabb2<double> bounds(const Shape<double>&, const Pose2<double>&);

}  // namespace graze::plane
