// Scenes of the plane drawn in SVG. Numbers of elements and points are bounded here.
#include "io/svg_scene.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "graze/detail/validate.hpp"
#include "graze/error.hpp"
#include "io/plane_scene_parts.hpp"
#include "io/svg_path.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

using plane::Pose2d;
using plane::Vec2d;

constexpr std::size_t most_elements = 1000000;
/// The most steps of cutting solid polygons in a file, some seconds: one of n vertices takes up to n^2 of them.
constexpr double most_cutting = 4e8;

/// The attributes that an element hands down to those inside it.
struct Context {
  Affine2 map;
  PlaneSceneBuilder::Role role;
  std::optional<double> tolerance;
};

/// The value of a property in a `style`, without spaces, or empty; of several the last counts.
std::string style_property(std::string_view style, std::string_view name) {
  std::string plain, value;
  for (const char c : style)
    if (!is_space(c)) plain += c;
  for (std::string_view rest = plain; !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size()), colon = rest.find(':');
    if (colon < end && rest.substr(0, colon) == name) value = rest.substr(colon + 1, end - colon - 1);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return value;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> out;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t from = at;
    while (at < text.size() && !is_space(text[at])) ++at;
    if (at > from) out.emplace_back(text.substr(from, at - from));
    while (at < text.size() && is_space(text[at])) ++at;
  }
  return out;
}

class SvgReader {
 public:
  SvgReader(const XmlElement& root, const std::string& name) : scene_(name) {
    if (root.name != "svg") throw InvalidValue("", "an <svg> element as the root", "none");
    Context context;
    context.map = {{1, 0}, {0, -1}, {}};  // the Y axis points up here
    with(root, "data-gravity",
         [&](std::string_view text) { scene_.set_gravity(context.map.direction(vector_in(text))); });
    walk(root, context);
    for (const std::string& element : skipped_)
      scene_.note("<" + element + "> elements are no shapes and were left out");
  }

  PlaneScene take() { return scene_.take(); }

 private:
  /// The place of an element, for errors: "line 12: <rect id=floor>".
  static std::string place_of(const XmlElement& element) {
    const std::string* id = element.attribute("id");
    return (element.line ? "line " + std::to_string(element.line) + ": <" : "<") + element.name +
           (id ? " id=" + quoted(std::string_view(*id)) : std::string()) + ">";
  }

  /// Calls `f` with the value of an attribute; errors of it get the attribute's name.
  template <class F>
  static void with(const XmlElement& element, const char* name, const F& f) {
    const std::string* value = element.attribute(name);
    if (!value) return;
    try {
      f(std::string_view(*value));
    } catch (const InvalidValue& e) {
      throw InvalidValue(std::string(name) + (e.path().empty() ? "" : ", " + e.path()), e.expectation(), e.found());
    }
  }

  static double number(const XmlElement& element, const char* name, double otherwise) {
    double out = otherwise;
    with(element, name, [&](std::string_view text) {
      if (text.ends_with("px")) text.remove_suffix(2);
      const auto value = number_in(text);
      if (!value || !std::isfinite(*value)) throw InvalidValue("", "a number without a unit, or in px", quoted(text));
      out = *value;
    });
    return out;
  }
  static double length_of(const XmlElement& element, const char* name, double otherwise = 0) {
    const double value = number(element, name, otherwise);
    if (value < 0) throw InvalidValue(name, "a number >= 0", validate::number(value));
    return value;
  }

  static Vec2d vector_in(std::string_view text) {
    const std::vector<double> numbers = number_list(text);
    if (numbers.size() != 2) throw InvalidValue("", "two numbers", std::to_string(numbers.size()));
    return {numbers[0], numbers[1]};
  }

  static bool yes(std::string_view text) {
    if (text == "true") return true;
    if (text != "false") throw InvalidValue("", "true or false", quoted(text));
    return false;
  }

