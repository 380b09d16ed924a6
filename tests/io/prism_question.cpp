// Two dimensions: a figure of the plane is a prism along Z.
//
// A prism's shortest way out of another lies in the plane as long as both are deeper than the figures are wide, so
// every query in space answers the question in the plane, and only the z coordinates are left out of the answer.
#include "io/prism_question.hpp"

#include <cmath>

namespace graze::io {

namespace {

/// The prism |z| <= depth over the convex hull of two discs.
template <class T>
class TaperedPrism final : public SupportFunction<T> {
 public:
  TaperedPrism(const Capsule<T>& capsule, T depth) : capsule_(capsule), depth_(depth) {}
  Vec3<T> support(const Vec3<T>& d) const override {
    const Vec3<T> flat{d.x, d.y, T(0)};
    const Vec3<T> across = flat == Vec3<T>{} ? Vec3<T>{T(0), T(1), T(0)} : normalized(flat);
    const T h = capsule_.half_height(), bottom = capsule_.radius_bottom(), top = capsule_.radius_top();
    const bool up = h * across.y + top >= bottom - h * across.y;
    const Vec3<T> p = Vec3<T>{T(0), up ? h : -h, T(0)} + across * (up ? top : bottom);
    return {p.x, p.y, d.z < T(0) ? -depth_ : depth_};
  }

 private:
  Capsule<T> capsule_;
  T depth_;
};

/// The prism |z| <= depth over an ellipse.
template <class T>
class EllipticPrism final : public SupportFunction<T> {
 public:
  EllipticPrism(const Vec3<T>& radii, T depth) : radii_(radii), depth_(depth) {}
  Vec3<T> support(const Vec3<T>& d) const override {
    const Vec3<T> scaled{radii_.x * d.x, radii_.y * d.y, T(0)};
    const Vec3<T> unit = scaled == Vec3<T>{} ? Vec3<T>{T(0), T(1), T(0)} : normalized(scaled);
    return {radii_.x * unit.x, radii_.y * unit.y, d.z < T(0) ? -depth_ : depth_};
  }

