#include <algorithm>
#include <array>

#include "io/question.hpp"

namespace graze::io {

namespace {

/// The number of a key in the object of a shape's own name, or the default of KHR_implicit_shapes.
template <class T>
T length_or(const std::optional<JsonValue>& json, const char* key, T otherwise) {
  if (!json) return otherwise;
  const auto value = json->find(key);
  return value ? value->length<T>() : otherwise;
}

template <class T>
std::vector<Vec3<T>> read_points(const JsonValue& json) {
  std::vector<Vec3<T>> points;
  for (const JsonValue& p : json.elements()) points.push_back(p.vector<T>());
  return points;
}

/// The result of a constructor, whose errors are about keys of the shape's own object.
template <class F>
auto built(const JsonValue& json, const F& make) {
  try {
    return make();
  } catch (const InvalidValue& e) {
    throw e.below(json.path());
  }
}

template <class T>
Shape<T> read_plane(const std::optional<JsonValue>& json, T margin) {
  if (json) json->keys({"sizeX", "sizeZ", "doubleSided"});
  if (json && json->has("doubleSided")) json->at("doubleSided").boolean();
  const bool x = json && json->has("sizeX"), z = json && json->has("sizeZ");
  if (!x && !z) return {HalfSpace<T>(), margin};
  return {Rectangle<T>(json->at("sizeX").template length<T>(), json->at("sizeZ").template length<T>()), margin};
}

template <class T>
Shape<T> read_triangle(const JsonValue& json, T margin) {
  json.keys({"points"});
  const auto corners = json.at("points").elements(3);
  return {Triangle<T>(corners[0].vector<T>(), corners[1].vector<T>(), corners[2].vector<T>()), margin};
}

template <class T>
Shape<T> read_mesh(const JsonValue& json) {
  json.keys({"points", "triangles", "solid"});
  std::vector<Vec3<T>> points = read_points<T>(json.at("points"));
  std::vector<typename Mesh<T>::Index> triangles;
  for (const JsonValue& t : json.at("triangles").elements()) {
    typename Mesh<T>::Index index{};
    const auto corners = t.elements(3);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = corners[k].whole_number();
      if (i >= points.size()) corners[k].fail("an index below " + std::to_string(points.size()));
      index[k] = static_cast<std::uint32_t>(i);
    }
    triangles.push_back(index);
  }
  const auto solid = json.find("solid");
  const bool is_solid = solid && solid->boolean();
  return built(json, [&] { return Shape<T>(Mesh<T>(std::move(points), std::move(triangles), Sides::both, is_solid)); });
}

template <class T>
Shape<T> read_height_field(const JsonValue& json) {
  json.keys({"columns", "rows", "spacing", "heights"});
  const std::size_t columns = json.at("columns").whole_number(2), rows = json.at("rows").whole_number(2);
  T dx(1), dz(1);
  if (const auto spacing = json.find("spacing")) {
    const auto parts = spacing->elements(2);
    dx = parts[0].length<T>();
    dz = parts[1].length<T>();
  }
  const JsonValue list = json.at("heights");
  // Sizes are compared by division, so that huge counts cannot overflow into a match.
  if (!list.json().is_array() || list.json().size() / columns != rows || list.json().size() % columns != 0)
    list.fail("an array of columns x rows = " + std::to_string(columns) + " x " + std::to_string(rows) + " values");

  std::vector<T> heights;
  for (const JsonValue& value : list.elements())
    heights.push_back(value.json().is_null() ? std::numeric_limits<T>::quiet_NaN() : value.coordinate<T>());
  return built(json, [&] { return Shape<T>(HeightField<T>(columns, rows, std::move(heights), dx, dz)); });
}

template <class T>
Shape<T> read_compound(const JsonValue& json) {
  json.keys({"children"});
  const JsonValue list = json.at("children");
  std::vector<Placed<T>> children;
  for (const JsonValue& child : list.elements()) {
    child.keys({"shape", "translation", "rotation"});
    Placed<T> placed{read_shape<T>(child.at("shape")), {}};
    if (const auto v = child.find("translation")) placed.pose.translation = v->template vector<T>();
    if (const auto v = child.find("rotation")) {
      const auto parts = v->elements(4);
      placed.pose.rotation = {parts[0].number<T>(), parts[1].number<T>(), parts[2].number<T>(), parts[3].number<T>()};
      if (placed.pose.rotation == Quat<T>{T(0), T(0), T(0), T(0)}) v->fail("a quaternion that is not zero");
    }
    children.push_back(std::move(placed));
  }
  if (children.empty()) list.fail("at least one child");
  return built(json, [&] { return Shape<T>(Compound<T>(std::move(children))); });
}

}  // namespace

template <class T>
Shape<T> read_shape(const JsonValue& json) {
  if (!json.json().is_object()) json.fail("an object");
  const JsonValue type = json.at("type");
  static constexpr const char* names[] = {"sphere", "box",      "capsule", "cylinder",    "plane",   "ellipsoid",
                                          "convex", "triangle", "mesh",    "heightfield", "compound"};
  const auto* known = std::find_if(std::begin(names), std::end(names), [&](const char* n) { return type.json() == n; });
  if (known == std::end(names))
    type.fail("one of sphere, box, capsule, cylinder, plane, ellipsoid, convex, triangle, mesh, heightfield, compound");
  const std::string_view name = *known;
  const bool composite = name == "mesh" || name == "heightfield" || name == "compound";
  composite ? json.keys({"type", name}) : json.keys({"type", name, "margin"});
  T margin(0);
  if (const auto m = json.find("margin")) margin = m->length<T>();

  const auto own = json.find(*known);
  if (name == "sphere") {
    if (own) own->keys({"radius"});
    return {Sphere<T>(length_or(own, "radius", T(0.5))), margin};
  }
  if (name == "box") {
    if (own) own->keys({"size"});
    return {Box<T>(own && own->has("size") ? own->at("size").template lengths<T>() : Vec3<T>{T(1), T(1), T(1)}),
            margin};
  }
  if (name == "capsule" || name == "cylinder") {
    if (own) own->keys({"height", "radiusBottom", "radiusTop"});
    const T height = length_or(own, "height", T(0.5)), bottom = length_or(own, "radiusBottom", T(0.25)),
            top = length_or(own, "radiusTop", T(0.25));
    if (name == "capsule") return {Capsule<T>(height, bottom, top), margin};
    return {Cylinder<T>(height, bottom, top), margin};
  }
  if (name == "plane") return read_plane<T>(own, margin);

  const JsonValue object = json.at(*known);
  if (name == "ellipsoid") {
    object.keys({"radii"});
    return {Ellipsoid<T>(object.at("radii").template lengths<T>()), margin};
  }
  if (name == "convex") {
    object.keys({"points"});
    const std::vector<Vec3<T>> points = read_points<T>(object.at("points"));
    return built(object, [&] { return Shape<T>(ConvexHull<T>(points), margin); });
  }
  if (name == "triangle") return read_triangle<T>(object, margin);
  if (name == "mesh") return read_mesh<T>(object);
  if (name == "heightfield") return read_height_field<T>(object);
  return read_compound<T>(object);
}

template Shape<float> read_shape(const JsonValue&);
template Shape<double> read_shape(const JsonValue&);

}  // namespace graze::io
