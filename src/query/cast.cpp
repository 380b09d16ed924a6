#include "graze/cast.hpp"

#include <algorithm>
#include <cmath>

#include "cast/surface_seams.hpp"
#include "composite/composite.hpp"
#include "composite/merge_manifolds.hpp"
#include "composite/moving_leaves.hpp"
#include "composite/solid.hpp"
#include "query/explain_cast.hpp"

namespace graze {

namespace {

/// Roundings of a point of a path: those of a product, a sum, and the terms before.
constexpr double path_rounding = 8 * std::numeric_limits<double>::epsilon();

/// Rounding of poses and vertices to T before the query: half a unit in the last place for each of two.
template <class T>
constexpr double coordinate_rounding = static_cast<double>(std::numeric_limits<T>::epsilon());

/// Largest number of stretches of a long path. The path of turning composites is divided into stretches of about the
/// smaller body's size, so that each meets few pieces; more stretches than this cost more in tree searches than they
/// save.
constexpr double most_stretches = 64;

/// The part by which distances are to exceed the radii of bounding balls for these to count as clearly apart: ten
/// thousand times float's rounding.
constexpr double clearly_apart = 1 + 1e-3;

double finite(double size) { return size < std::numeric_limits<double>::infinity() ? size : 0; }

/// The query in double, in A's frame.
template <class T>
struct Asked {
  PairMotion motion;
  Piece<T> a, b;
  double duration, path, coordinates;
  Separating separating;

  Asked(const Shape<T>& shape_a, const Pose<T>& pose_a, const Velocity<T>& va, const Shape<T>& shape_b,
        const Pose<T>& pose_b, const Velocity<T>& vb, T until, const CastOptions& options)
      : a(shape_a), b(shape_b), duration(static_cast<double>(until)), separating(options.separating) {
    const Posed in_a = in_double(pose_a), in_b = in_double(pose_b);
    motion = {{in_a.rotation, converted<double>(va.angular)},
              {in_b.rotation, converted<double>(vb.angular)},
              in_b.translation - in_a.translation,
              converted<double>(vb.linear) - converted<double>(va.linear)};
    duration = least(duration, parted_by());
    path = length(motion.offset) + length(motion.velocity) * duration;
    coordinates = greatest(max_abs(in_a.translation), max_abs(in_b.translation)) + path;
  }

  /// A time after which nothing is met for the first time: the balls about the bodies' origins that hold them have
  /// passed each other, or the one has passed through the plane of the other or has left it. The tolerance grows with
  /// the path, which is not to be longer for a body that flies on for ever.
  double parted_by() const {
    const auto* plane_a = a.shape.template as<HalfSpace<T>>();
    const auto* plane_b = b.shape.template as<HalfSpace<T>>();
    double way = length(motion.offset), speed = length(motion.velocity);
    if (plane_a || plane_b) {
      const Turning& turning = plane_a ? motion.a : motion.b;
      if ((plane_a && plane_b) || !turning.none()) return std::numeric_limits<double>::infinity();
      const Vec3d normal = rotate(turning.start, Vec3d{0, 1, 0});
      way = std::abs(dot(motion.offset, normal)), speed = std::abs(dot(motion.velocity, normal));
    }
    const double reach = (plane_a ? a.radius : a.reach()) + (plane_b ? b.radius : b.reach());
    return speed > 0 ? clearly_apart * (way + reach) / speed : std::numeric_limits<double>::infinity();
  }

  /// The D of `graze/cast.hpp` for two pieces.
  double tolerance_of(const Piece<T>& piece_a, const Piece<T>& piece_b) const {
    const double ra = finite(piece_a.reach()), rb = finite(piece_b.reach());
    double size = ra > 0 && rb > 0 ? least(ra, rb) : greatest(ra, rb);
    for (const Piece<T>* piece : {&piece_a, &piece_b})
      if (piece->shape.template as<UserConvex<T>>()) size = greatest(size, piece->reach());
    return static_cast<double>(cast_tolerance<T>) * size + graze::tolerance<double> * greatest(ra, rb) +
           path_rounding * path;
  }

