#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/io/explain.hpp"
#include "io/explain_parts.hpp"
#include "io/explained_bodies.hpp"
#include "io/labels.hpp"

namespace graze::io {

namespace {

constexpr std::size_t most_points = 10;
constexpr double id_row = 15;

/// The part of a ray that is drawn: from its origin, or where it comes near the shape if that is far away, to its
/// hit or beyond the shape.
struct DrawnRay {
  Vec3d from, to, beyond;

  DrawnRay(const ExplainedRay& asked, const Aabbd& box) {
    const Vec3d way = normalized(asked.ray.direction);
    const double size = std::max(max_abs(box.extent()), least_size), most = std::min(asked.length, 1e200);
    const double middle = dot(box.center() - asked.ray.origin, way);
    const double begin = std::clamp(middle - 1.6 * size, 0.0, most);
    const double end = std::clamp(middle + 0.8 * size, begin, std::max(begin, most));
    from = asked.ray.origin + way * begin;
    to = asked.hit ? asked.hit->point : asked.ray.origin + way * end;
    beyond = asked.ray.origin + way * std::max(end, begin);
  }
};

std::string draw_ray(const ExplainedRay& asked, const DrawnRay& ray, const View& view) {
  std::string out = line(view, ray.from, ray.to, "arrow", 1.8);
  if (!asked.hit) return out + "<g class=\"arrow\">" + arrow(view, ray.to, normalized(asked.ray.direction)) + "</g>\n";
  return out + line(view, ray.to, ray.beyond, "rule", 1.2, " stroke-dasharray=\"4 4\"") + "<g class=\"arrow\">" +
         arrow(view, asked.hit->point, asked.hit->normal) + "</g>\n" + dot_at(view, asked.hit->point, "red");
}

/// The time up to which a moving pair is drawn: its hit, or the end.
double last_time(const ExplainedCast& cast) { return cast.hit ? cast.hit->t : cast.duration; }

std::string draw_ways(const Explanation& e, const Drawn& drawn, const View& view) {
  std::string out;
  const double t = last_time(*e.cast);
  for (const auto& [b, velocity] : {std::pair{false, &e.cast->a}, std::pair{true, &e.cast->b}})
    if (const Vec3d from = drawn.origin(b); velocity->linear != Vec3d{})
      out += line(view, from, from + velocity->linear * t, "arrow", 1.2, " stroke-dasharray=\"5 4\"");
  if (!e.cast->hit) return out;
  return out + "<g class=\"arrow\">" + arrow(view, e.cast->hit->point, e.cast->hit->normal) + "</g>\n" +
         dot_at(view, e.cast->hit->point, "red");
}

/// Points of contact with their numbers, none upon another, an arrow a manifold, and the distance.
std::string draw_points(const Explanation& e, const View& view) {
  SvgDraw canvas(view, {}, std::numeric_limits<double>::infinity());
  std::string numbers;
  Labels labels;
  for (const Manifold<double>& m : e.manifolds)
    for (const auto& p : m.points) labels.keep_clear(view.x(p.position()), view.y(p.position()), 4);
  int number = 0;
  for (const Manifold<double>& m : e.manifolds) {
    draw(canvas, m);
    for (const auto& p : m.points)
      numbers += labels.at(view.x(p.position()), view.y(p.position()), std::to_string(++number));
  }
  if (e.distance) draw(canvas, *e.distance);
  return canvas.over() + numbers;
}

/// Lists the ids of the points by their numbers in the picture, from the bottom up. Returns where the list begins.
double draw_ids(const Explanation& e, std::string& out) {
  std::vector<const ContactPoint<double>*> points;
  for (const Manifold<double>& m : e.manifolds)
    for (const auto& p : m.points) points.push_back(&p);
  if (points.empty()) return picture_height - page_margin;
  const std::size_t count = std::min(points.size(), most_points);
  double y = picture_height - page_margin - id_row * static_cast<double>(count);
  const double top = y - 8;
  for (std::size_t i = 0; i < count; ++i, y += id_row)
    out += text(list_x, y + 12, 11, fmt::format("{:>2}  {}", i + 1, feature_text(points[i]->feature, e))) +
           text(number_x, y + 12, 11, fmt::format("{:.4g}", points[i]->distance), "ink", "end");
  if (count < points.size())
    out += text(list_x, y + 12, 11, fmt::format("and {} more points", points.size() - count), "soft");
  return top;
}

/// The place of the overlap or gap.
std::optional<Vec3d> place_of_contact(const Explanation& e) {
  if (e.distance) return (e.distance->a + e.distance->b) * 0.5;
  if (!e.manifolds.empty()) return e.manifolds[0].points[0].position();
  if (e.cast && e.cast->hit) return e.cast->hit->point;
  return std::nullopt;
}

/// The side or corner of a shape with straight sides that a point on it lies on, drawn bold.
std::string draw_touched(const View& view, const Polygons& shape, const Vec3d& point, const Color& color) {
  double least = std::numeric_limits<double>::infinity();
  Vec3d from, to, corner;
  bool at_corner = false;
  for (const auto& loop : shape.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3d p = shape.points[loop[i]], q = shape.points[loop[(i + 1) % loop.size()]], e = q - p;
      const double l2 = dot(e, e), t = l2 > 0 ? std::clamp(dot(point - p, e) / l2, 0.0, 1.0) : 0;
      const double away = length(p + e * t - point);
      if (!(away < least)) continue;
      constexpr double end = 1e-6;  // of an edge: a point that was computed as its end
      least = away, from = p, to = q, at_corner = t < end || t > 1 - end, corner = t < 0.5 ? p : q;
    }
  const std::string look = hex(color, 0.72);
  if (!at_corner) return line(view, from, to, look, 3.5);
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"none\" stroke=\"{}\" "
                     "stroke-width=\"2.5\"/>\n",
                     view.x(corner), view.y(corner), look);
}

/// The vertices and edges that give the points, in the plane.
std::string draw_features(const Explanation& e, const Drawn& drawn, const View& view, const Polygons& a,
                          const Polygons& b) {
  std::string sides, corners;
  const auto add = [&](bool of_b, const Vec3d& point) {
    if (!drawn.has(of_b) || !drawn.straight(of_b)) return;
    const std::string more = draw_touched(view, of_b ? b : a, point, of_b ? color_b : color_a);
    (more.starts_with("<circle") ? corners : sides) += more;
  };
  for (const Manifold<double>& m : e.manifolds)
    for (const auto& p : m.points) add(false, p.a), add(true, p.b);
  if (e.distance && e.query == "distance") add(false, e.distance->a), add(true, e.distance->b);
  return sides + corners;
}

}  // namespace

