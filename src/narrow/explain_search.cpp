#include "narrow/explain_search.hpp"

#include "narrow/general.hpp"
#include "narrow/general_search.hpp"
#include "narrow/gjk/epa.hpp"
#include "narrow/gjk/trace_recorder.hpp"

namespace graze {

namespace {

void to_world(Trace& trace, const Posed& pose_a) {
  const auto point = [&](TraceSupport& p) { p = {transform(pose_a, p.a), transform(pose_a, p.b)}; };
  const auto direction = [&](Vec3d& d) { d = rotate(pose_a.rotation, d); };
  for (TraceGjk& step : trace.gjk) {
    for (TraceSupport& p : step.simplex) point(p);
    direction(step.direction);
    point(step.found);
  }
  for (TraceEpa& step : trace.epa) {
    direction(step.normal);
    point(step.found);
  }
  for (TraceSupport& p : trace.polytope) point(p);
}

}  // namespace

template <class T>
void explain_distance_search(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             Trace& trace) {
  const Posed b_in_a = relative_in_double(pose_a, pose_b);
  const double noise = noise_of(a, b, b_in_a.translation);
  const TraceRecorder recorder(trace);
  with_distance_difference(a, b, b_in_a, [&](auto& difference) {
    const double size = difference.size();
    const GjkResult g =
        search(difference, distance_goals(size, noise, std::numeric_limits<double>::infinity()), recorder);
    if (g.end != GjkEnd::touching && g.tells_normal()) {
      trace.method = "gjk";
      trace.reason = "the cores are apart: the nearest point of their difference is not the origin";
    } else {
      trace.method = "gjk + epa";
      trace.reason = "the cores overlap: the facet of their difference nearest to the origin gives the depth";
      epa(difference, g.simplex, depth_goal * size + noise, recorder);
    }
  });
  to_world(trace, in_double(pose_a));
}

template <class T>
void explain_overlap_search(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            Trace& trace) {
  const Posed b_in_a = relative_in_double(pose_a, pose_b);
  const double noise = noise_of(a, b, b_in_a.translation);
  const double reach = static_cast<double>(rounding_radius(a)) + static_cast<double>(rounding_radius(b));
  trace.method = "gjk";
  with_overlap_difference(a, b, b_in_a, [&](auto& difference) {
    search(difference, overlap_goals(difference.size(), noise, reach), TraceRecorder(trace));
  });
  to_world(trace, in_double(pose_a));
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void explain_distance_search(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace&);     \
  template void explain_overlap_search(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
