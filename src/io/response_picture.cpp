// The picture of a blow. Seen along the contact plane and across the sliding, so that the normal, the sliding, the
// impulse and Coulomb's cone all lie in the picture.
#include <fmt/format.h>

#include <cmath>

#include "io/explain_parts.hpp"
#include "io/explained_bodies.hpp"
#include "io/labels.hpp"
#include "io/response.hpp"

namespace graze::io {

namespace {

/// The part of an impulse, velocity or turn below which its direction is rounding: that of a float, 6e-8, after a dozen
/// operations.
constexpr double seen_part = 1e-6;
/// Lengths of the longest velocity and of the longest impulse, and the radius of a turn, as parts of the bodies' size.
constexpr double longest_velocity = 0.34, longest_impulse = 0.3, turn_radius = 0.13;
constexpr double row_height = 17;
constexpr const char* dashes = " stroke-dasharray=\"5 4\"";

/// The tangent along which friction acts: that of the sliding it would end. Zero where nothing slides.
Vec3d sliding_direction(const ExplainedResponse& blow) {
  const Response<double>& r = blow.result;
  const double impulse = std::max(length(r.impulse), length(r.stopping_impulse));
  if (length(r.stopping_impulse) > seen_part * impulse) return normalized(r.stopping_impulse);
  if (length(r.approach.tangential) > seen_part * length(r.approach.whole)) return normalized(-r.approach.tangential);
  return {};
}

Vec3d side_view(const ExplainedResponse& blow, const Vec3d& toward_viewer) {
  const Vec3d tangent = sliding_direction(blow);
  if (tangent == Vec3d{}) return across(toward_viewer, blow.contact.normal);
  const Vec3d toward = cross(tangent, blow.contact.normal);
  return dot(toward, toward_viewer) < 0 ? -toward : toward;
}

/// An arrow of the picture, from pixel to pixel, without a tip where it is too short for one.
std::string pixel_arrow(double x0, double y0, double x1, double y1, const std::string& look, double thickness,
                        const char* more = "") {
  const double dx = x1 - x0, dy = y1 - y0, l = std::hypot(dx, dy);
  if (l < 1) return "";
  const bool colored = look.starts_with('#');
  const std::string stroke = colored ? "stroke=\"" + look + '"' : "class=\"" + look + '"';
  // The classes that fill with the colour in which these stroke.
  const std::string fill = colored ? "fill=\"" + look + '"' : look == "shared" ? "class=\"red\"" : "class=\"tip\"";
  const double tip = std::min(9.0, 0.6 * l), ux = dx / l, uy = dy / l, wing = 0.45 * tip;
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {} stroke-width=\"{}\"{}/>"
                     "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" {}/>\n",
                     x0, y0, x1 - 0.6 * tip * ux, y1 - 0.6 * tip * uy, stroke, thickness, more, x1, y1,
                     x1 - tip * ux - wing * uy, y1 - tip * uy + wing * ux, x1 - tip * ux + wing * uy,
                     y1 - tip * uy - wing * ux, fill);
}

/// The scene of a blow: what is drawn of the bodies, and how long velocities and impulses are.
class BlowScene {
 public:
  BlowScene(const Explanation& e, const Vec3d& toward) : blow_(*e.response), bodies_(e), toward_(normalized(toward)) {
    fit();
    const Response<double>& r = blow_.result;
    const auto longest = [](std::initializer_list<Vec3d> vectors) {
      double most = 0;
      for (const Vec3d& v : vectors) most = std::max(most, length(v));
      return most > 0 ? most : 1;
    };
    per_speed_ =
        longest_velocity * size_ / longest({blow_.a.motion.linear, blow_.b.motion.linear, r.a.linear, r.b.linear});
    per_impulse_ = longest_impulse * size_ / longest({r.impulse, blow_.contact.normal * r.normal_impulse});
    const auto turning = [&](const Motion<double>& m) { return std::abs(dot(m.angular, toward_)); };
    fastest_turn_ = std::max({turning(blow_.a.motion), turning(blow_.b.motion), turning(r.a), turning(r.b)});
  }

