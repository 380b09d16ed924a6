#include "narrow/depth/newton_depth.hpp"

#include <array>

#include "narrow/depth/depth_certificate.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Newton's method doubles its digits with each step; a descent that needs more steps is left to the general path.
constexpr int descent_steps = 16;
/// Number of descents: one that ends without proof begins again where less overlap may lie.
constexpr int descents = 3;
/// Steps along the sphere, as tangents of their angles: the longest, and one whose square is negligible.
constexpr double longest_step = 0.7, last_step = 1e-8;
/// Sine of the angle to a disc's normal within which the curvature is no guide to what lies beyond the face.
constexpr double beside_disc = 1e-3;
/// Squared sine of the angle to a disc's axis below which an offset gives no direction across the axis to start with.
constexpr double along_axis = 1e-3;
/// Creases at an angle of a smaller sine count as one, which is left to the general path.
constexpr double least_angle = 1e-3;
// The remaining constants are relative to the size of the larger core. A depth is a sum of some ten terms of up to
// that, with a rounding of some 1e-15; `tolerance<double>` is 1e-9.
/// Slack of an inscribed ball that proves a depth: a hundred times that rounding.
constexpr double inside_slack = 1e-13;
/// Least decrease of the overlap for a step not to be halved: ten times as much, since a step compares two values.
constexpr double rise = 1e-12;
/// Largest remainder of the gradient at the end, the offset of the deepest points across the normal: a hundredth of the
/// tolerance.
constexpr double unbalanced = 1e-11;

/// A unit vector without components far below its rounding.
Vec3d cleaned(const Vec3d& v) {
  Vec3d n = unit(v);
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(n[i]) < negligible) n[i] = 0;
  return n;
}

class Descent {
 public:
  Descent(const SummedCore& a, const SummedCore& b, const Posed& b_in_a)
      : side_{SumSide(a), SumSide(b)}, turn_(rotation_matrix(b_in_a.rotation)) {
    way_ = b_in_a.translation + turn_ * b.center - a.center;
    for (std::size_t i = 0; i < 3; ++i) {
      axis_[i] = Mat3d::identity().row[i];
      axis_[3 + i] = turn_.column(i);
      half_[i] = a.half[i];
      half_[3 + i] = b.half[i];
    }
    for (std::size_t k = 0; k < 6; ++k)
      if (half_[k] > 0) segments_.push_back(static_cast<std::uint8_t>(k));
    size_ = greatest(max_abs(a.half) + max_abs(a.radii), max_abs(b.half) + max_abs(b.radii));
  }

  std::optional<NewtonDepth> run(double limit) {
    least_seen_ = start(limit);
    if (least_seen_ < -limit) return NewtonDepth{n_, least_seen_, {}, {}, least_seen_};
    std::optional<NewtonDepth> found;
    for (int i = 0; i < descents; ++i) {
      doubtful_ = {};
      found = descend(limit);
      if (doubtful_ == Vec3d{}) break;
      n_ = doubtful_;
      active_ = {none, none};
      cap_ = none;
    }
    return found;
  }

 private:
  enum class Step { moved, arrived, failed };
  static constexpr int none = -1;

  /// Descends to a least overlap, or to one that separates by more than `limit`.
  std::optional<NewtonDepth> descend(double limit) {
    take_ends();
    evaluate();
    for (int i = 0; i < descent_steps; ++i) {
      const double before = depth_;
      const Vec3d from = n_;
      const std::array<int, 2> kept = active_;
      switch (step()) {
      case Step::failed: return std::nullopt;
      case Step::arrived:
        if (depth_ > least_seen_ + rise * size_) return std::nullopt;
        return finished();
      case Step::moved: break;
      }
      evaluate();
      if (depth_ < -limit) {
        const double measured = overlap_along(n_);
        if (measured < -limit) return NewtonDepth{n_, measured, {}, {}, measured};
      }
      for (int k = 0; k < 4 && depth_ > before + rise * size_; ++k) {
        n_ = cleaned(n_ + from);
        if (kept[1] == none && (kept[0] == none || active_[1] != none)) active_ = kept;
        take_ends();
        evaluate();
      }
    }
    return std::nullopt;
  }

  Vec3d local(std::size_t side, const Vec3d& v) const { return side == 0 ? v : transposed_times(turn_, v); }

  bool active(std::size_t k) const { return static_cast<int>(k) == active_[0] || static_cast<int>(k) == active_[1]; }

