#include "graze/io/explain.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/answer.hpp"
#include "io/convert.hpp"

namespace graze::io {

namespace {

template <class T>
Distance<double> widened(const Distance<T>& d) {
  return {static_cast<double>(d.distance), cast<double>(d.normal), cast<double>(d.a), cast<double>(d.b), d.status,
          static_cast<double>(d.error)};
}

template <class T>
Manifolds<double> widened(const Manifolds<T>& manifolds) {
  Manifolds<double> wide;
  for (const Manifold<T>& m : manifolds) {
    Manifold<double>& to = wide.emplace_back();
    to.normal = cast<double>(m.normal);
    to.piece_a = m.piece_a;
    to.piece_b = m.piece_b;
    for (const ContactPoint<T>& p : m.points)
      to.points.push_back({cast<double>(p.a), cast<double>(p.b), static_cast<double>(p.distance), p.feature,
                           static_cast<double>(p.weight)});
  }
  return wide;
}

/// Fills in what the question is answered by.
template <class T>
void ask(const Question<T>& q, Explanation& e) {
  if (q.query == QueryKind::closest) {
    e.query = "closest";
    const Closest<T> c = closest(q.a->shape, q.a->pose, *q.point, &e.trace);
    e.distance = Distance<double>{static_cast<double>(c.distance), cast<double>(c.normal), cast<double>(c.point),
                                  cast<double>(*q.point), c.status};
    e.overlap = c.distance <= T(0);
    return;
  }
  const auto &a = *q.a, &b = *q.b;
  switch (q.query) {
  case QueryKind::overlap:
    e.query = "overlap";
    e.overlap = overlap(a.shape, a.pose, b.shape, b.pose, &e.trace);
    break;
  case QueryKind::distance:
    e.query = "distance";
    e.distance = widened(distance(a.shape, a.pose, b.shape, b.pose, &e.trace));
    e.overlap = e.distance->distance <= 0;
    break;
  default: {
    e.query = "contacts";
    Manifolds<T> manifolds;
    e.overlap = contacts(a.shape, a.pose, b.shape, b.pose, q.margin, manifolds, &e.trace);
    e.manifolds = widened(manifolds);
  }
  }
}

std::string vector_text(const Vec3d& v) { return fmt::format("{:9.5g} {:9.5g} {:9.5g}", v.x, v.y, v.z); }

std::string axes_text(const Explanation& e) {
  if (e.trace.axes.empty()) return "";
  std::size_t width = 6;
  for (const TraceAxis& axis : e.trace.axes) width = std::max(width, axis.name.size());
  std::string out = fmt::format("\n  {:<{}}  {:^29}  {:^21}  {:^21}  {:>10}\n", "axis", width, "direction, from A to B",
                                "A covers", "B covers", "overlap");
  for (const TraceAxis& axis : e.trace.axes)
    out += fmt::format("{} {:<{}}  {}  {:>10.5g} {:>10.5g}  {:>10.5g} {:>10.5g}  {:>10.5g}\n",
                       axis.name == e.trace.winner ? '>' : ' ', axis.name, width, vector_text(axis.direction),
                       axis.a_lower, axis.a_upper, axis.b_lower, axis.b_upper, axis.overlap());
  return out;
}

std::string steps_text(const Trace& trace) {
  std::string out;
  if (!trace.gjk.empty()) {
    out += fmt::format("\n  {:>3}  {:>7}  {:^29}  {:>12} {:>12}\n", "GJK", "simplex", "direction, from A to B",
                       "at least", "at most");
    int step = 0;
    for (const TraceGjk& s : trace.gjk)
      out += fmt::format("  {:>3}  {:>7}  {}  {:>12.6g} {:>12.6g}\n", ++step, s.simplex.size(),
                         vector_text(s.direction), s.lower, s.upper);
  }
  if (!trace.epa.empty()) {
    out += fmt::format("\n  {:>3}  {:>7}  {:^29}  {:>12} {:>12}\n", "EPA", "facets", "normal, from A to B",
                       "depth >=", "depth <=");
    int step = 0;
    for (const TraceEpa& s : trace.epa)
      out += fmt::format("  {:>3}  {:>7}  {}  {:>12.6g} {:>12.6g}\n", ++step, s.faces, vector_text(s.normal),
                         s.face_depth, s.found_depth);
  }
  return out;
}

std::string contacts_text(const Explanation& e) {
  std::string out;
  for (const Manifold<double>& m : e.manifolds) {
    out += fmt::format("  normal    {}\n\n  {:^29}  {:^29}  {:>10}  {:<8}\n", vector_text(m.normal), "on A", "on B",
                       "distance", "id");
    for (const ContactPoint<double>& p : m.points)
      out += fmt::format("  {}  {}  {:>10.5g}  {:08x}  {}\n", vector_text(p.a), vector_text(p.b), p.distance, p.feature,
                         feature_text(p.feature));
  }
  return out;
}

}  // namespace

Explanation explain(std::string_view question, Precision precision) {
  const Json json = parse_json(question);
  if (!json.is_object()) throw InvalidValue("", "one JSON object", shown(json));
  // Read in double for the picture in any case, and so checked in double too.
  const Question<double> q = read_question<double>(JsonValue(json, ""));
  if (q.query == QueryKind::raycast || q.query == QueryKind::cast)
    throw InvalidValue("query", "one of overlap, distance, contacts, closest", json["query"].dump());
  Explanation e;
  e.dimension = q.dimension;
  e.a = Placed<double>{q.a->shape, q.a->pose};
  e.b = q.b ? Placed<double>{q.b->shape, q.b->pose} : Placed<double>{Sphere<double>(0), {*q.point, {}}};
  if (precision == Precision::double_precision)
    ask(q, e);
  else
    ask(read_question<float>(JsonValue(json, "")), e);
  if (e.dimension == 2) {
    leave_plane_axes(e.trace);
    for (Manifold<double>& m : e.manifolds) leave_plane_points(m);
    if (e.distance) e.distance->a.z = e.distance->b.z = 0;
  }
  return e;
}

std::string feature_text(std::uint32_t feature) {
  static constexpr const char* kinds[] = {"part", "vertex", "edge", "face"};
  const auto half = [](std::uint32_t f) { return fmt::format("{} {}", kinds[(f >> 14) & 3], f & 0x3fff); };
  return "A " + half(feature >> 16) + ", B " + half(feature & 0xffff);
}

std::string explanation_text(const Explanation& e) {
  std::string out = fmt::format("{}: the shapes {}\n", e.query, e.overlap ? "overlap" : "are apart");
  if (e.distance) {
    out += fmt::format("  {}  {:.9g}\n  normal    {}\n", e.distance->distance <= 0 ? "depth   " : "distance",
                       std::abs(e.distance->distance), vector_text(e.distance->normal));
    out += fmt::format("  on A      {}\n  on B      {}\n", vector_text(e.distance->a), vector_text(e.distance->b));
  }
  out += contacts_text(e);
  out += fmt::format("\n  method    {}\n", e.trace.method);
  if (!e.trace.reason.empty()) out += fmt::format("  because   {}\n", e.trace.reason);
  return out + axes_text(e) + steps_text(e.trace);
}

}  // namespace graze::io