  std::string draw() const {
    std::vector<Vec3d> points = corners_;
    for (const bool b : {false, true})
      for (const Motion<double>* m : {&before(b), &after(b)}) points.push_back(center(b) + m->linear * per_speed_);
    points.push_back(impulse_tip());
    for (const bool b : {false, true})
      if (is_ground(b))
        for (const double side : {-0.5, 0.5}) points.push_back(point() + ground_direction() * (side * size_));
    const View view(toward_, points, shapes_panel);
    SvgDraw canvas(view, {}, 0.45 * size_);
    for (const bool b : {false, true})
      if (bodies_.has(b)) canvas.polygons(polygons(b), DrawLayer::shapes, b ? DrawMeaning::b : DrawMeaning::a);
    std::string out = canvas.faces() + "<g font-family=\"system-ui, sans-serif\" fill=\"none\">\n";
    for (const bool b : {false, true})
      if (is_ground(b)) out += ground(view, b);
    out += cone(view);
    Labels labels;
    for (const bool b : {false, true})
      if (!is_ground(b)) out += motion(view, b, labels);
    out += vector(view, point(), impulse_tip(), "shared", 2.4, "", labels);
    out += "<g class=\"arrow\">" + arrow(view, point(), blow_.contact.normal) + "</g>\n";
    out += dot_at(view, point(), "red");
    for (const bool b : {false, true})
      if (!is_ground(b)) out += names(view, b, labels);
    if (blow_.result.impulse != Vec3d{}) out += labels.at(view.x(impulse_tip()), view.y(impulse_tip()), "impulse on B");
    return out + draw_letters(view, seen(false), seen(true));
  }

 private:
  const Motion<double>& before(bool b) const { return b ? blow_.b.motion : blow_.a.motion; }
  const Motion<double>& after(bool b) const { return b ? blow_.result.b : blow_.result.a; }
  const InverseMass<double>& mass(bool b) const { return b ? blow_.b.mass : blow_.a.mass; }
  const Vec3d& center(bool b) const { return before(b).center; }
  const Vec3d& point() const { return blow_.contact.point; }
  Vec3d impulse_tip() const { return point() + blow_.result.impulse * per_impulse_; }
  Vec3d velocity_tip(bool b, bool then) const { return center(b) + (then ? after(b) : before(b)).linear * per_speed_; }
  /// Whether a body is drawn as its side of the contact plane.
  bool is_ground(bool b) const { return !bodies_.has(b) && !mass(b).movable(); }
  Vec3d ground_direction() const { return normalized(cross(toward_, blow_.contact.normal)); }
  Polygons polygons(bool b) const { return bodies_.polygons(b, 0, point(), 0.7 * size_); }

  /// The part of a body that the picture shows: its shape, or its centre; nothing of the ground.
  Polygons seen(bool b) const {
    if (bodies_.has(b)) return polygons(b);
    Polygons dot;
    if (!is_ground(b)) dot.points.push_back(center(b));
    return dot;
  }

  /// Gathers the points of the bodies that have to be seen, and measures them.
  void fit() {
    Stage stage;
    stage.add(point());
    for (const bool b : {false, true}) {
      if (bodies_.has(b)) stage.add(bodies_.box(b, 0));
      if (!is_ground(b)) stage.add(center(b));
    }
    size_ = stage.size();
    corners_.push_back(point());
    for (const bool b : {false, true}) {
      if (!bodies_.has(b)) continue;
      const Polygons shape = polygons(b);
      corners_.insert(corners_.end(), shape.points.begin(), shape.points.end());
    }
  }

  /// The contact plane of an immovable body without a shape, hatched on the side of the body.
  std::string ground(const View& view, bool b) const {
    const Vec3d along = ground_direction(), inward = blow_.contact.normal * (b ? 1 : -1);
    constexpr int hatches = 12;
    const double half = 0.5 * size_, step = 2 * half / hatches;
    std::string out = line(view, point() - along * half, point() + along * half, "gap", 2);
    for (int i = 0; i < hatches; ++i) {
      const Vec3d from = point() + along * (step * (i + 0.75) - half);
      out += line(view, from, from + (inward - along) * (0.6 * step), "rule", 1);
    }
    return out;
  }

