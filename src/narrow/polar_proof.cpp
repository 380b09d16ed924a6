#include "narrow/polar_proof.hpp"

namespace graze {

PolarProof::Bounds PolarProof::bounds(const Tangent& a, const Tangent& b) const {
  const Sector single = sector(a, b), twice = sector(doubled(a), doubled(b));
  Bounds r;
  if (cap_ > 0) r.slope = greatest(0.0, cap_ + single.least(cap_slope_));
  for (const Crease& c : creases_) r.slope += single.slope_over(c);
  for (const Segment& s : segments_) r.turns.push_back({s.along, single.most(s.axis), s.half});
  for (const Round& round : rounds_) {
    // A form is its mean and a linear term in the doubled angle.
    const TangentForm& f = round.across;
    const double mean = (f.uu + f.vv) * 0.5, point = single.most(round.point);
    const Tangent swing{(f.uu - f.vv) * 0.5, f.uv};
    r.bends.push_back({round.extent, point, point / round.extent, greatest(0.0, mean + twice.least(swing)),
                       mean + twice.most(swing)});
  }
  return r;
}

bool PolarProof::holds_between(const Bounds& bounds, double from, double to, int left, double& doubtful) const {
  double slope = bounds.slope;
  if (from > 0)
    for (const Bounds::Turn& t : bounds.turns)
      slope += t.half * greatest(0.0, t.along * (from - 1 / from) - 2 * t.axis);
  if (slope >= to * (depth_ - least_bend_)) return true;
  double bend = 0;
  for (const Bounds::Bend& b : bounds.bends) {
    // The most of X, which is concave in s.
    const double top = least(to, greatest(from, b.turns_at));
    const double x = b.extent * (1 - top * top) + 2 * top * b.point, y = 4 * to * to * b.most_across;
    const double root = std::sqrt(x * x + y), below = x > 0 ? root + x : y / (root - x);
    const double bends = below > 0 ? 2 * b.least_across / below : 0;
    // Beyond the face of a disc, sqrt(X^2 + Y^2) - X is no less than -2 X.
    if (-x > bends * to * to)
      slope -= x / to;
    else
      bend += bends;
  }
  if (slope >= to * (depth_ - bend)) return true;
  if (left == 0) {
    doubtful = (from + to) * 0.5;
    return false;
  }
  const double middle = (from + to) * 0.5;
  return holds_between(bounds, from, middle, left - 1, doubtful) &&
         holds_between(bounds, middle, to, left - 1, doubtful);
}

bool PolarProof::holds_beyond(const Bounds& bounds, double from) const {
  double bend = 0;
  const double turned = 1 - 1 / (from * from);
  for (const Bounds::Bend& b : bounds.bends)
    bend += greatest(0.0, b.extent * turned - 2 * greatest(0.0, b.point) / from);
  for (const Bounds::Turn& t : bounds.turns)
    bend += t.half * greatest(0.0, t.along * turned - 2 * greatest(0.0, t.axis) / from);
  return bend >= depth_;
}

bool PolarProof::holds_between(const Tangent& a, const Tangent& b, double& doubtful) const {
  constexpr double steps[] = {0, 0.5, 2, 8};
  const Bounds in = bounds(a, b);
  doubtful = 2 * steps[3];
  bool all = holds_beyond(in, steps[3]);
  for (std::size_t i = 0; i < 3 && all; ++i) all = holds_between(in, steps[i], steps[i + 1], halvings, doubtful);
  return all;
}

}  // namespace graze
