#include "io/plane_question.hpp"

#include "io/question_parts.hpp"

namespace graze::io {

namespace {

template <class T>
plane::Vec2<T> read_vector2(const JsonValue& json) {
  const Vec3<T> v = json.plane_vector<T>();
  return {v.x, v.y};
}

template <class T>
plane::Rot2<T> read_angle(const JsonValue& json) {
  // The turn is computed in double, whatever the precision: a float's sine would lose a digit that its cosine keeps.
  const plane::Rot2<double> turn = plane::Rot2<double>::from_angle(double(json.number<T>()));
  return plane::converted<T>(turn);
}

template <class T>
void read_place(const JsonValue& json, plane::Pose2<T>& pose) {
  if (const auto v = json.find("translation")) pose.translation = read_vector2<T>(*v);
  if (const auto v = json.find("rotation")) pose.rotation = read_angle<T>(*v);
}

/// The result of `make`; errors of it get the path of the value.
template <class F>
auto built_below(const JsonValue& json, const F& make) {
  try {
    return make();
  } catch (const InvalidValue& e) {
    throw e.below(json.path());
  }
}

template <class T>
plane::Compound<T> read_plane_compound(const JsonValue& json) {
  json.keys({"children"});
  const JsonValue list = json.at("children");
  std::vector<plane::Placed<T>> children;
  for (const JsonValue& child : list.elements()) {
    child.keys({"shape", "translation", "rotation"});
    plane::Placed<T> placed{read_plane_shape<T>(child.at("shape")), {}};
    read_place(child, placed.pose);
    children.push_back(std::move(placed));
  }
  if (children.empty()) list.fail("at least one child");
  return built_below(json, [&] { return plane::Compound<T>(std::move(children)); });
}

template <class T>
std::vector<plane::Vec2<T>> read_plane_points(const JsonValue& json, std::optional<std::size_t> count = {}) {
  const JsonValue list = json.at("points");
  std::vector<plane::Vec2<T>> points;
  for (const JsonValue& p : list.elements(count)) points.push_back(read_vector2<T>(p));
  if (points.empty()) list.fail("at least one point");
  return points;
}

template <class T>
plane::Chain<T> read_chain(const JsonValue& json) {
  json.keys({"points", "closed", "sides"});
  const std::vector<plane::Vec2<T>> points = read_plane_points<T>(json);
  bool closed = false;
  if (const auto c = json.find("closed")) closed = c->boolean();
  plane::ChainSides sides = plane::ChainSides::both;
  if (const auto s = json.find("sides")) {
    const std::string name = s->json().is_string() ? s->string() : "";
    if (name != "one" && name != "both") s->fail("one or both");
    if (name == "one") sides = plane::ChainSides::one;
  }
  return built_below(json, [&] { return plane::Chain<T>(points, closed, sides); });
}

template <class T>
plane::Polygon<T> read_polygon(const JsonValue& json) {
  json.keys({"points"});
  const std::vector<plane::Vec2<T>> points = read_plane_points<T>(json);
  return built_below(json, [&] { return plane::Polygon<T>(points); });
}

template <class T>
plane::Shape<T> read_segment_or_hull(const JsonValue& json, bool segment, T margin) {
  json.keys({"points"});
  const std::optional<std::size_t> count = segment ? std::optional<std::size_t>(2) : std::nullopt;
  const std::vector<plane::Vec2<T>> points = read_plane_points<T>(json, count);
  if (segment) return {plane::Segment<T>(points[0], points[1]), margin};
  return {plane::ConvexPolygon<T>(points), margin};
}

}  // namespace

template <class T>
plane::Shape<T> read_plane_shape(const JsonValue& json) {
  if (!json.json().is_object()) json.fail("an object");
  const JsonValue type = json.at("type");
  const std::string name = type.json().is_string() ? type.string() : "";
  static constexpr const char* names[] = {"circle",  "box",     "capsule", "plane",   "convex",
                                          "segment", "polygon", "chain",   "ellipse", "compound"};
  const char* known = nullptr;
  for (const char* n : names)
    if (name == n) known = n;
  if (!known) type.fail("one of circle, box, capsule, plane, convex, segment, polygon, chain, ellipse, compound");
  json.keys({"type", known, "margin"});
  T margin(0);
  if (const auto m = json.find("margin")) margin = m->length<T>();
  if (name == "plane") {
    if (const auto own = json.find("plane")) own->keys({});
    return {plane::HalfPlane<T>(), margin};
  }
  const JsonValue own = json.at(known);
  const auto length = [&](const char* key) { return own.at(key).template length<T>(); };
  if (name == "circle") {
    own.keys({"radius"});
    return {plane::Circle<T>(length("radius")), margin};
  }
  if (name == "box") {
    own.keys({"size"});
    const auto size = own.at("size").elements(2);
    return {plane::Box<T>({size[0].length<T>(), size[1].length<T>()}), margin};
  }
  if (name == "capsule") {
    own.keys({"height", "radiusBottom", "radiusTop"});
    return {plane::Capsule<T>(length("height"), length("radiusBottom"), length("radiusTop")), margin};
  }
  if (name == "ellipse") {
    own.keys({"radii"});
    const auto radii = own.at("radii").elements(2);
    return {plane::Ellipse<T>({radii[0].length<T>(), radii[1].length<T>()}), margin};
  }
  if (name == "compound") return {read_plane_compound<T>(own), margin};
  if (name == "polygon") return {read_polygon<T>(own), margin};
  if (name == "chain") return {read_chain<T>(own), margin};
  return read_segment_or_hull<T>(own, name == "segment", margin);
}

namespace {

template <class T>
PlaneBody<T> read_plane_body(const JsonValue& json) {
  json.keys({"shape", "translation", "rotation", "linear", "angular"});
  PlaneBody<T> body{read_plane_shape<T>(json.at("shape"))};
  read_place(json, body.pose);
  if (const auto v = json.find("linear")) body.velocity.linear = read_vector2<T>(*v);
  if (const auto v = json.find("angular")) body.velocity.angular = v->number<T>();
  return body;
}

/// Checks a motion: the end of a body's way is a coordinate like any other, and a half-plane does not turn.
template <class T>
void check_plane_motion(const JsonValue& json, const PlaneBody<T>& body, T duration) {
  if (!(plane::max_abs(body.velocity.linear * duration) <= largest_magnitude<T>))
    json.at("linear").fail("a velocity that leads no further than " +
                           validate::number(static_cast<double>(largest_magnitude<T>)) + " within the duration");
  if (body.shape.template as<plane::HalfPlane<T>>() && body.velocity.angular != T(0))
    json.at("angular").fail("no angular velocity of a half-plane");
}

}  // namespace

bool in_the_plane(const Json& question) {
  const auto dimension = question.find("dimension");
  return dimension != question.end() && *dimension == 2;
}

template <class T>
PlaneQuestion<T> read_plane_question(const JsonValue& json) {
  PlaneQuestion<T> q;
  read_parts(json, 2, read_plane_body<T>, read_vector2<T>, q);
  if (q.query == QueryKind::cast) {
    check_plane_motion(json.at("a"), *q.a, q.duration);
    check_plane_motion(json.at("b"), *q.b, q.duration);
  }
  return q;
}

template plane::Shape<float> read_plane_shape(const JsonValue&);
template plane::Shape<double> read_plane_shape(const JsonValue&);
template PlaneQuestion<float> read_plane_question(const JsonValue&);
template PlaneQuestion<double> read_plane_question(const JsonValue&);

}  // namespace graze::io