  /// Takes the ends of the segments that n points to, except for those perpendicular to it.
  void take_ends() {
    for (const std::size_t k : segments_) sign_[k] = dot(axis_[k], n_) < 0 ? -1.0 : 1.0;
    keep_ends();
  }
  void keep_ends() {
    for (const std::size_t k : segments_) ends_[k / 3][k % 3] = active(k) ? 0 : sign_[k] * half_[k];
  }

  /// Computes the gradient and the depth at n, without the contributions of the active creases.
  void evaluate() {
    at_ = {n_, transposed_times(turn_, n_)};
    for (std::size_t s = 0; s < 2; ++s) {
      point_[s] = cap_ == static_cast<int>(s) ? Vec3d{} : side_[s].round_point(at_[s]);
      part_[s] = point_[s] + ends_[s];
    }
    gradient_ = part_[0] + turn_ * part_[1] - way_;
    depth_ = dot(gradient_, n_);
  }

  /// The overlap of the cores along a unit vector, regardless of active creases.
  double overlap_along(const Vec3d& n) const {
    return side_[0].extent(n) + side_[1].extent(transposed_times(turn_, n)) - dot(way_, n);
  }

  /// Starts from the best of a few directions: the offset between the centres, the axes of the boxes, and the offset
  /// without its part along a cylinder's axis, where its side is met. Returns the overlap there, as soon as one
  /// separates by more than `limit`.
  double start(double limit) {
    n_ = cleaned(way_);
    double best = overlap_along(n_);
    const Vec3d way = n_;
    int face = none;
    // An axis equal to the offset up to rounding is preferred: only for the axis is the face known that it is normal
    // to.
    double slack = rise * size_;
    const auto better = [&](const Vec3d& n) {
      const double found = overlap_along(n);
      if (!(found < best + slack)) return false;
      slack = 0;
      best = found;
      n_ = n;
      return true;
    };
    for (const std::size_t k : segments_) {
      const double along = dot(axis_[k], way);
      if (best < -limit) return best;
      if (better(along < 0 ? -axis_[k] : axis_[k])) {
        face = static_cast<int>(k);
        active_[0] = none;
      }
      if (best < -limit) return best;
      if (side_[k / 3].disc && along * along < 1 - along_axis && better(cleaned(way - axis_[k] * along))) {
        face = none;
        active_[0] = static_cast<int>(k);
      }
    }
    if (face != none) look_along(static_cast<std::size_t>(face));
    return best;
  }
  /// Activates the feature normal to an axis: a disc, or the face that the other two axes span.
  void look_along(std::size_t axis) {
    const std::size_t s = axis / 3, i = axis % 3;
    if (side_[s].disc) {
      cap_ = static_cast<int>(s);
      return;
    }
    std::size_t count = 0;
    for (const std::size_t k : {3 * s + (i + 1) % 3, 3 * s + (i + 2) % 3})
      if (half_[k] > 0) active_[count++] = static_cast<int>(k);
  }

  Step step() {
    const Vec3d g = gradient_ - n_ * depth_;
    if (cap_ != none) {
      const double slope = length(g), radius = side_[static_cast<std::size_t>(cap_)].radii.x;
      if (slope <= radius) return Step::arrived;
      cap_ = none;
      n_ = cleaned(n_ - g * (longest_step / slope));
      take_ends();
      return Step::moved;
    }
    if (active_[1] != none) return corner_step(g);
    if (active_[0] != none) return crease_step(g);
    return smooth_step(g);
  }

  /// The part of the way from n to n + way before the next crease, whose number goes to `crease`.
  double until_crease(const Vec3d& way, int& crease) const {
    double first = 1;
    crease = none;
    const std::array<Vec3d, 2> ways{way, transposed_times(turn_, way)};
    for (const std::size_t k : segments_) {
      if (active(k)) continue;
      const double from = at_[k / 3][k % 3] * sign_[k], change = ways[k / 3][k % 3] * sign_[k];
      if (!(from + change * first < 0)) continue;
      first = from > 0 ? -from / change : 0;
      crease = static_cast<int>(k);
    }
    return first;
  }