  /// Adds the attributes of an element to those that it was handed down.
  static void add_attributes(const XmlElement& element, Context& context) {
    with(element, "transform", [&](std::string_view text) { context.map = context.map * read_transform(text); });
    PlaneSceneBuilder::Role& role = context.role;
    with(element, "class", [&](std::string_view text) {
      for (const std::string& word : words_of(text)) {
        if (const auto motion = motion_named(word)) role.motion = *motion;
        if (word == "trigger") role.trigger = true;
      }
    });
    with(element, "data-motion", [&](std::string_view text) {
      const auto motion = motion_named(text);
      if (!motion) throw InvalidValue("", "one of static, kinematic, dynamic", quoted(text));
      role.motion = *motion;
    });
    with(element, "data-trigger", [&](std::string_view text) { role.trigger = yes(text); });
    with(element, "data-body", [&](std::string_view text) { role.body = text; });
    with(element, "data-systems", [&](std::string_view text) { role.systems = words_of(text); });
    with(element, "data-collide-with", [&](std::string_view text) {
      role.collide_with = words_of(text);
      role.not_collide_with.clear();
    });
    with(element, "data-not-collide-with", [&](std::string_view text) {
      if (element.attribute("data-collide-with")) throw InvalidValue("", "none beside data-collide-with", "both");
      role.not_collide_with = words_of(text);
      role.collide_with.clear();
    });
    add_physics(element, context);
    with(element, "data-tolerance", [&](std::string_view text) {
      const auto value = number_in(text);
      if (!value || !(*value > 0) || !std::isfinite(*value)) throw InvalidValue("", "a number > 0", quoted(text));
      context.tolerance = *value;
    });
  }

  /// Adds the physics of a body that is played. Velocities are in the frame of the element, a turning as that of
  /// `rotate`.
  static void add_physics(const XmlElement& element, Context& context) {
    PlaneMotion& motion = context.role.physics;
    with(element, "data-velocity",
         [&](std::string_view text) { motion.linear = context.map.direction(vector_in(text)); });
    if (element.attribute("data-angular"))
      motion.angular = std::copysign(1.0, cross(context.map.x, context.map.y)) * number(element, "data-angular", 0);
    if (element.attribute("data-mass")) motion.mass = number(element, "data-mass", 0);
    if (element.attribute("data-inertia")) motion.inertia = number(element, "data-inertia", 0);
    motion.gravity_factor = number(element, "data-gravity-factor", motion.gravity_factor);
    motion.friction = number(element, "data-friction", motion.friction);
    motion.restitution = number(element, "data-restitution", motion.restitution);
  }

  static bool hidden(const XmlElement& element) {
    const std::string *display = element.attribute("display"), *style = element.attribute("style");
    if (display && *display == "none") return true;
    return style && style_property(*style, "display") == "none";
  }

  /// Refuses a place in a `style`, which has units, an origin and an order of its own; as an attribute it is read.
  static void check_style(const XmlElement& element) {
    with(element, "style", [](std::string_view style) {
      for (const char* name : {"transform", "translate", "rotate", "scale", "offset-path"}) {
        const std::string value = style_property(style, name);
        if (!value.empty() && value != "none")
          throw InvalidValue("", "a transform as an attribute of its own",
                             quoted(std::string_view(std::string(name) + ":" + value)));
      }
    });
  }

  /// The map from the inside of an <svg> within another to what is around it. Of that at the root neither size nor
  /// `viewBox` count, as the numbers of the drawing are those of the scene.
  static Affine2 viewport_of(const XmlElement& element) {
    const Affine2 place{{1, 0}, {0, 1}, {number(element, "x", 0), number(element, "y", 0)}};
    Affine2 inside;
    with(element, "viewBox", [&](std::string_view box) {
      for (const char* side : {"width", "height"})
        if (!element.attribute(side)) throw InvalidValue("", std::string("a ") + side + " beside it", "none");
      const Vec2d size{length_of(element, "width"), length_of(element, "height")};
      const std::string* ratio = element.attribute("preserveAspectRatio");
      inside = read_view_box(box, size, ratio ? std::string_view(*ratio) : std::string_view());
    });
    return place * inside;
  }