std::string headline(const Explanation& e) {
  std::string method = e.trace.method;
  if (!e.trace.reason.empty()) method += ": " + e.trace.reason;
  constexpr std::size_t longest = 150;
  if (method.size() > longest) method = method.substr(0, longest) + "...";
  return text(page_margin, 34, 17, e.query + ": " + outcome_text(e)) + text(page_margin, 54, 12, method, "soft");
}

std::string draw_explanation(const Explanation& e, const Vec3d& toward_viewer) {
  if (e.response) return draw_response(e, toward_viewer);
  const Drawn drawn(e);
  const bool flat = e.dimension == 2, second = drawn.has(true);
  const TraceAxis* axis = e.ray ? nullptr : named(e.trace.axes, e.trace.winner);
  Vec3d toward = flat ? Vec3d{0, 0, 1} : toward_viewer;
  if (axis && !flat) toward = across(toward_viewer, axis->direction);
  if (e.ray && !flat) toward = across(toward_viewer, normalized(e.ray->ray.direction));

  // Shapes that move stand where they meet, and pale where they begin.
  const double then = e.cast ? last_time(*e.cast) : 0;
  Stage stage;
  for (const double t : {0.0, then}) {
    stage.add(drawn.box(false, t));
    if (second) stage.add(drawn.box(true, t));
  }
  std::optional<DrawnRay> ray;
  if (e.ray) {
    ray.emplace(*e.ray, stage.box());
    for (const Vec3d& p : {ray->from, ray->to, ray->beyond}) stage.add(p);
  }
  const double size = stage.size();
  const auto polygons = [&](bool b, double t) { return drawn.polygons(b, t, stage.box().center(), 0.7 * size); };
  const Polygons a = polygons(false, then), b = second ? polygons(true, then) : Polygons{};
  std::vector<Vec3d> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  if (ray) points.insert(points.end(), {ray->from, ray->to, ray->beyond});

  std::vector<std::pair<Polygons, DrawMeaning>> ghosts;
  if (e.cast)
    for (const auto& [of_b, velocity] : {std::pair{false, &e.cast->a}, std::pair{true, &e.cast->b}})
      if (velocity->linear != Vec3d{} || velocity->angular != Vec3d{})
        ghosts.emplace_back(polygons(of_b, 0), of_b ? DrawMeaning::b : DrawMeaning::a);
  for (const auto& [ghost, meaning] : ghosts) points.insert(points.end(), ghost.points.begin(), ghost.points.end());

  std::optional<AxisDrawing> beside;
  if (axis) {
    beside.emplace(*axis, normalized(toward), a.points, b.points);
    for (const Vec3d& p : beside->corners()) points.push_back(p);
  }
  const std::optional<Vec3d> place = place_of_contact(e);
  View view(toward, points, shapes_panel);
  const bool inset = axis && place && needs_inset(view, *axis);
  if (inset) {
    Panel below = shapes_panel;
    below.y += inset_height, below.height -= inset_height;
    view = View(toward, points, below);
  }
  SvgDraw canvas(view, {}, 0.45 * size);
  for (const auto& [ghost, meaning] : ghosts) canvas.polygons(ghost, DrawLayer::casts, meaning);
  canvas.polygons(a, DrawLayer::shapes, DrawMeaning::a);
  if (second) canvas.polygons(b, DrawLayer::shapes, DrawMeaning::b);
  std::string out = svg_head(picture_height + difference_height(e.trace)) + canvas.faces() +
                    "<g font-family=\"system-ui, sans-serif\" fill=\"none\">\n";
  if (beside)
    out += beside->draw(view) +
           text(page_margin, picture_height - 14, 13, beside->caption(), axis->overlap() >= 0 ? "red" : "ink");
  const double bottom = draw_ids(e, out);
  if (ray) out += draw_ray(*e.ray, *ray, view);
  if (e.cast) out += draw_ways(e, drawn, view);
  if (flat) out += draw_features(e, drawn, view, a, b);
  out += draw_points(e, view) + draw_letters(view, a, b);
  if (inset) out += draw_inset(view, *axis, *place);
  const std::string projections = flat ? draw_projections(e, a, b, bottom) : "";
  if (!e.trace.steps.empty())
    out += draw_steps(e, bottom);
  else if (!projections.empty())
    out += projections;
  else
    out += e.ray ? draw_spans(e) : draw_axes(e, bottom);
  return out + headline(e) + draw_difference(e, picture_height) + "</g>\n</svg>\n";
}

}  // namespace graze::io