  Step smooth_step(const Vec3d& g) {
    tangents_at(n_, u_, v_);
    TangentForm form;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!side_[s].round) continue;
      if (side_[s].disc && !(dot(point_[s], at_[s]) > beside_disc * side_[s].radii.x)) return Step::failed;
      side_[s].add_curvature(at_[s], point_[s], local(s, u_), local(s, v_), form);
    }
    form.uu -= depth_;
    form.vv -= depth_;
    const double gu = dot(g, u_), gv = dot(g, v_);
    const auto [x, y] = form.downhill(gu, gv);
    Vec3d way = u_ * x + v_ * y;
    const double longest = length(way);
    if (longest > longest_step) way *= longest_step / longest;
    int crease;
    double t = until_crease(way, crease);
    if (crease != none && !(t > 0)) {
      // Straight down from a crease just left leads away from it, which Newton's step may not.
      way = g * (-least(longest_step, longest) / length(g));
      t = until_crease(way, crease);
    }
    const double length_squared = dot(way, way);
    if (crease == none) {
      n_ = cleaned(n_ + way);
      if (length_squared > last_step * last_step) return Step::moved;
      evaluate();
      return Step::arrived;
    }
    n_ = n_ + way * t;
    const Vec3d& e = axis_[static_cast<std::size_t>(crease)];
    n_ = cleaned(n_ - e * dot(n_, e));
    active_[0] = crease;
    keep_ends();
    return Step::moved;
  }

  void leave(std::size_t which, double push) {
    sign_[static_cast<std::size_t>(active_[which])] = push > 0 ? -1 : 1;
    if (which == 0) active_[0] = active_[1];
    active_[1] = none;
    keep_ends();
  }

  Step crease_step(const Vec3d& g) {
    const auto k = static_cast<std::size_t>(active_[0]);
    const double push = dot(g, axis_[k]);
    if (std::abs(push) > half_[k]) {
      leave(0, push);
      return Step::moved;
    }
    const Vec3d along = cross(axis_[k], n_);
    double bend = -depth_;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!side_[s].round) continue;
      if (side_[s].disc && !(dot(point_[s], at_[s]) > beside_disc * side_[s].radii.x)) return Step::failed;
      bend += side_[s].curvature(at_[s], point_[s], local(s, along));
    }
    const double slope = dot(g, along);
    double far = bend > 0 ? -slope / bend : slope > 0 ? -longest_step : longest_step;
    far = least(longest_step, greatest(-longest_step, far));
    int crease;
    until_crease(along * far, crease);
    if (crease == none) {
      n_ = cleaned(n_ + along * far);
      if (std::abs(far) > last_step) return Step::moved;
      evaluate();
      return Step::arrived;
    }
    const Vec3d between = cross(axis_[k], axis_[static_cast<std::size_t>(crease)]);
    if (!(dot(between, between) > least_angle * least_angle)) return Step::failed;
    const Vec3d corner = unit(between);
    n_ = dot(corner, n_) < 0 ? -corner : corner;
    active_[1] = crease;
    keep_ends();
    return Step::moved;
  }

  bool corner_pushes(const Vec3d& g, double (&push)[2]) const {
    const Vec3d &e = axis_[static_cast<std::size_t>(active_[0])], &f = axis_[static_cast<std::size_t>(active_[1])];
    const double ef = dot(e, f), det = 1 - ef * ef;
    if (!(det > least_angle * least_angle)) return false;
    const double ge = dot(g, e), gf = dot(g, f);
    push[0] = (ge - ef * gf) / det;
    push[1] = (gf - ef * ge) / det;
    return true;
  }

  Step corner_step(const Vec3d& g) {
    double push[2] = {};
    if (!corner_pushes(g, push)) return Step::failed;
    double most = 0;
    int which = none;
    for (int i = 0; i < 2; ++i) {
      const double over = std::abs(push[i]) - half_[static_cast<std::size_t>(active_[i])];
      if (over > most) {
        most = over;
        which = i;
      }
    }
    if (which == none) return Step::arrived;
    leave(static_cast<std::size_t>(which), push[which]);
    return Step::moved;
  }

  std::optional<NewtonDepth> finished() {
    // The gradient is balanced by a place on the face that n is normal to.
    Vec3d g = gradient_ - n_ * depth_;
    slope_ = g;
    push_[0] = push_[1] = 0;
    if (cap_ != none) {
      part_[static_cast<std::size_t>(cap_)] -= local(static_cast<std::size_t>(cap_), g);
      g = {};
    } else if (active_[1] != none) {
      corner_pushes(g, push_);
    } else if (active_[0] != none) {
      push_[0] = dot(g, axis_[static_cast<std::size_t>(active_[0])]);
    }
    for (std::size_t i = 0; i < 2 && active_[i] != none; ++i) {
      const auto k = static_cast<std::size_t>(active_[i]);
      if (!(std::abs(push_[i]) <= half_[k])) return std::nullopt;  // the last step met another crease
      part_[k / 3][k % 3] -= push_[i];
      g -= axis_[k] * push_[i];
    }
    if (!(length(g) <= unbalanced * size_) || !(overlap_along(n_) <= depth_ + rise * size_)) return std::nullopt;
    const Vec3d from_a = part_[0], from_b = way_ - turn_ * part_[1];
    NewtonDepth r{n_, depth_, from_a + side_[0].center, from_b + side_[0].center, 0};
    r.lower = depth_ < 0 ? -length(from_b - from_a) : proven(from_a, from_b, length(g));
    return r;
  }

  /// Cylinders and segments with parallel axes add up to a cylinder, whose depth at the offset is theirs. Minus
  /// infinity for others.
  double inside_of_sum() const {
    for (const SumSide& side : side_)
      if ((side.round && !side.disc) || side.half.x > 0 || side.half.z > 0)
        return -std::numeric_limits<double>::infinity();
    const Vec3d axis = turn_.column(1);
    const double lean = std::sqrt(axis.x * axis.x + axis.z * axis.z), radius = side_[0].radii.x + side_[1].radii.x;
    if (!(lean <= inside_slack)) return -std::numeric_limits<double>::infinity();
    const SumSide sum({{}, {0, side_[0].half.y + side_[1].half.y, 0}, {radius, 0, radius}});
    return sum.inside(way_) - 2 * lean * size_;  // a core of up to `size_` from its axis' ends leans by so much
  }

  /// A proven lower bound of the depth, given the deepest points and the remainder of the gradient.
  double proven(const Vec3d& from_a, const Vec3d& from_b, double rest) {
    const double inside =
        greatest(inside_of_sum(), greatest(side_[0].inside(from_b), side_[1].inside(local(1, from_a - way_))));
    if (inside >= depth_ - inside_slack * size_) return inside;
    tangents_at(n_, u_, v_);
    const std::array<Vec3d, 2> us{u_, local(1, u_)}, vs{v_, local(1, v_)};
    TangentForm radius;
    for (std::size_t s = 0; s < 2; ++s)
      if (side_[s].round && cap_ != static_cast<int>(s)) radius.add(side_[s].least_radius(us[s], vs[s]));
    const double least_radius = radius.least_eigenvalue();
    if (least_radius >= depth_) return depth_ - rest;

    PolarTerms terms{depth_, least_radius};
    const auto tangent = [&](const Vec3d& v) { return PolarTangent{dot(v, u_), dot(v, v_)}; };
    for (std::size_t s = 0; s < 2; ++s) {
      if (!side_[s].round || cap_ == static_cast<int>(s)) continue;
      const Vec3d& p = point_[s];
      const PolarTangent at{dot(p, us[s]), dot(p, vs[s])};
      terms.rounds.push_back({dot(p, at_[s]), at, side_[s].across(us[s], vs[s], at.u, at.v)});
    }
    if (cap_ != none) {
      terms.cap = side_[static_cast<std::size_t>(cap_)].radii.x;
      terms.cap_slope = tangent(slope_);
    }
    for (const std::size_t k : segments_) {
      if (active(k)) {
        const std::size_t i = static_cast<int>(k) == active_[0] ? 0 : 1;
        terms.creases.push_back({tangent(axis_[k]), half_[k] + push_[i], half_[k] - push_[i]});
      } else {
        // Rounding may leave the sign of an earlier direction.
        const double along = greatest(0.0, dot(axis_[k], n_) * sign_[k]);
        terms.segments.push_back({tangent(axis_[k] * sign_[k]), along, half_[k]});
      }
    }
    PolarDoubt doubt;
    if (no_less_around(terms, doubt)) return depth_ - rest;
    const auto& [t, s] = doubt;
    if (s == 0) return inside;
    doubtful_ = cleaned(n_ * (1 - s * s) + (u_ * t.u + v_ * t.v) * (2 * s));
    least_seen_ = least(overlap_along(doubtful_), depth_ - 2 * rise * size_);
    return inside;
  }

  std::array<SumSide, 2> side_;
  Mat3d turn_;
  Vec3d way_;
  std::array<Vec3d, 6> axis_;
  std::array<double, 6> half_, sign_{};
  FixedVector<std::uint8_t, 6> segments_;  ///< the axes with a length
  std::array<Vec3d, 2> ends_{};
  double size_;

  Vec3d n_, gradient_, u_, v_, slope_;
  double push_[2] = {};
  double least_seen_ = 0;
  Vec3d doubtful_;  ///< a direction that may have less overlap, or zero
  double depth_ = 0;
  std::array<Vec3d, 2> at_, point_, part_;
  std::array<int, 2> active_{none, none};
  int cap_ = none;
};

}  // namespace

[[gnu::flatten]] std::optional<NewtonDepth> newton_depth(const SummedCore& a, const SummedCore& b, const Posed& b_in_a,
                                                         double limit) {
  return Descent(a, b, b_in_a).run(limit);
}

}  // namespace graze::GRAZE_ISA