  void walk(const XmlElement& element, Context context) {
    if (++elements_ > most_elements)
      throw InvalidValue("", "at most " + std::to_string(most_elements) + " elements", "more");
    try {
      if (hidden(element)) return;
      const std::string& name = element.name;
      const bool group = name == "svg" || name == "g" || name == "a" || name == "switch";
      if (!group && !is_shape(name)) {
        // Elements that are drawn and no shapes are named; those that only describe are not.
        static const std::set<std::string> drawn{"text", "image", "use", "foreignObject"};
        if (drawn.count(name)) skipped_.insert(name);
        return;
      }
      check_style(element);
      add_attributes(element, context);
      if (name == "svg" && elements_ > 1) context.map = context.map * viewport_of(element);
      if (!group) return add(element, name, context);
    } catch (const InvalidValue& e) {
      throw e.below(place_of(element));
    }
    for (const XmlElement& child : element.children) walk(child, context);
  }

  static bool is_shape(const std::string& name) {
    static const std::set<std::string> shapes{"rect", "circle", "ellipse", "line", "polyline", "polygon", "path"};
    return shapes.count(name) != 0;
  }

  void add(const XmlElement& element, const std::string& name, const Context& context) {
    const double margin = length_of(element, "data-margin");
    if (name == "rect") return add_rect(element, context, margin);
    if (name == "circle" || name == "ellipse") return add_ellipse(element, name, context, margin);
    bool solid = true;
    with(element, "data-solid", [&](std::string_view text) { solid = yes(text); });
    if (name == "line") {
      const Vec2d p{number(element, "x1", 0), number(element, "y1", 0)},
          q{number(element, "x2", 0), number(element, "y2", 0)};
      add_points(element, {{context.map(p), context.map(q)}, false}, context, margin, false);
      return;
    }
    if (name == "path") {
      std::vector<Subpath> paths;
      with(element, "d", [&](std::string_view text) { paths = read_path(text, context.map, context.tolerance); });
      std::size_t closed = 0;
      for (const Subpath& p : paths) closed += p.closed;
      // The fill rule would decide whether one outline is a hole in another, and holes are not read.
      if (closed > 1 && solid)
        throw InvalidValue("d", "one closed outline (a path each, or data-solid=\"false\")", std::to_string(closed));
      std::optional<std::uint32_t> body;  // one, of however many pieces
      for (const Subpath& p : paths) body = add_points(element, p, context, margin, solid, body);
      return;
    }
    Subpath path{{}, name == "polygon"};
    with(element, "points", [&](std::string_view text) {
      const std::vector<double> numbers = number_list(text);
      if (numbers.size() % 2)
        throw InvalidValue("", "two numbers a point", std::to_string(numbers.size()) + " numbers");
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        path.points.push_back(context.map(Vec2d{numbers[i], numbers[i + 1]}));
    });
    if (!path.points.empty()) add_points(element, path, context, margin, solid);
  }

  using OptionalBody = std::optional<std::uint32_t>;

  /// Adds the shape of an element, to a body that is there or else to that of its role, and returns the body.
  std::uint32_t put(const XmlElement& element, const Context& context, plane::Shaped shape, const Pose2d& pose,
                    OptionalBody body = {}) {
    for (const double v : {pose.translation.x, pose.translation.y})
      if (const char* expectation = validate::fault_of_coordinate(v))
        throw InvalidValue("position", expectation, validate::number(v));
    const std::string* id = element.attribute("id");
    std::string name = id ? *id : element.name + " " + std::to_string(scene_.size());
    return scene_.add(std::move(name), context.role, std::move(shape), pose, body);
  }

  void add_rect(const XmlElement& element, const Context& context, double margin) {
    const double width = length_of(element, "width"), height = length_of(element, "height");
    const Vec2d corner{number(element, "x", 0), number(element, "y", 0)};
    const bool has_x = element.attribute("rx"), has_y = element.attribute("ry");
    double rx = has_x ? length_of(element, "rx") : length_of(element, "ry");
    double ry = has_y ? length_of(element, "ry") : rx;
    rx = std::min(rx, width / 2), ry = std::min(ry, height / 2);
    const Stretches stretches = stretches_of(context.map);
    const Vec2d center = corner + Vec2d{width, height} * 0.5;
    if (!stretches.similar) {
      if (rx > 0 || ry > 0)
        throw InvalidValue("transform", "no skew and one scale, where corners are round", "another transform");
      Subpath path{{}, true};
      for (const Vec2d& p :
           {corner, corner + Vec2d{width, 0}, corner + Vec2d{width, height}, corner + Vec2d{0, height}})
        path.points.push_back(context.map(p));
      add_points(element, path, context, margin, true);
      return;
    }
    const double s = stretches.longer;
    if (rx != ry) {
      if (!(std::abs(rx - ry) <= 1e-9 * std::max(rx, ry)))
        throw InvalidValue("ry", "corners as round along both sides", validate::number(ry));
    }
    const plane::Rot2d turn{stretches.turn.x, stretches.turn.y};
    put(element, context, {plane::Box<double>({(width - 2 * rx) * s, (height - 2 * rx) * s}), rx * s + margin},
        {context.map(center), turn});
  }

