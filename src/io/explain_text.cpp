#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/response.hpp"

namespace graze::io {

namespace {

std::string counted(std::size_t count, const char* one, const char* more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

/// Vectors as columns of a table, of two numbers in the plane and of three in space.
class Columns {
 public:
  explicit Columns(const Explanation& e) : flat_(e.dimension == 2) {}

  std::string operator()(const Vec3d& v) const {
    if (flat_) return fmt::format("{:10.5g} {:11.5g}", v.x + 0.0, v.y + 0.0);
    return fmt::format("{:9.5g} {:9.5g} {:9.5g}", v.x + 0.0, v.y + 0.0, v.z + 0.0);
  }
  /// A heading as wide as the columns.
  std::string head(const char* words) const { return fmt::format("{:^{}}", words, flat_ ? 22 : 29); }

 private:
  bool flat_;
};

std::string axes_text(const Explanation& e, const Columns& columns) {
  if (e.trace.axes.empty()) return "";
  std::size_t width = 6;
  for (const TraceAxis& axis : e.trace.axes) width = std::max(width, axis.name.size());
  std::string out = fmt::format("\n  {:<{}}  {}  {:^21}  {:^21}  {:>10}\n", "axis", width,
                                columns.head("direction, from A to B"), "A covers", "B covers", "overlap");
  for (const TraceAxis& axis : e.trace.axes)
    out += fmt::format("{} {:<{}}  {}  {:>10.5g} {:>10.5g}  {:>10.5g} {:>10.5g}  {:>10.5g}\n",
                       axis.name == e.trace.winner ? '>' : ' ', axis.name, width, columns(axis.direction), axis.a_lower,
                       axis.a_upper, axis.b_lower, axis.b_upper, axis.overlap());
  return out;
}

std::string steps_text(const Trace& trace, const Columns& columns) {
  std::string out;
  if (!trace.gjk.empty()) {
    out += fmt::format("\n  {:>3}  {:>7}  {}  {:>12} {:>12}\n", "GJK", "simplex",
                       columns.head("direction, from A to B"), "at least", "at most");
    int step = 0;
    for (const TraceGjk& s : trace.gjk)
      out += fmt::format("  {:>3}  {:>7}  {}  {:>12.6g} {:>12.6g}\n", ++step, s.simplex.size(), columns(s.direction),
                         s.lower, s.upper);
  }
  if (!trace.epa.empty()) {
    out += fmt::format("\n  {:>3}  {:>7}  {}  {:>12} {:>12}\n", "EPA", "facets", columns.head("normal, from A to B"),
                       "depth >=", "depth <=");
    int step = 0;
    for (const TraceEpa& s : trace.epa)
      out += fmt::format("  {:>3}  {:>7}  {}  {:>12.6g} {:>12.6g}\n", ++step, s.faces, columns(s.normal), s.face_depth,
                         s.found_depth);
  }
  return out;
}

std::string cuts_text(const Trace& trace, const Columns& columns) {
  if (trace.cuts.empty()) return "";
  std::string out = fmt::format("\n  {:>3}  {}  {}  {:>7}\n", "cut", columns.head("along the side from"),
                                columns.head("to"), "corners");
  int number = 0;
  for (const TraceCut& cut : trace.cuts)
    out += fmt::format("  {:>3}  {}  {}  {:>7}\n", ++number, columns(cut.from), columns(cut.to), cut.left.size());
  return out;
}

/// A number of a table, or the words for one that is none.
std::string end_text(double t) { return std::isfinite(t) ? fmt::format("{:.6g}", t) : t < 0 ? "always" : "never"; }

std::string ray_text(const Trace& trace, const Columns& columns) {
  std::string out;
  if (trace.nodes + trace.pieces > 0)
    out += fmt::format("  visited   {} of the tree and {} of the composite\n", counted(trace.nodes, "node", "nodes"),
                       counted(trace.pieces, "piece", "pieces"));
  if (!trace.spans.empty()) {
    std::size_t width = 6;
    for (const TraceSpan& span : trace.spans) width = std::max(width, span.name.size());
    out += fmt::format("\n  {:<{}}  {}  {:>12} {:>12}\n", "span", width, columns.head("normal"), "enters", "leaves");
    for (const TraceSpan& span : trace.spans) {
      const bool met = span.enter <= span.leave;
      out += fmt::format("{} {:<{}}  {}  {:>12} {:>12}\n", span.name == trace.winner ? '>' : ' ', span.name, width,
                         span.normal == Vec3d{} ? columns.head("") : columns(span.normal),
                         met ? end_text(span.enter) : "never", met ? end_text(span.leave) : "");
    }
  }
  if (!trace.steps.empty()) {
    out += fmt::format("\n  {:>4}  {:>14}  {:>12}  {}\n", "step", "t", "distance", columns.head("normal, from A"));
    int number = 0;
    for (const TraceStep& step : trace.steps)
      out += fmt::format("  {:>4}  {:>14.9g}  {:>12.5g}  {}\n", ++number, step.t, step.distance, columns(step.normal));
  }
  return out;
}

/// Half of a contact's number: two bits for the kind, fourteen for which.
struct Feature {
  enum Kind { part, vertex, edge, face } kind;
  std::uint32_t number;

  explicit Feature(std::uint32_t half) : kind(static_cast<Kind>((half >> 14) & 3)), number(half & 0x3fff) {}
};

std::string plain_feature(std::uint32_t half) {
  static constexpr const char* kinds[] = {"part", "vertex", "edge", "face"};
  const Feature feature(half);
  return fmt::format("{} {}", kinds[feature.kind], feature.number);
}

/// The number of vertices that an edge's number can name: it is 127 times that of its first vertex, and that of its
/// second.
constexpr std::uint32_t numbered_vertices = 127;

std::string feature_of(const Shaped& shape, std::uint32_t half) {
  const Feature feature(half);
  if (shape.as<Sphere<double>>() || shape.as<Ellipsoid<double>>() || shape.as<UserConvex<double>>()) return "surface";
  if (shape.as<HalfSpace<double>>()) return "plane";
  if (shape.as<Capsule<double>>())
    return feature.kind == Feature::vertex ? fmt::format("end {}", feature.number) : "side";
  const auto* hull = shape.as<ConvexHull<double>>();
  const bool by_vertices = !hull || hull->data().vertices.size() <= numbered_vertices;
  if (feature.kind != Feature::edge || !by_vertices || !shape.convex()) return plain_feature(half);
  return fmt::format("edge {}-{}", feature.number / numbered_vertices, feature.number % numbered_vertices);
}

std::string feature_of(const plane::Shaped& shape, std::uint32_t half) {
  const Feature feature(half);
  if (shape.as<plane::Circle<double>>() || shape.as<plane::Ellipse<double>>() || shape.as<plane::UserConvex<double>>())
    return "rim";
  if (shape.as<plane::HalfPlane<double>>()) return "line";
  const bool vertex = feature.kind == Feature::vertex;
  if (shape.as<plane::Capsule<double>>() || shape.as<plane::Segment<double>>())
    return vertex ? fmt::format("end {}", feature.number) : "side";
  return plain_feature(half);
}

std::string contacts_text(const Explanation& e, const Columns& columns) {
  std::string out;
  for (const Manifold<double>& m : e.manifolds) {
    out += fmt::format("  normal    {}\n\n  {}  {}  {:>10}  {:<8}\n", columns(m.normal), columns.head("on A"),
                       columns.head("on B"), "distance", "id");
    for (const ContactPoint<double>& p : m.points)
      out += fmt::format("  {}  {}  {:>10.5g}  {:08x}  {}\n", columns(p.a), columns(p.b), p.distance, p.feature,
                         feature_text(p.feature, e));
  }
  return out;
}

}  // namespace

std::string feature_text(std::uint32_t feature) {
  return plain_feature(feature >> 16) + " of A, " + plain_feature(feature & 0xffff) + " of B";
}

std::string feature_text(std::uint32_t feature, const Explanation& e) {
  if (e.plane_a && e.plane_b)
    return feature_of(e.plane_a->shape, feature >> 16) + " of A, " + feature_of(e.plane_b->shape, feature & 0xffff) +
           " of B";
  if (!e.a || !e.b) return feature_text(feature);
  return feature_of(e.a->shape, feature >> 16) + " of A, " + feature_of(e.b->shape, feature & 0xffff) + " of B";
}

std::string outcome_text(const Explanation& e) {
  if (e.response) return response_outcome(e.response->result);
  if (e.ray) return e.ray->hit ? fmt::format("the ray hits at {:.6g}", e.ray->hit->t) : "the ray hits nothing";
  if (e.cast)
    return e.cast->hit ? fmt::format("the bodies touch at {:.6g}", e.cast->hit->t)
                       : fmt::format("the bodies do not touch in {:.6g}", e.cast->duration);
  std::string words = e.overlap ? "the shapes overlap" : "the shapes are apart";
  if (e.distance) words += fmt::format(", {} {:.4g}", e.overlap ? "depth" : "distance", std::abs(e.distance->distance));
  std::size_t points = 0;
  for (const Manifold<double>& m : e.manifolds) points += m.points.size();
  if (points > 0) words += ", " + counted(points, "point", "points");
  return words;
}

std::string explanation_text(const Explanation& e) {
  std::string out = e.query + ": " + outcome_text(e) + "\n";
  if (e.response) return out + response_text(e);
  const Columns columns(e);
  const auto line = [&](const char* name, const Vec3d& v) { out += fmt::format("  {:<9} {}\n", name, columns(v)); };
  if (e.distance) {
    out += fmt::format("  {}  {:.9g}\n", e.distance->distance <= 0 ? "depth   " : "distance",
                       std::abs(e.distance->distance));
    line("normal", e.distance->normal);
    line("on A", e.distance->a);
    line("on B", e.distance->b);
  }
  if (e.ray && e.ray->hit) line("point", e.ray->hit->point), line("normal", e.ray->hit->normal);
  if (e.cast && e.cast->hit) line("point", e.cast->hit->point), line("normal", e.cast->hit->normal);
  out += contacts_text(e, columns);
  out += fmt::format("\n  method    {}\n", e.trace.method);
  if (!e.trace.reason.empty()) out += fmt::format("  because   {}\n", e.trace.reason);
  return out + ray_text(e.trace, columns) + axes_text(e, columns) + cuts_text(e.trace, columns) +
         steps_text(e.trace, columns);
}

}  // namespace graze::io
