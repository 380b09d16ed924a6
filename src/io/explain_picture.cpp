#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/io/explain.hpp"
#include "io/explain_parts.hpp"
#include "io/labels.hpp"

namespace graze::io {

namespace {

constexpr std::size_t most_points = 10;
constexpr double id_row = 15;

/// An axis in true length: the viewer looks across it, from about where was asked.
Vec3d across(const Vec3d& toward, const Vec3d& axis) {
  const Vec3d seen = toward - axis * dot(toward, axis);
  return length(seen) > 0.05 * length(toward) ? seen : any_perpendicular(axis);
}

/// Bounds of the shapes that have any, and of the points that have to be seen besides; a box of 2 when nothing has.
class Stage {
 public:
  void add(const Shaped& shape, const Posed& pose) {
    if (const Aabbd of = bounds(shape, pose); max_abs(of.extent()) < 1e300) box_ = merged(box_, of);
  }
  void add(const Vec3d& p) { box_ = merged(box_, p); }
  Aabbd box() const { return box_.lower.x <= box_.upper.x ? box_ : Aabbd{{-1, -1, -1}, {1, 1, 1}}; }
  double size() const { return std::max(max_abs(box().extent()), least_size); }

 private:
  Aabbd box_ = Aabbd::empty();
};

/// What of a ray is drawn: from its origin, or where it comes near the shape if that is far away, to its hit or beyond
/// the shape.
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

/// How far a moving pair is drawn: to its hit, or to the end.
double last_time(const ExplainedCast& cast) { return cast.hit ? cast.hit->t : cast.duration; }

std::string draw_ways(const Explanation& e, const View& view) {
  std::string out;
  const double t = last_time(*e.cast);
  for (const auto& [body, velocity] : {std::pair{&*e.a, &e.cast->a}, std::pair{&*e.b, &e.cast->b}})
    if (velocity->linear != Vec3d{})
      out += line(view, body->pose.translation, body->pose.translation + velocity->linear * t, "arrow", 1.2,
                  " stroke-dasharray=\"5 4\"");
  if (!e.cast->hit) return out;
  return out + "<g class=\"arrow\">" + arrow(view, e.cast->hit->point, e.cast->hit->normal) + "</g>\n" +
         dot_at(view, e.cast->hit->point, "red");
}

/// Points of contact with their numbers, none upon another, and an arrow a manifold.
std::string draw_points(const Explanation& e, const View& view) {
  std::string arrows, dots, numbers;
  Labels labels;
  for (const Manifold<double>& m : e.manifolds)
    for (const auto& p : m.points) labels.keep_clear(view.x(p.position()), view.y(p.position()), 4);
  int number = 0;
  for (const Manifold<double>& m : e.manifolds) {
    Vec3d middle;
    for (const auto& p : m.points) middle += p.position() / static_cast<double>(m.points.size());
    arrows += arrow(view, middle, m.normal);
    for (const auto& p : m.points) {
      dots += dot_at(view, p.position(), "red");
      numbers += labels.at(view.x(p.position()), view.y(p.position()), std::to_string(++number));
    }
  }
  std::string out = "<g class=\"arrow\">" + arrows + "</g>\n" + dots + numbers;
  if (e.distance)
    out += line(view, e.distance->a, e.distance->b, "shared", 2) + dot_at(view, e.distance->a, hex(color_a)) +
           dot_at(view, e.distance->b, hex(color_b));
  return out;
}

/// The ids of the points by their numbers in the picture, from the bottom up. Returns where the list begins.
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

std::string headline(const Explanation& e) {
  std::string method = e.trace.method;
  if (!e.trace.reason.empty()) method += ": " + e.trace.reason;
  constexpr std::size_t longest = 150;
  if (method.size() > longest) method = method.substr(0, longest) + "...";
  return text(page_margin, 34, 17, e.query + ": " + outcome_text(e)) + text(page_margin, 54, 12, method, "soft");
}

/// Where on the picture the overlap or gap is.
std::optional<Vec3d> place_of_contact(const Explanation& e) {
  if (e.distance) return (e.distance->a + e.distance->b) * 0.5;
  if (!e.manifolds.empty()) return e.manifolds[0].points[0].position();
  if (e.cast && e.cast->hit) return e.cast->hit->point;
  return std::nullopt;
}

}  // namespace

std::string draw_explanation(const Explanation& e, const Vec3d& toward_viewer) {
  const TraceAxis* axis = e.ray ? nullptr : named(e.trace.axes, e.trace.winner);
  Vec3d toward = e.dimension == 2 ? Vec3d{0, 0, 1} : toward_viewer;
  if (axis && e.dimension == 3) toward = across(toward_viewer, axis->direction);
  if (e.ray && e.dimension == 3) toward = across(toward_viewer, normalized(e.ray->ray.direction));

  Posed pose_a = e.a->pose, pose_b = e.b ? e.b->pose : Posed{};
  Stage stage;
  stage.add(e.a->shape, pose_a);
  if (e.b) stage.add(e.b->shape, pose_b);
  if (e.cast) {  // the shapes stand where they meet
    pose_a = pose_at(pose_a, e.cast->a, last_time(*e.cast));
    pose_b = pose_at(pose_b, e.cast->b, last_time(*e.cast));
    stage.add(e.a->shape, pose_a);
    stage.add(e.b->shape, pose_b);
  }
  std::optional<DrawnRay> ray;
  if (e.ray) {
    ray.emplace(*e.ray, stage.box());
    for (const Vec3d& p : {ray->from, ray->to, ray->beyond}) stage.add(p);
  }
  const double size = stage.size();
  const auto polygons = [&](const Shaped& shape, const Posed& pose) {
    return tessellate(shape, pose, stage.box().center(), 0.7 * size);
  };
  const Polygons a = polygons(e.a->shape, pose_a), b = e.b ? polygons(e.b->shape, pose_b) : Polygons{};
  std::vector<Vec3d> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  if (ray) points.insert(points.end(), {ray->from, ray->to, ray->beyond});

  std::vector<std::pair<Polygons, Color>> ghosts;  // where bodies that move begin
  constexpr Color pale{160, 166, 173};
  if (e.cast)
    for (const auto& [body, velocity, color] :
         {std::tuple{&*e.a, &e.cast->a, color_a}, std::tuple{&*e.b, &e.cast->b, color_b}})
      if (velocity->linear != Vec3d{} || velocity->angular != Vec3d{})
        ghosts.emplace_back(polygons(body->shape, body->pose), mixed(color, pale, 0.7));
  for (const auto& [ghost, color] : ghosts) points.insert(points.end(), ghost.points.begin(), ghost.points.end());

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
  std::vector<DrawnFace> faces;
  for (const auto& [ghost, color] : ghosts) draw_shape(view, ghost, color, true, size, faces);
  draw_shape(view, a, color_a, true, size, faces);
  if (e.b) draw_shape(view, b, color_b, true, size, faces);
  std::string out =
      svg_head() + painted(std::move(faces)) + "<g font-family=\"system-ui, sans-serif\" fill=\"none\">\n";
  if (beside) out += beside->draw(view);
  const double bottom = draw_ids(e, out);
  if (ray) out += draw_ray(*e.ray, *ray, view);
  if (e.cast) out += draw_ways(e, view);
  out += draw_points(e, view);
  if (inset) out += draw_inset(view, *axis, *place);
  if (!e.trace.steps.empty())
    out += draw_steps(e, bottom);
  else
    out += e.ray ? draw_spans(e) : draw_axes(e, bottom);
  return out + headline(e) + "</g>\n</svg>\n";
}

}  // namespace graze::io
