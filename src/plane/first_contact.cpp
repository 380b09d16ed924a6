#include "plane/first_contact.hpp"

#include "plane/straight_contact.hpp"

namespace graze::plane {

namespace {

/// The most steps along separating lines. Each closes what the line leaves of the gap: flat sides take a few, round
/// ones converge quadratically unless they pass each other.
constexpr int most_steps = 100;

}  // namespace

template <class T>
bool surely_apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double near) {
  const double radius = a.radius + b.radius + near;
  bool apart = a.count == 1 && b.count == 1 &&
               length_squared(a.vertex(0) - transform(b_in_a, b.vertex(0))) * (1 - 0x1p-40) > radius * radius;
  for_each_difference_edge(a, b, b_in_a,
                           [&](const DifferenceEdge& e) { apart = apart || surely_above(e.start, e.edge, radius); });
  return apart;
}

template <class T>
std::optional<FirstContact> first_contact(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                          const Vec2d& velocity, double duration, double size, double near,
                                          std::vector<TraceStep>* steps) {
  if (a.kind == CoreKind::polygon && b.kind == CoreKind::polygon)
    return straight_contact(a, b, b_in_a, velocity, duration, size);
  if (!(length(velocity) > 0)) return {};
  FirstContact out;
  const auto moved = [&](double t) { return Pose2d{b_in_a.translation + velocity * t, b_in_a.rotation}; };
  for (int step = 0; step < most_steps; ++step) {
    const Nearest found = nearest(a, b, moved(out.t), size);
    const double gap = found.distance - found.error - a.radius - b.radius, closing = -dot(velocity, found.normal);
    out.normal = found.normal;
    out.point = found.a.point + found.normal * a.radius;
    if (steps) steps->push_back({out.t, gap, {found.normal.x, found.normal.y, 0}});
    if (gap <= near && (closing > 0 || gap <= 0)) return out;
    if (!(closing > 0)) return {};
    // Up to half of the gap that counts as contact, so that the last step does not fall short by rounding.
    const double later = out.t + (gap - near / 2) / closing;
    if (later == never) return {};
    if (!(later <= duration)) {
      // The way ends before this step does: at its end the cores may touch all the same.
      const Nearest last = nearest(a, b, moved(duration), size);
      if (!(last.distance - a.radius - b.radius <= 0)) return {};
      out.t = duration;
      return out;
    }
    if (later == out.t) return out;
    out.t = later;
  }
  out.status = Status::bounded;
  return out;
}

template bool surely_apart(const Core<float>&, const Core<float>&, const Pose2d&, double);
template bool surely_apart(const Core<double>&, const Core<double>&, const Pose2d&, double);
template std::optional<FirstContact> first_contact(const Core<float>&, const Core<float>&, const Pose2d&, const Vec2d&,
                                                   double, double, double, std::vector<TraceStep>*);
template std::optional<FirstContact> first_contact(const Core<double>&, const Core<double>&, const Pose2d&,
                                                   const Vec2d&, double, double, double, std::vector<TraceStep>*);

}  // namespace graze::plane