  /// Whether the bounding balls about the bodies' origins are clearly apart at the beginning.
  bool begins_far() const {
    return length(motion.offset) > clearly_apart * (a.reach() + b.reach()) + tolerance_of(a, b);
  }

  std::optional<Impact> of(const Piece<T>& piece_a, const Piece<T>& piece_b, const Interval& interval,
                           const SurfaceSeams* seams_a = nullptr, const SurfaceSeams* seams_b = nullptr) const {
    const double reach = greatest(finite(piece_a.reach()), finite(piece_b.reach()));
    const double slack = coordinate_rounding<T> * (coordinates + reach);
    const double near = tolerance_of(piece_a, piece_b), coarse = greatest(near, cast_tolerance<double> * reach);
    return time_of_impact(motion, piece_a, piece_b, interval, {near, coarse, slack, separating, seams_a, seams_b});
  }
};

struct PieceImpact {
  Impact impact;
  std::uint32_t piece_a, piece_b;
};

bool earlier(const PieceImpact& x, const PieceImpact& y) {
  if (x.impact.t != y.impact.t) return x.impact.t < y.impact.t;
  if (x.impact.distance != y.impact.distance) return x.impact.distance < y.impact.distance;
  return std::pair(x.piece_a, x.piece_b) < std::pair(y.piece_a, y.piece_b);
}

template <class T>
std::size_t stretches(const Asked<T>& asked) {
  const PairMotion& m = asked.motion;
  if (m.a.none() && m.b.none()) return 1;
  const double ra = finite(asked.a.reach()), rb = finite(asked.b.reach());
  const double path = asked.duration * (length(m.velocity) + length(m.a.angular) * ra + length(m.b.angular) * rb);
  const double step = 2 * (ra > 0 && rb > 0 ? least(ra, rb) : greatest(ra, rb));
  if (!(path > step)) return 1;
  return static_cast<std::size_t>(std::ceil(least(most_stretches, path / step)));
}

/// Whether a piece is a triangle of a solid mesh that is met from within, as by a body that leaves it, along a unit
/// vector of the world that leads away from it. A sliver, whose normal is mere rounding, counts as met from without.
template <class T>
bool met_from_within(const NumberedPiece<T>& numbered, const Quatd& rotation, const Vec3d& outward) {
  const auto* mesh = numbered.surface ? numbered.surface->template as<Mesh<T>>() : nullptr;
  const auto* triangle = mesh && mesh->solid() ? numbered.piece.shape.template as<Triangle<T>>() : nullptr;
  if (!triangle) return false;
  const Vec3d u = converted<double>(triangle->point(1) - triangle->point(0)),
              v = converted<double>(triangle->point(2) - triangle->point(0));
  const Vec3d normal = rotate(rotation, rotate(numbered.piece.local.rotation, cross(u, v)));
  return dot(normal, outward) < -static_cast<double>(same_normal<T>) * max_abs(u) * max_abs(v);
}

/// The seams of a piece that is a triangle of a surface, where sliding along it is asked for. None where a half-space
/// meets it, which is thin along no normal.
template <class T>
std::optional<SurfaceSeams> seams_met(const Asked<T>& asked, const NumberedPiece<T>& piece,
                                      const NumberedPiece<T>& other) {
  if (!piece.surface || asked.separating == Separating::hit || other.piece.shape.template as<HalfSpace<T>>()) return {};
  if (const auto* mesh = piece.surface->template as<Mesh<T>>()) return SurfaceSeams(mesh->data(), piece.in_surface);
  return SurfaceSeams(piece.surface->template as<HeightField<T>>()->data(), piece.in_surface);
}

/// Calls `found` for the first contact of every pair of pieces, in each stretch anew, omitting those later than
/// `until()` in stretches behind it. Where separating bodies are ignored, solid meshes are not met from within: a body
/// that starts inside, and has not got deeper, gets out.
template <class T, class Until, class Found>
void visit_impacts(const Asked<T>& asked, const Until& until, const Found& found) {
  const std::size_t count = stretches(asked);
  const double step = asked.duration / static_cast<double>(count), tolerance = asked.tolerance_of(asked.a, asked.b);
  for (std::size_t i = 0; i < count; ++i) {
    const Interval stretch{static_cast<double>(i) * step,
                           i + 1 == count ? asked.duration : static_cast<double>(i + 1) * step};
    if (i > 0 && until() < stretch.begin) return;
    const auto limit = [&] {
      if (until() >= stretch.end) return T(1);
      const T part = static_cast<T>((until() - stretch.begin) / (stretch.end - stretch.begin));
      return part + T(8) * std::numeric_limits<T>::epsilon();
    };
    auto meet = [&](const NumberedPiece<T>& a, const NumberedPiece<T>& b) {
      const Interval asked_for{stretch.begin, least(until(), stretch.end)};
      const auto seams_a = seams_met(asked, a, b), seams_b = seams_met(asked, b, a);
      const auto impact =
          asked.of(a.piece, b.piece, asked_for, seams_a ? &*seams_a : nullptr, seams_b ? &*seams_b : nullptr);
      if (!impact) return;
      if (asked.separating == Separating::ignored &&
          (met_from_within(a, asked.motion.a.at(impact->t), impact->normal) ||
           met_from_within(b, asked.motion.b.at(impact->t), -impact->normal)))
        return;
      found({*impact, a.number, b.number});
    };
    visit_moving_pairs<T>(asked.motion, {asked.a}, {asked.b}, stretch, tolerance, limit, meet);
  }
}

template <class T>
std::optional<PieceImpact> first_impact(const Asked<T>& asked) {
  if (asked.a.shape.convex() && asked.b.shape.convex()) {
    const auto impact = asked.of(asked.a, asked.b, {0, asked.duration});
    return impact ? std::optional(PieceImpact{*impact, 0, 0}) : std::nullopt;
  }
  std::optional<PieceImpact> first;
  const auto until = [&] { return first ? first->impact.t : asked.duration; };
  visit_impacts(asked, until, [&](const PieceImpact& impact) {
    if (!first || earlier(impact, *first)) first = impact;
  });
  return first;
}

/// The hit at t = 0 of a shape wholly inside a solid mesh, unless it is leaving and separating bodies are ignored.
template <class T>
std::optional<CastHit<T>> hit_inside(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a,
                                     const Shape<T>& b, const Pose<T>& pose_b, const Velocity<T>& velocity_b,
                                     const CastOptions& options) {
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  if (!inside) return {};
  const Distance<T>& d = inside->distance;
  const bool leaves = dot(velocity_b.linear - velocity_a.linear, d.normal) >= T(0);
  if (options.separating == Separating::ignored && leaves) return {};
  return CastHit<T>{T(0), (d.a + d.b) * T(0.5), d.normal, -d.distance, d.status, inside->piece_a, inside->piece_b};
}

/// The largest T that is no later.
template <class T>
T rounded_down(double t) {
  const T near = static_cast<T>(t);
  return static_cast<double>(near) > t ? std::nextafter(near, T(0)) : near;
}

template <class T>
CastHit<T> hit_of(const PieceImpact& found, const Pose<T>& pose_a, const Velocity<T>& velocity_a) {
  const Impact& impact = found.impact;
  const Vec3d origin = converted<double>(pose_a.translation) + converted<double>(velocity_a.linear) * impact.t;
  return {rounded_down<T>(impact.t),
          converted<T>(origin + (impact.a + impact.b) * 0.5),
          converted<T>(impact.normal),
          static_cast<T>(greatest(0.0, -impact.distance)),
          impact.status,
          found.piece_a,
          found.piece_b};
}

}  // namespace

template <class T>
Pose<T> pose_at(const Pose<T>& pose, const Velocity<T>& velocity, T t) {
  const Vec3<T> translation = pose.translation + velocity.linear * t;
  if (velocity.angular == Vec3<T>{}) return {translation, pose.rotation};
  const Turning turning{in_double(pose).rotation, converted<double>(velocity.angular)};
  return {translation, normalized(converted<T>(turning.at(static_cast<double>(t))))};
}

template <class T>
std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a,
                               const Shape<T>& b, const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration,
                               const CastOptions& options, Trace* trace) {
  if (trace) {
    const auto hit = cast(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, options);
    explain_cast<T>({a, pose_a, velocity_a}, {b, pose_b, velocity_b}, duration, hit, *trace);
    return hit;
  }
  const Asked<T> asked(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, options);
  const std::optional<PieceImpact> first = first_impact(asked);
  const bool touching = first && first->impact.t == 0,
             parts = a.template as<Compound<T>>() || b.template as<Compound<T>>();
  if ((has_solid_mesh(a) || has_solid_mesh(b)) && (!touching || parts)) {
    // A child of a compound that touches a solid from without may be deeper inside.
    const auto hit = hit_inside(a, pose_a, velocity_a, b, pose_b, velocity_b, options);
    if (hit && !(touching && hit->depth <= static_cast<T>(-first->impact.distance))) return hit;
  }
  // In float `overlap` rounds more than a cast does. Shapes that touch by it hit here too.
  if (std::is_same_v<T, float> && options.separating == Separating::hit && !(first && first->impact.t == 0) &&
      !asked.begins_far() && any_overlap<T>(a, pose_a, b, pose_b)) {
    const Distance<T> d = any_distance<T>(a, pose_a, b, pose_b);
    return CastHit<T>{T(0), (d.a + d.b) * T(0.5), d.normal, greatest(T(0), -d.distance), d.status};
  }
  return first ? std::optional(hit_of(*first, pose_a, velocity_a)) : std::nullopt;
}

