// The reading of the query `response`.
#include "dynamics/inertia_check.hpp"
#include "graze/plane/mass.hpp"
#include "io/plane_question.hpp"
#include "io/question.hpp"
#include "io/response.hpp"

namespace graze::io {

namespace {

/// The error of a unit normal's length when it is written with four digits.
constexpr double longest_off_unit = 1e-3;

template <class T>
Vec3<T> read_vector(const JsonValue& json, int dimension) {
  return dimension == 2 ? json.plane_vector<T>() : json.vector<T>();
}

/// A number > 0 whose inverse is one too, or the text "infinity".
template <class T>
T read_resistance(const JsonValue& json) {
  if (json.json() == "infinity") return std::numeric_limits<T>::infinity();
  const T value = json.json().is_number() ? static_cast<T>(json.json().template get<double>()) : T(0);
  if (!(value > T(0) && std::isfinite(value) && std::isfinite(T(1) / value)))
    json.fail("a finite number > 0, or \"infinity\"");
  return value;
}

template <class T>
Vec3<T> read_inertia(const JsonValue& json, int dimension) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (dimension == 2) return {infinity, infinity, read_resistance<T>(json)};
  const auto parts = json.elements(3);
  const Vec3<T> inertia{read_resistance<T>(parts[0]), read_resistance<T>(parts[1]), read_resistance<T>(parts[2])};
  check_triangle_inequality(inertia, json.path());
  return inertia;
}

/// The inertia of a figure of the plane that has `mass` spread evenly; zero where it has no area.
template <class T>
T plane_inertia(const JsonValue& json, T mass) {
  const plane::MassProperties<T> of = plane::mass_properties(read_plane_shape<T>(json));
  return of.area > T(0) ? mass * (of.inertia / of.area) : T(0);
}

[[noreturn]] void fail_for_lack_of_volume(const JsonValue& body) {
  throw InvalidValue(body.path() + ".inertia", "a value, since the shape has no volume to take it from", "nothing");
}

template <class T>
InverseMass<T> read_mass_of_shape(const JsonValue& body, T mass, const Quat<T>& rotation, int dimension) {
  const JsonValue json = body.at("shape");
  if (dimension == 2) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const T inertia = plane_inertia(json, mass);
    if (!(inertia > T(0))) fail_for_lack_of_volume(body);
    return inverse_mass(mass, Vec3<T>{infinity, infinity, inertia}, rotation);
  }
  const Shape<T> shape = read_shape<T>(json);
  if (!(mass_properties(shape).volume > T(0))) fail_for_lack_of_volume(body);
  return inverse_mass(mass, inertia_of(shape, mass), rotation);
}

/// The body's own `mass` and `inertia`. Values that are not needed are read all the same, so that their faults are
/// named.
template <class T>
InverseMass<T> read_mass(const JsonValue& json, const Quat<T>& rotation, int dimension) {
  const T mass = read_resistance<T>(json.at("mass"));
  std::optional<Vec3<T>> inertia;
  if (const auto i = json.find("inertia")) inertia = read_inertia<T>(*i, dimension);
  const bool movable = std::isfinite(mass);
  if (movable && !inertia) return read_mass_of_shape(json, mass, rotation, dimension);
  if (const auto shape = json.find("shape")) {
    if (dimension == 2)
      read_plane_shape<T>(*shape);
    else
      read_shape<T>(*shape);
  }
  return movable ? inverse_mass(mass, *inertia, rotation) : InverseMass<T>{};
}

template <class T>
StruckBody<T> read_struck_body(const JsonValue& json, int dimension) {
  json.keys({"shape", "mass", "inertia", "translation", "rotation", "linear", "angular"});
  StruckBody<T> body;
  Quat<T> rotation;
  if (const auto v = json.find("translation")) body.motion.center = read_vector<T>(*v, dimension);
  if (const auto v = json.find("rotation")) {
    // In the plane a turn leaves the inertia about its normal as it is.
    dimension == 2 ? static_cast<void>(v->template number<T>()) : static_cast<void>(rotation = read_rotation<T>(*v));
  }
  if (const auto v = json.find("linear")) body.motion.linear = read_vector<T>(*v, dimension);
  if (const auto v = json.find("angular"))
    body.motion.angular = dimension == 2 ? Vec3<T>{T(0), T(0), v->template number<T>()} : v->template vector<T>();
  body.mass = read_mass(json, rotation, dimension);
  return body;
}

template <class T>
StruckContact<T> read_contact(const JsonValue& json, int dimension) {
  json.keys({"point", "normal"});
  StruckContact<T> contact;
  contact.point = read_vector<T>(json.at("point"), dimension);
  const JsonValue normal = json.at("normal");
  contact.normal = read_vector<T>(normal, dimension);
  if (!(std::abs(static_cast<double>(length(contact.normal)) - 1) <= longest_off_unit)) normal.fail("a unit vector");
  contact.normal = normalized(contact.normal);
  return contact;
}

}  // namespace

bool asks_for_response(const JsonValue& json) {
  const auto query = json.find("query");
  return query && query->json() == "response";
}

template <class T>
ResponseQuestion<T> read_response(const JsonValue& json) {
  json.keys({"id", "query", "a", "b", "contact", "restitution", "friction", "dimension", "explain"});
  ResponseQuestion<T> q;
  if (const auto d = json.find("dimension")) {
    if (d->json() != 2 && d->json() != 3) d->fail("2 or 3");
    q.dimension = d->json() == 2 ? 2 : 3;
  }
  q.a = read_struck_body<T>(json.at("a"), q.dimension);
  q.b = read_struck_body<T>(json.at("b"), q.dimension);
  q.contact = read_contact<T>(json.at("contact"), q.dimension);
  if (const auto r = json.find("restitution")) q.contact.restitution = r->positive_or_zero<T>();
  if (const auto f = json.find("friction")) q.contact.friction = f->positive_or_zero<T>();
  if (const auto e = json.find("explain")) q.explain = e->boolean();
  return q;
}

std::optional<Placed<double>> read_struck_shape(const JsonValue& body) {
  const auto json = body.find("shape");
  if (!json) return std::nullopt;
  Placed<double> placed{read_shape<double>(*json), {}};
  if (const auto v = body.find("rotation")) placed.pose.rotation = read_rotation<double>(*v);
  if (const auto v = body.find("translation")) placed.pose.translation = v->vector<double>();
  if (const auto of = mass_properties(placed.shape); of.volume > 0)
    placed.pose.translation -= rotate(placed.pose.rotation, of.center);
  return placed;
}

std::optional<plane::Placed<double>> read_struck_plane_shape(const JsonValue& body) {
  const auto json = body.find("shape");
  if (!json) return std::nullopt;
  plane::Placed<double> placed{read_plane_shape<double>(*json), {}};
  if (const auto v = body.find("rotation")) placed.pose.rotation = plane::Rot2d::from_angle(v->number<double>());
  if (const auto v = body.find("translation")) {
    const Vec3d at = v->plane_vector<double>();
    placed.pose.translation = {at.x, at.y};
  }
  if (const auto of = plane::mass_properties(placed.shape); of.area > 0)
    placed.pose.translation -= rotate(placed.pose.rotation, of.center);
  return placed;
}

template ResponseQuestion<float> read_response(const JsonValue&);
template ResponseQuestion<double> read_response(const JsonValue&);

}  // namespace graze::io