  void add_ellipse(const XmlElement& element, const std::string& name, const Context& context, double margin) {
    const bool circle = name == "circle";
    const double rx = length_of(element, circle ? "r" : "rx"), ry = circle ? rx : length_of(element, "ry");
    const Vec2d center{number(element, "cx", 0), number(element, "cy", 0)};
    const Stretches radii = stretches_of(context.map * Affine2{{rx, 0}, {0, ry}, {}});
    const Pose2d pose{context.map(center), {radii.turn.x, radii.turn.y}};
    if (radii.similar)
      put(element, context, {plane::Circle<double>(radii.longer), margin}, {pose.translation, {}});
    else
      put(element, context, {plane::Ellipse<double>({radii.longer, radii.shorter}), margin}, pose);
  }

  /// Adds a closed outline as a solid polygon or a closed chain, an open one as a chain; two points as a segment.
  std::uint32_t add_points(const XmlElement& element, Subpath path, const Context& context, double margin, bool solid,
                           OptionalBody body = {}) {
    std::vector<Vec2d>& points = path.points;
    const auto repeats = [](const Vec2d& p, const Vec2d& q) { return p == q; };
    points.erase(std::unique(points.begin(), points.end(), repeats), points.end());
    while (path.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
    Vec2d low = points[0], high = points[0];
    for (const Vec2d& p : points) low = plane::least(low, p), high = plane::greatest(high, p);
    const Pose2d pose{(low + high) * 0.5, {}};
    for (Vec2d& p : points) p -= pose.translation;
    if (points.size() == 1)
      return put(element, context, {plane::Segment<double>(points[0], points[0]), margin}, pose, body);
    if (points.size() == 2)
      return put(element, context, {plane::Segment<double>(points[0], points[1]), margin}, pose, body);
    if (path.closed && solid) {
      cutting_ += double(points.size()) * double(points.size());
      if (!(cutting_ <= most_cutting))
        throw InvalidValue("", "solid outlines of fewer points, in all (20,000 in one; chains may have more)",
                           std::to_string(points.size()) + " more");
      return put(element, context, {solid_polygon(points, pose.translation), margin}, pose, body);
    }
    plane::ChainSides sides = plane::ChainSides::both;
    with(element, "data-sides", [&](std::string_view text) {
      if (text != "one" && text != "both") throw InvalidValue("", "one or both", quoted(text));
      if (text == "one") sides = plane::ChainSides::one;
    });
    return put(element, context, {plane::Chain<double>(points, path.closed, sides), margin}, pose, body);
  }

  /// A solid polygon of points about `middle`. What it refuses is told with that middle, from which the drawing's own
  /// coordinates follow.
  static plane::Polygon<double> solid_polygon(const std::vector<Vec2d>& points, const Vec2d& middle) {
    try {
      return plane::Polygon<double>(points);
    } catch (const InvalidValue& fault) {
      throw InvalidValue(fault.path(), fault.expectation(),
                         fault.found() + " from the middle [" + validate::number(middle.x) + ", " +
                             validate::number(middle.y) + "] of the shape, with Y up");
    }
  }

  PlaneSceneBuilder scene_;
  std::set<std::string> skipped_;
  std::size_t elements_ = 0;
  double cutting_ = 0;
};

}  // namespace

PlaneScene read_svg(const XmlElement& root, const std::string& source_name) {
  try {
    return SvgReader(root, source_name).take();
  } catch (const InvalidValue& e) {
    throw InvalidValue(e.path().empty() ? source_name : source_name + ": " + e.path(), e.expectation(), e.found());
  }
}

}  // namespace graze::io
