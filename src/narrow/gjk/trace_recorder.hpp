// The observer that writes the steps of GJK and EPA into a trace, in the frame of the iterations, A's.
#pragma once

#include "graze/trace.hpp"
#include "narrow/gjk/observer.hpp"
#include "narrow/gjk/polytope.hpp"
#include "narrow/gjk/simplex.hpp"

namespace graze {

class TraceRecorder {
 public:
  static constexpr bool observes = true;

  explicit TraceRecorder(Trace& trace) : trace_(&trace) {}

  void gjk_step(const Simplex& simplex, const Vec3d& direction, double lower, double upper) const {
    TraceGjk& step = trace_->gjk.emplace_back();
    for (std::size_t i = 0; i + 1 < simplex.size(); ++i) step.simplex.push_back(recorded(simplex.points[i]));
    step.direction = direction;
    step.found = recorded(simplex.points.back());
    step.lower = lower;
    step.upper = upper;
  }
  void expansion(const Vec3d& normal, double facet_depth, double found_depth, const SupportPoint& found,
                 const Polytope& polytope) const {
    trace_->epa.push_back({normal, facet_depth, found_depth, recorded(found), polytope.live_count()});
  }
  void final_polytope(const Polytope& polytope) const {
    for (const SupportPoint& p : polytope.vertices()) trace_->polytope.push_back(recorded(p));
    for (const Facet& f : polytope.facets())
      if (f.live) trace_->triangles.push_back({f.vertex[0], f.vertex[1], f.vertex[2]});
  }

 private:
  static TraceSupport recorded(const SupportPoint& p) { return {p.a, p.b}; }

  Trace* trace_;
};

}  // namespace graze