template <class T>
void cast_all(const Shape<T>& a, const Pose<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
              const Pose<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::vector<CastHit<T>>& hits,
              const CastOptions& options) {
  const Asked<T> asked(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, options);
  std::vector<PieceImpact> impacts;
  const auto until = [&] { return asked.duration; };
  visit_impacts(asked, until, [&](const PieceImpact& impact) { impacts.push_back(impact); });
  // A pair is found again in every stretch in which it touches: only its first contact counts.
  const auto pair_of = [](const PieceImpact& i) { return std::pair(i.piece_a, i.piece_b); };
  std::sort(impacts.begin(), impacts.end(), [&](const PieceImpact& x, const PieceImpact& y) {
    return pair_of(x) != pair_of(y) ? pair_of(x) < pair_of(y) : earlier(x, y);
  });
  const auto again = [&](const PieceImpact& x, const PieceImpact& y) { return pair_of(x) == pair_of(y); };
  impacts.erase(std::unique(impacts.begin(), impacts.end(), again), impacts.end());
  std::sort(impacts.begin(), impacts.end(), earlier);
  if (has_solid_mesh(a) || has_solid_mesh(b))
    if (const auto hit = hit_inside(a, pose_a, velocity_a, b, pose_b, velocity_b, options)) hits.push_back(*hit);
  for (const PieceImpact& impact : impacts) hits.push_back(hit_of(impact, pose_a, velocity_a));
}

template Pose<float> pose_at(const Pose<float>&, const Velocity<float>&, float);
template std::optional<CastHit<float>> cast(const Shape<float>&, const Pose<float>&, const Velocity<float>&,
                                            const Shape<float>&, const Pose<float>&, const Velocity<float>&, float,
                                            const CastOptions&, Trace*);
template void cast_all(const Shape<float>&, const Pose<float>&, const Velocity<float>&, const Shape<float>&,
                       const Pose<float>&, const Velocity<float>&, float, std::vector<CastHit<float>>&,
                       const CastOptions&);

template Pose<double> pose_at(const Pose<double>&, const Velocity<double>&, double);
template std::optional<CastHit<double>> cast(const Shape<double>&, const Pose<double>&, const Velocity<double>&,
                                             const Shape<double>&, const Pose<double>&, const Velocity<double>&, double,
                                             const CastOptions&, Trace*);
template void cast_all(const Shape<double>&, const Pose<double>&, const Velocity<double>&, const Shape<double>&,
                       const Pose<double>&, const Velocity<double>&, double, std::vector<CastHit<double>>&,
                       const CastOptions&);

}  // namespace graze