 private:
  Vec3<T> radii_;
  T depth_;
};

template <class T>
std::vector<Vec3<T>> read_plane_points(const JsonValue& json, std::optional<std::size_t> count = {}) {
  std::vector<Vec3<T>> points;
  for (const JsonValue& p : json.elements(count)) points.push_back(p.plane_vector<T>());
  return points;
}

template <class T>
Shape<T> prism_over(const std::vector<Vec3<T>>& points, T depth, T margin) {
  std::vector<Vec3<T>> both;
  for (const Vec3<T>& p : points)
    for (const T z : {-depth, depth}) both.push_back({p.x, p.y, z});
  return {ConvexHull<T>(both), margin};
}

template <class T>
Quat<T> turn(const JsonValue& json) {
  const T angle = json.number<T>();
  return Quat<T>::from_axis_angle({T(0), T(0), T(1)}, angle);
}

template <class T>
Shape<T> read_figure(const JsonValue& json, T depth);

template <class T>
Shape<T> read_children(const JsonValue& json, T depth) {
  json.keys({"children"});
  const JsonValue list = json.at("children");
  std::vector<Placed<T>> children;
  for (const JsonValue& child : list.elements()) {
    child.keys({"shape", "translation", "rotation"});
    Placed<T> placed{read_figure<T>(child.at("shape"), depth), {}};
    if (const auto v = child.find("translation")) placed.pose.translation = v->template plane_vector<T>();
    if (const auto v = child.find("rotation")) placed.pose.rotation = turn<T>(*v);
    children.push_back(std::move(placed));
  }
  if (children.empty()) list.fail("at least one child");
  return Compound<T>(std::move(children));
}

template <class T>
Shape<T> read_capsule(const JsonValue& json, T depth, T margin) {
  json.keys({"height", "radiusBottom", "radiusTop"});
  const auto length = [&](const char* key) { return json.at(key).template length<T>(); };
  const Capsule<T> capsule(length("height"), length("radiusBottom"), length("radiusTop"));
  if (capsule.tapered()) return {UserConvex<T>(std::make_shared<TaperedPrism<T>>(capsule, depth)), margin};
  const T h = capsule.half_height();
  return prism_over<T>({{T(0), -h, T(0)}, {T(0), h, T(0)}}, depth, margin + capsule.radius_top());
}

template <class T>
Shape<T> read_figure(const JsonValue& json, T depth) {
  if (!json.json().is_object()) json.fail("an object");
  const JsonValue type = json.at("type");
  const std::string name = type.json().is_string() ? type.string() : "";
  static constexpr const char* names[] = {"circle", "box",     "capsule", "plane",
                                          "convex", "segment", "ellipse", "compound"};
  const char* known = nullptr;
  for (const char* n : names)
    if (name == n) known = n;
  if (!known) type.fail("one of circle, box, capsule, plane, convex, segment, ellipse, compound");
  name == "compound" ? json.keys({"type", known}) : json.keys({"type", known, "margin"});
  T margin(0);
  if (const auto m = json.find("margin")) margin = m->length<T>();
  if (name == "plane") {
    if (const auto own = json.find("plane")) own->keys({});
    return {HalfSpace<T>(), margin};
  }
  const JsonValue own = json.at(known);
  if (name == "circle") {
    own.keys({"radius"});
    const T r = own.at("radius").template length<T>();
    return {LineSegment<T>({T(0), T(0), -depth}, {T(0), T(0), depth}), margin + r};
  }
  if (name == "box") {
    own.keys({"size"});
    const auto size = own.at("size").elements(2);
    return {Box<T>({size[0].length<T>(), size[1].length<T>(), T(2) * depth}), margin};
  }
  if (name == "ellipse") {
    own.keys({"radii"});
    const auto radii = own.at("radii").elements(2);
    const Vec3<T> of_axes{radii[0].length<T>(), radii[1].length<T>(), T(0)};
    return {UserConvex<T>(std::make_shared<EllipticPrism<T>>(of_axes, depth)), margin};
  }
  if (name == "capsule") return read_capsule<T>(own, depth, margin);
  if (name == "compound") return read_children<T>(own, depth);
  own.keys({"points"});
  const std::optional<std::size_t> count = name == "segment" ? std::optional<std::size_t>(2) : std::nullopt;
  const std::vector<Vec3<T>> points = read_plane_points<T>(own.at("points"), count);
  if (points.empty()) own.at("points").fail("at least one point");
  return prism_over(points, depth, margin);
}

template <class T>
MovingBody<T> read_plane_body(const JsonValue& json, T depth) {
  json.keys({"shape", "translation", "rotation", "linear", "angular"});
  MovingBody<T> body{read_figure<T>(json.at("shape"), depth)};
  if (const auto v = json.find("translation")) body.pose.translation = v->template plane_vector<T>();
  if (const auto v = json.find("rotation")) body.pose.rotation = turn<T>(*v);
  if (const auto v = json.find("linear")) body.linear = v->template plane_vector<T>();
  if (const auto v = json.find("angular")) body.angular = {T(0), T(0), v->template number<T>()};
  return body;
}

/// How far a figure reaches from its origin.
template <class T>
T reach(const Shape<T>& shape) {
  return shape.visit([](const auto& c) { return c.core_extent(); }) + shape.rounding();
}

}  // namespace

template <class T>
Question<T> read_prism_question(const JsonValue& json) {
  Question<T> question;
  question.query = read_query_kind(json.at("query"));
  // Once without depth, to learn how wide the figures are; then with one that no overlap in the plane can reach.
  const auto both = [&](T depth) {
    question.a = read_plane_body<T>(json.at("a"), depth);
    if (const auto b = json.find("b")) question.b = read_plane_body<T>(*b, depth);
  };
  both(T(0));
  const T wide = reach(question.a->shape) + (question.b ? reach(question.b->shape) : T(0));
  both(wide > T(0) ? T(2) * wide : T(1));
  if (const auto m = json.find("margin")) question.margin = m->template length<T>();
  if (const auto p = json.find("point")) question.point = p->template plane_vector<T>();
  if (const auto d = json.find("duration")) question.duration = d->template length<T>();
  if (const auto r = json.find("ray")) {
    question.ray = Ray<T>{r->at("origin").template plane_vector<T>(), r->at("direction").template plane_vector<T>()};
    if (const auto l = r->find("length")) question.ray_length = l->template positive_or_zero<T>();
  }
  return question;
}

template <class T>
Shape<T> read_prism(const JsonValue& json, T depth) {
  return read_figure<T>(json, depth);
}

template Question<double> read_prism_question(const JsonValue&);
template Shape<double> read_prism(const JsonValue&, double);

}  // namespace graze::io
