#include "io/svg_path.hpp"

#include <cmath>
#include <string>

#include "graze/angles.hpp"
#include "graze/detail/validate.hpp"
#include "io/parsed_number.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

using plane::Vec2d;

/// A place in a text that is read number by number.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool at_end() {
    skip();
    return at_ == text_.size();
  }
  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char take() { return text_[at_++]; }
  bool at_number() {
    const char c = peek();
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  }
  double number() {
    if (!at_number()) fail("a number");
    std::size_t from = at_;
    if (text_[from] == '+') ++from;
    const auto [value, length, error] = parse_number(text_.substr(from));
    if (error != std::errc() || !std::isfinite(value)) fail("a finite number");
    at_ = from + length;
    return value;
  }
  /// One digit of an arc's flags, which need no space after them.
  bool flag() {
    const char c = peek();
    if (c != '0' && c != '1') fail("a flag, 0 or 1");
    return take() == '1';
  }
  std::string_view word() {
    const char first = peek();
    const std::size_t from = at_;
    if ((first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z'))
      while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(from, at_ - from);
  }
  [[noreturn]] void fail(const std::string& expectation) const {
    throw InvalidValue("character " + std::to_string(at_ + 1), expectation,
                       at_ < text_.size() ? quoted(text_.substr(at_, 12)) : "the end");
  }

 private:
  void skip() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

constexpr double degree = 0.017453292519943295;

Affine2 rotation(double angle) {
  const auto [c, s] = cosine_sine(angle);
  return {{c, s}, {-s, c}, {}};
}

double tangent(double angle) {
  const auto [cosine, sine] = cosine_sine(angle);
  return sine / cosine;
}

/// A piece of a path, in the frame of the path; straight ones have no control points.
struct Curve {
  enum Kind { line, quadratic, cubic, arc } kind;
  Vec2d p[4];  ///< of an arc: centre, the map of the unit circle (two columns)
  double from = 0, sweep = 0;
};

struct Outline {
  Vec2d start;
  std::vector<Curve> curves;
  bool closed = false;
};

/// An arc by its ends, radii and flags as centre and angles (SVG 1.1, appendix F.6.5); a line where it has no radius.
Curve arc_between(const Vec2d& from, const Vec2d& to, double rx, double ry, double tilt, bool large, bool positive) {
  const Curve straight{Curve::line, {to, {}, {}, {}}};
  rx = std::abs(rx), ry = std::abs(ry);
  if (rx == 0 || ry == 0 || from == to) return straight;
  const Affine2 turn = rotation(tilt);
  const Vec2d half = (from - to) * 0.5, own{dot(half, turn.x), dot(half, turn.y)};
  const double stretch = (own.x / rx) * (own.x / rx) + (own.y / ry) * (own.y / ry);
  if (stretch > 1) rx *= std::sqrt(stretch), ry *= std::sqrt(stretch);
  const Vec2d unit{own.x / rx, own.y / ry};
  const double l2 = length_squared(unit), rest = std::sqrt(std::max(1 / l2 - 1, 0.0));
  if (!std::isfinite(rest)) return straight;
  const Vec2d center = Vec2d{unit.y, -unit.x} * (large == positive ? -rest : rest);
  const Vec2d first = unit - center, last = -unit - center;
  double sweep = angle_of(dot(first, last), cross(first, last));
  if (positive && sweep < 0) sweep += 360 * degree;
  if (!positive && sweep > 0) sweep -= 360 * degree;
  const Vec2d middle = (from + to) * 0.5 + turn.direction({center.x * rx, center.y * ry});
  return {Curve::arc, {to, middle, turn.x * rx, turn.y * ry}, angle_of(first.x, first.y), sweep};
}

/// Path data as curves with absolute points.
class PathReader {
 public:
  explicit PathReader(std::string_view text) : in_(text) {}

  std::vector<Outline> read() {
    char command = '\0';
    while (!in_.at_end()) {
      if (!in_.at_number()) {
        command = in_.take();
        if (std::string_view("MmZzLlHhVvCcSsQqTtAa").find(command) == std::string_view::npos)
          in_.fail("one of the commands M, L, H, V, C, S, Q, T, A, Z before this");
        if (outlines_.empty() && command != 'M' && command != 'm') in_.fail("a path that begins with M, here");
      } else if (command == '\0' || command == 'Z' || command == 'z') {
        in_.fail("a command");
      } else if (command == 'M' || command == 'm') {
        command = command == 'M' ? 'L' : 'l';  // further points are lines
      }
      step(command);
      if (++count_ > most_path_points)
        throw InvalidValue("", "at most " + std::to_string(most_path_points) + " pieces", "more");
    }
    return std::move(outlines_);
  }

 private:
  Vec2d point(bool relative) {
    const double x = in_.number();
    const Vec2d p{x, in_.number()};
    return relative ? at_ + p : p;
  }
  void add(const Curve& curve) {
    // A curve behind a closed outline begins where that did.
    if (outlines_.back().closed) outlines_.push_back({at_, {}});
    outlines_.back().curves.push_back(curve);
    at_ = curve.p[curve.kind == Curve::cubic ? 2 : curve.kind == Curve::quadratic ? 1 : 0];
  }
  void step(char command) {
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    const Vec2d mirrored = at_ * 2 - control_;
    const bool after_cubic = last_ == 'C' || last_ == 'S', after_quadratic = last_ == 'Q' || last_ == 'T';
    last_ = kind;
    switch (kind) {
    case 'M':
      at_ = point(relative);
      outlines_.push_back({at_, {}});
      return;
    case 'Z':
      outlines_.back().closed = true;
      at_ = outlines_.back().start;
      return;
    case 'L': return add({Curve::line, {point(relative), {}, {}, {}}});
    case 'H': {
      const double x = in_.number();
      return add({Curve::line, {{relative ? at_.x + x : x, at_.y}, {}, {}, {}}});
    }
    case 'V': {
      const double y = in_.number();
      return add({Curve::line, {{at_.x, relative ? at_.y + y : y}, {}, {}, {}}});
    }
    case 'C':
    case 'S': {
      const Vec2d first = kind == 'C' ? point(relative) : after_cubic ? mirrored : at_;
      const Vec2d second = point(relative), end = point(relative);
      add({Curve::cubic, {first, second, end, {}}});
      control_ = second;
      return;
    }
    case 'Q':
    case 'T': {
      const Vec2d middle = kind == 'Q' ? point(relative) : after_quadratic ? mirrored : at_;
      add({Curve::quadratic, {middle, point(relative), {}, {}}});
      control_ = middle;
      return;
    }
    default: break;
    }
    const double rx = in_.number(), ry = in_.number(), tilt = in_.number() * degree;
    const bool large = in_.flag(), positive = in_.flag();
    add(arc_between(at_, point(relative), rx, ry, tilt, large, positive));
  }

  Scanner in_;
  std::vector<Outline> outlines_;
  Vec2d at_{}, control_{};
  char last_ = '\0';
  std::size_t count_ = 0;
};

/// The number of pieces for a curve whose second derivative by a parameter from 0 to 1 is at most `bend`: a chord over
/// a stretch h of the parameter is no further off than bend h^2 / 8.
std::size_t pieces_for(double bend, double tolerance) {
  const double count = std::ceil(std::sqrt(bend / (8 * tolerance)));
  if (!(count < static_cast<double>(most_path_points)))
    throw InvalidValue("", "a tolerance that curves can be flattened to", validate::number(tolerance));
  return std::max<std::size_t>(1, static_cast<std::size_t>(count));
}

/// A curve and where it begins, mapped.
struct Mapped {
  const Affine2& map;
  double tolerance;
  std::vector<Vec2d>& points;
  std::size_t& count;  ///< of all points of the path

  void add(const Vec2d& p) const {
    if (++count > most_path_points)
      throw InvalidValue("", "at most " + std::to_string(most_path_points) + " points", "more");
    points.push_back(p);
  }
  template <class F>
  void sample(double bend, const F& at) const {
    const std::size_t pieces = pieces_for(bend, tolerance);
    for (std::size_t i = 1; i <= pieces; ++i) add(at(double(i) / double(pieces)));
  }
  void flatten(const Vec2d& from, const Curve& c) const {
    if (c.kind == Curve::line) return add(map(c.p[0]));
    if (c.kind == Curve::arc) {
      const Affine2 circle = map * Affine2{c.p[2], c.p[3], c.p[1]};
      const double bend = stretches_of(circle).longer * c.sweep * c.sweep;
      return sample(bend, [&](double t) {
        const CosineSine at = cosine_sine(c.from + t * c.sweep);
        return t == 1 ? map(c.p[0]) : circle({at.cosine, at.sine});
      });
    }
    const Vec2d a = map(from), b = map(c.p[0]), d = map(c.p[1]);
    if (c.kind == Curve::quadratic) {
      const Vec2d second = (a - b * 2 + d) * 2;
      return sample(length(second), [&](double t) {
        return t == 1 ? d : a * ((1 - t) * (1 - t)) + b * (2 * t * (1 - t)) + d * (t * t);
      });
    }
    const Vec2d e = map(c.p[2]);
    const double bend = 6 * std::max(length(a - b * 2 + d), length(b - d * 2 + e));
    sample(bend, [&](double t) {
      const double s = 1 - t;
      return t == 1 ? e : a * (s * s * s) + b * (3 * s * s * t) + d * (3 * s * t * t) + e * (t * t * t);
    });
  }
};

const Vec2d& end_of(const Curve& c) { return c.p[c.kind == Curve::cubic ? 2 : c.kind == Curve::quadratic ? 1 : 0]; }

/// The larger side of the bounds of all points and control points.
double size_of(const std::vector<Outline>& outlines, const Affine2& map) {
  Vec2d low{1e300, 1e300}, high{-1e300, -1e300};
  const auto see = [&](const Vec2d& p) { low = plane::least(low, map(p)), high = plane::greatest(high, map(p)); };
  for (const Outline& o : outlines) {
    see(o.start);
    for (const Curve& c : o.curves) {
      see(end_of(c));
      if (c.kind == Curve::quadratic || c.kind == Curve::cubic) see(c.p[0]), see(c.p[1]);
      if (c.kind == Curve::arc) see(c.p[1] + c.p[2]), see(c.p[1] - c.p[2]), see(c.p[1] + c.p[3]), see(c.p[1] - c.p[3]);
    }
  }
  return plane::max_abs(high - low);
}

}  // namespace

Stretches stretches_of(const Affine2& map) {
  const double e = (map.x.x + map.y.y) / 2, f = (map.x.x - map.y.y) / 2, g = (map.x.y + map.y.x) / 2,
               h = (map.x.y - map.y.x) / 2;
  const double q = std::hypot(e, h), r = std::hypot(f, g);
  Stretches out{q + r, std::abs(q - r), {1, 0}, false};
  constexpr double same = 1e-9;  // relative: far above the rounding of a few maps, far below what an eye sees
  out.similar = out.longer - out.shorter <= same * out.longer;
  const double angle = out.similar ? angle_of(map.x.x, map.x.y) : (angle_of(f, g) + angle_of(e, h)) / 2;
  const auto [cosine, sine] = cosine_sine(angle);
  out.turn = {cosine, sine};
  return out;
}

std::vector<double> number_list(std::string_view text) {
  Scanner in(text);
  std::vector<double> out;
  while (!in.at_end()) {
    out.push_back(in.number());
    if (out.size() > 2 * most_path_points)
      throw InvalidValue("", "at most " + std::to_string(2 * most_path_points) + " numbers", "more");
  }
  return out;
}

Affine2 read_transform(std::string_view text) {
  Scanner in(text);
  Affine2 all;
  while (!in.at_end()) {
    const std::string_view name = in.word();
    if (in.peek() != '(') in.fail("a transform and its numbers in parentheses");
    in.take();
    double n[6] = {};
    std::size_t count = 0;
    while (in.peek() != ')') {
      if (count == 6) in.fail("at most six numbers, and then )");
      n[count++] = in.number();
    }
    in.take();
    if (name == "matrix" && count == 6)
      all = all * Affine2{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
    else if (name == "translate" && (count == 1 || count == 2))
      all = all * Affine2{{1, 0}, {0, 1}, {n[0], n[1]}};
    else if (name == "scale" && (count == 1 || count == 2))
      all = all * Affine2{{n[0], 0}, {0, count == 2 ? n[1] : n[0]}, {}};
    else if (name == "rotate" && (count == 1 || count == 3))
      all = all * Affine2{{1, 0}, {0, 1}, {n[1], n[2]}} * rotation(n[0] * degree) *
            Affine2{{1, 0}, {0, 1}, {-n[1], -n[2]}};
    else if (name == "skewX" && count == 1)
      all = all * Affine2{{1, 0}, {tangent(n[0] * degree), 1}, {}};
    else if (name == "skewY" && count == 1)
      all = all * Affine2{{1, tangent(n[0] * degree)}, {0, 1}, {}};
    else
      in.fail("matrix(6 numbers), translate(1 or 2), scale(1 or 2), rotate(1 or 3), skewX(1) or skewY(1), before this");
  }
  return all;
}

Affine2 read_view_box(std::string_view view_box, const Vec2d& size, std::string_view preserve_aspect_ratio) {
  const std::vector<double> box = number_list(view_box);
  if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0))
    throw InvalidValue("", "x, y and a width and height above 0", quoted(view_box));
  Vec2d scale{size.x / box[2], size.y / box[3]}, free{};
  if (preserve_aspect_ratio.empty()) preserve_aspect_ratio = "xMidYMid";
  if (preserve_aspect_ratio != "none") {
    const auto refuse = [&] {
      throw InvalidValue("preserveAspectRatio", "none, or xMidYMid or its like, and meet or slice",
                         quoted(preserve_aspect_ratio));
    };
    const std::string_view align = preserve_aspect_ratio.substr(0, 8),
                           rest = preserve_aspect_ratio.substr(align.size());
    const auto share = [&](std::string_view word) {
      if (word == "Mid") return 0.5;
      if (word != "Min" && word != "Max") refuse();
      return word == "Min" ? 0.0 : 1.0;
    };
    if (align.size() != 8 || align[0] != 'x' || align[4] != 'Y') refuse();
    if (!rest.empty() && rest != " meet" && rest != " slice") refuse();
    const double both = rest == " slice" ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    free = {share(align.substr(1, 3)) * (size.x - both * box[2]), share(align.substr(5, 3)) * (size.y - both * box[3])};
    scale = {both, both};
  }
  return {{scale.x, 0}, {0, scale.y}, {free.x - scale.x * box[0], free.y - scale.y * box[1]}};
}

std::vector<Subpath> read_path(std::string_view text, const Affine2& map, std::optional<double> tolerance) {
  const std::vector<Outline> outlines = PathReader(text).read();
  const double size = size_of(outlines, map);
  std::vector<Subpath> out;
  std::size_t count = 0;
  for (const Outline& outline : outlines) {
    if (outline.curves.empty()) continue;  // M alone draws nothing
    Subpath& path = out.emplace_back();
    path.closed = outline.closed;
    const Mapped mapped{map, tolerance.value_or(size / 1000), path.points, count};
    mapped.add(map(outline.start));
    Vec2d at = outline.start;
    for (const Curve& c : outline.curves) {
      if (c.kind != Curve::line && !(mapped.tolerance > 0))
        throw InvalidValue("", "curves that have a size", validate::number(mapped.tolerance));
      mapped.flatten(at, c);
      at = end_of(c);
    }
  }
  return out;
}

}  // namespace graze::io