  /// Coulomb's cone about the normal, on the side of B, as high as the normal impulse.
  std::string cone(const View& view) const {
    const Response<double>& r = blow_.result;
    if (!(r.normal_impulse > 0 && r.friction_limit > 0)) return "";
    const Vec3d along = ground_direction();
    const Vec3d axis = blow_.contact.normal * (r.normal_impulse * per_impulse_);
    const double most = 0.35 * size_, rim = r.friction_limit * per_impulse_;
    // A cone that is nearly a plane is cut where it leaves the picture.
    const double part = rim > most ? most / rim : 1;
    std::string out;
    for (const double side : {-1.0, 1.0})
      out += line(view, point(), point() + (axis + along * (side * rim)) * part, "rule", 1.2, dashes);
    return out;
  }

  /// An arrow that labels stay off.
  static std::string vector(const View& view, const Vec3d& from, const Vec3d& to, const std::string& look,
                            double thickness, const char* more, Labels& labels) {
    constexpr int places = 12;
    for (int i = 0; i <= places; ++i) {
      const Vec3d at = from + (to - from) * (static_cast<double>(i) / places);
      labels.keep_clear(view.x(at), view.y(at), 4);
    }
    return pixel_arrow(view.x(from), view.y(from), view.x(to), view.y(to), look, thickness, more);
  }

  std::string motion(const View& view, bool b, Labels& labels) const {
    const std::string look = hex(b ? color_b : color_a, 0.8);
    std::string out;
    for (const bool then : {false, true}) {
      out += vector(view, center(b), velocity_tip(b, then), look, 2.2, then ? "" : dashes, labels);
      out += turn(view, b, dot((then ? after(b) : before(b)).angular, toward_), then, look);
    }
    return out + dot_at(view, center(b), look);
  }

  /// The words at the tips of a body's velocities.
  std::string names(const View& view, bool b, Labels& labels) const {
    std::string out;
    for (const bool then : {false, true})
      if (const Vec3d tip = velocity_tip(b, then); length(tip - center(b)) > seen_part * size_)
        out += labels.at(view.x(tip), view.y(tip), then ? "after" : "before");
    return out;
  }

  /// A turn about the centre of mass as seen here, an arc that is the longer the faster it is.
  std::string turn(const View& view, bool b, double speed, bool then, const std::string& look) const {
    if (!(std::abs(speed) > seen_part * fastest_turn_)) return "";
    constexpr double longest_arc = 4.2;  // radians
    const double angle = std::copysign(0.5 + (longest_arc - 0.5) * std::abs(speed) / fastest_turn_, speed);
    const double radius = turn_radius * (then ? 1 : 0.8) * size_ * view.scale(), x = view.x(center(b)),
                 y = view.y(center(b));
    constexpr double begin = 1.2;
    const double end = begin + angle;
    const auto at = [&](double phi) { return std::pair{x + radius * std::cos(phi), y - radius * std::sin(phi)}; };
    const auto [x0, y0] = at(begin);
    const auto [x1, y1] = at(end);
    // The tip points along the arc's tangent at its end.
    const double sign = speed > 0 ? 1 : -1, tx = -std::sin(end) * sign, ty = -std::cos(end) * sign;
    return fmt::format("<path d=\"M{:.1f} {:.1f}A{:.1f} {:.1f} 0 {} {} {:.1f} {:.1f}\" stroke=\"{}\" "
                       "stroke-width=\"1.6\"{}/>",
                       x0, y0, radius, radius, std::abs(angle) > 3.141592653589793 ? 1 : 0, speed > 0 ? 0 : 1, x1, y1,
                       look, then ? "" : dashes) +
           pixel_arrow(x1 - 2 * tx, y1 - 2 * ty, x1 + 7 * tx, y1 + 7 * ty, look, 1.6);
  }

  const ExplainedResponse& blow_;
  const Drawn bodies_;
  Vec3d toward_;
  std::vector<Vec3d> corners_;
  double size_ = 1, per_speed_ = 1, per_impulse_ = 1, fastest_turn_ = 0;
};

/// A number of a list. A component that is only the rounding of larger ones is 0: thousands of times a double's, 1e-16.
std::string component_text(double number, double largest) {
  constexpr double rounding = 1e-12;
  if (std::isinf(number)) return "infinity";
  return fmt::format("{:.4g}", std::abs(number) > rounding * largest ? number : 0.0);
}

/// Rows of quantities from `y` down; moves `y` on.
std::string rows(const std::vector<Quantity>& quantities, double& y) {
  constexpr double column = 72;
  std::string out;
  for (const Quantity& q : quantities) {
    const bool part = q.name.starts_with(' ');
    out += text(list_x + (part ? 12 : 0), y, 12, q.name, part ? "soft" : "ink");
    if (!q.word.empty()) out += text(number_x, y, 12, q.word, "ink", "end");
    double x = number_x - column * (static_cast<double>(q.numbers.size()) - 1), largest = 0;
    for (const double number : q.numbers) largest = std::max(largest, std::abs(number));
    for (const double number : q.numbers) {
      out += text(x, y, 12, component_text(number, largest), "ink", "end");
      x += column;
    }
    y += row_height;
  }
  return out;
}

/// Coulomb's cone with the normal impulse upwards, turned from the bodies' picture: the impulse that would end the
/// sliding, and the part of it that friction carries.
std::string cone_panel(const ExplainedResponse& blow, const Vec3d& toward, double top) {
  const Response<double>& r = blow.result;
  const double j = r.normal_impulse, stopping = length(r.stopping_impulse), friction = length(r.friction_impulse);
  if (!(j > 0)) return text(list_x, top + 14, 12, "The bodies part: there is no impulse.", "soft");
  const double bottom = picture_height - page_margin - 16, middle = (list_x + number_x) / 2;
  const double scale = std::min((bottom - top - 34) / j, 0.4 * (number_x - list_x) / std::max(stopping, 0.2 * j));
  const double y = bottom - j * scale, rim = r.friction_limit * scale;
  const double aside = dot(cross(blow.contact.normal, r.stopping_impulse), toward) > 0 ? -scale : scale;
  // A wide cone is cut at the panel's sides.
  const double half = std::min(rim, 0.5 * (number_x - list_x)), side = rim > half ? bottom - j * scale * half / rim : y;
  std::string out = fmt::format("<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}V{4:.1f}H{5:.1f}V{3:.1f}Z\" "
                                "class=\"chosen\"/>\n",
                                middle, bottom, middle - half, side, y, middle + half);
  out += pixel_arrow(middle, bottom, middle, y, "arrow", 1.4);
  out += pixel_arrow(middle, y, middle + stopping * aside, y, "gap", 1.4, dashes);
  out += pixel_arrow(middle, bottom, middle + friction * aside, y, "shared", 2.2);
  const bool left = aside < 0;
  out += text(middle + (left ? 8 : -8), y - 6, 11, fmt::format("normal {:.4g}", j), "soft", left ? "start" : "end");
  if (stopping > seen_part * j)
    out += text(middle + (left ? -8 : 8), y - 6, 11, fmt::format("ends the sliding: {:.4g}", stopping), "soft",
                left ? "end" : "start");
  return out + text(middle, bottom + 18, 11,
                    fmt::format("friction carries {:.4g} of at most {:.4g}", friction, r.friction_limit), "soft",
                    "middle");
}

}  // namespace

std::string draw_response(const Explanation& e, const Vec3d& toward_viewer) {
  const Vec3d toward = e.dimension == 2 ? Vec3d{0, 0, 1} : side_view(*e.response, toward_viewer);
  std::string out = svg_head() + BlowScene(e, toward).draw();
  double y = head_height + 22;
  out += rows(quantities_of_blow(e), y);
  y += row_height / 2;
  out += rows(effects_of_blow(e), y);
  return out + cone_panel(*e.response, toward, y) + headline(e) + "</g>\n</svg>\n";
}

}  // namespace graze::io
