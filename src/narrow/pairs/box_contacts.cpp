#include "narrow/pairs/box_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/features.hpp"
#include "narrow/fixed_vector.hpp"
#include "narrow/outline.hpp"

namespace graze {

namespace {

/// Each of four cuts adds a corner; rounding may make a sliver that is cut twice.
template <class T>
using Corners = FixedVector<FlatPoint<T>, 16>;

/// One axis of a box is `main`; the two others follow it, so that the three are right-handed.
struct Axes {
  std::size_t main, u, v;
  explicit Axes(std::size_t axis) : main(axis), u((axis + 1) % 3), v((axis + 2) % 3) {}
};

template <class T>
std::size_t longest(const Vec3<T>& v) {
  const Vec3<T> a = abs(v);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// Keeps what lies at most `limit` along one axis, X or Y, times `sign` (Sutherland, Hodgman 1974, "Reentrant polygon
/// clipping").
template <class T>
void cut(Corners<T>& corners, T FlatPoint<T>::*along, T FlatPoint<T>::*across, T sign, T limit) {
  const std::size_t n = corners.size();
  T room[Corners<T>::capacity()];
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    room[i] = limit - corners[i].*along * sign;
    all &= room[i] >= T(0);
  }
  if (all) return;
  const Corners<T> before = corners;
  corners.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 == n ? 0 : i + 1;
    const bool here = room[i] >= T(0);
    if (here && !corners.full()) corners.push_back(before[i]);
    if (here == (room[next] >= T(0)) || corners.full()) continue;
    const T t = std::clamp(room[i] / (room[i] - room[next]), T(0), T(1));
    FlatPoint<T> crossing;
    crossing.*along = limit * sign;
    crossing.*across = before[i].*across + (before[next].*across - before[i].*across) * t;
    corners.push_back(crossing);
  }
}

/// A face of a box by the sides of its other two axes at which a place lies: -1, 0 within, or 1.
std::uint32_t face_part(const Axes& axes, bool positive, int at_u, int at_v) {
  const auto bit = [](std::size_t axis, bool set) { return static_cast<std::uint32_t>(set) << axis; };
  const std::uint32_t base = bit(axes.main, positive) | bit(axes.u, at_u > 0) | bit(axes.v, at_v > 0);
  if (at_u != 0 && at_v != 0) return vertex_feature(base);
  if (at_u != 0) return edge_feature(base, base | bit(axes.v, true));
  if (at_v != 0) return edge_feature(base, base | bit(axes.u, true));
  return face_feature(static_cast<std::uint32_t>(2 * axes.main) + (positive ? 1 : 0));
}

template <class T>
int side_of(T coordinate, T near_side) {
  return coordinate >= near_side ? 1 : coordinate <= -near_side ? -1 : 0;
}

/// Two boxes seen from the one whose face is clipped against, along the normal.
template <class T>
class LaidOver {
 public:
  /// `p` and `normal` as seen from the clipping box.
  LaidOver(const BoxPair<T>& p, const Vec3<T>& normal, std::size_t face)
      : clip_(face),
        other_(longest(transposed_times(p.rotation, normal))),
        half_{p.half_a[clip_.u], p.half_a[clip_.v]} {
    clip_positive_ = normal[face] >= T(0);
    other_positive_ = !(dot(p.rotation.column(other_.main), normal) >= T(0));
    height_ = clip_positive_ ? p.half_a[face] : -p.half_a[face];
    const T reach = p.half_b[other_.main];
    const Vec3<T> center = p.translation + p.rotation.column(other_.main) * (other_positive_ ? reach : -reach),
                  u = p.rotation.column(other_.u) * p.half_b[other_.u],
                  v = p.rotation.column(other_.v) * p.half_b[other_.v];
    const T steep = T(1) / normal[face];
    const auto flat = [&](const Vec3<T>& q, T apart) {
      return FlatPoint<T>{q[clip_.u] - normal[clip_.u] * apart, q[clip_.v] - normal[clip_.v] * apart};
    };
    apart_ = (center[face] - height_) * steep;
    rise_u_ = u[face] * steep;
    rise_v_ = v[face] * steep;
    center_ = flat(center, apart_);
    u_ = flat(u, rise_u_);
    v_ = flat(v, rise_v_);
    area_ = u_.x * v_.y - u_.y * v_.x;
    const T length_u = u_.x * u_.x + u_.y * u_.y, length_v = v_.x * v_.x + v_.y * v_.y;
    near_ =
        T(2 * same_place) * std::sqrt(least(least(half_.x * half_.x, half_.y * half_.y), least(length_u, length_v)));
    near_u_ = T(1) - near_ * std::sqrt(length_v) / std::abs(area_);
    near_v_ = T(1) - near_ * std::sqrt(length_u) / std::abs(area_);
  }

  const Axes& clip_axes() const { return clip_; }
  T height() const { return height_; }
  T near() const { return near_; }
  /// False where the other face is seen from the side, which only rounding can bring about.
  bool regular() const { return std::abs(area_) > T(0); }

  void corners(Corners<T>& corners) const {
    for (const auto& [s, t] : {std::pair{T(-1), T(-1)}, {T(1), T(-1)}, {T(1), T(1)}, {T(-1), T(1)}})
      corners.push_back({center_.x + u_.x * s + v_.x * t, center_.y + u_.y * s + v_.y * t});
    cut(corners, &FlatPoint<T>::x, &FlatPoint<T>::y, T(1), half_.x);
    cut(corners, &FlatPoint<T>::x, &FlatPoint<T>::y, T(-1), half_.x);
    cut(corners, &FlatPoint<T>::y, &FlatPoint<T>::x, T(1), half_.y);
    cut(corners, &FlatPoint<T>::y, &FlatPoint<T>::x, T(-1), half_.y);
  }

  /// A place in the coordinates of the other face, where its corners are at 1 and -1.
  FlatPoint<T> on_other(const FlatPoint<T>& p) const {
    const T x = p.x - center_.x, y = p.y - center_.y;
    return {(x * v_.y - y * v_.x) / area_, (u_.x * y - u_.y * x) / area_};
  }
  T apart(const FlatPoint<T>& p) const {
    const FlatPoint<T> q = on_other(p);
    return apart_ + q.x * rise_u_ + q.y * rise_v_;
  }
  std::uint32_t clip_feature(const FlatPoint<T>& p) const {
    return face_part(clip_, clip_positive_, side_of(p.x, half_.x - near_), side_of(p.y, half_.y - near_));
  }
  std::uint32_t other_feature(const FlatPoint<T>& p) const {
    const FlatPoint<T> q = on_other(p);
    return face_part(other_, other_positive_, side_of(q.x, near_u_), side_of(q.y, near_v_));
  }

 private:
  Axes clip_, other_;
  FlatPoint<T> half_;
  bool clip_positive_, other_positive_;
  T height_;                     ///< of the clipping face above its box's centre
  FlatPoint<T> center_, u_, v_;  ///< the other face, seen along the normal
  T apart_, rise_u_, rise_v_;    ///< how far it is away at its centre, and how that changes along its edges
  T area_;                       ///< a quarter of it, with its sign
  T near_, near_u_, near_v_;
};

}  // namespace

template <class T>
Vec3<T> box_normal(const BoxPair<T>& p, int axis) {
  Vec3<T> n;
  if (axis < 3) {
    n = detail::unit_axis<T>(static_cast<std::size_t>(axis));
  } else if (axis < 6) {
    n = p.rotation.column(static_cast<std::size_t>(axis - 3));
  } else {
    const auto i = static_cast<std::size_t>(axis - 6) / 3, j = static_cast<std::size_t>(axis - 6) % 3;
    const Vec3<T> along = p.rotation.column(j);
    const T y = -along[(i + 2) % 3], z = along[(i + 1) % 3], scale = T(1) / std::sqrt(y * y + z * z);
    n[(i + 1) % 3] = y * scale;
    n[(i + 2) % 3] = z * scale;
  }
  return dot(p.translation, n) < T(0) ? -n : n;
}

template <class T>
bool box_points(const BoxPair<T>& p, const BoxChoice<T>& choice, T margin, const Pose<T>& pose_a, const Pose<T>& pose_b,
                BoxPoints<T>& found) {
  found.count = 0;
  if (choice.closest != T(0)) return false;
  const int axis = static_cast<int>(choice.axis);
  const Vec3<T> normal = box_normal(p, axis);
  const bool by_b = axis >= 3 && axis < 6;
  const Vec3<T> seen = by_b ? -transposed_times(p.rotation, normal) : normal;
  const LaidOver<T> faces =
      by_b ? LaidOver<T>({p.half_b, p.half_a, -transposed_times(p.rotation, p.translation), transposed(p.rotation)},
                         seen, static_cast<std::size_t>(axis - 3))
           : LaidOver<T>(p, seen, axis < 3 ? static_cast<std::size_t>(axis) : longest(seen));
  if (!faces.regular()) return false;
  Corners<T> corners;
  faces.corners(corners);
  simplify(corners, faces.near(), [&](const FlatPoint<T>& q) { return faces.apart(q); });

  const T size_a = length(p.half_a), size_b = length(p.half_b), smaller = least(size_a, size_b),
          noise = box_noise(p, size_a, size_b);
  const T limit = greatest(margin, choice.distance + noise), together = T(8) * noise;
  const Pose<T>& frame = by_b ? pose_b : pose_a;
  const Mat3<T> turn = rotation_of(frame.rotation);
  const Axes& axes = faces.clip_axes();
  const Vec3<T> u = turn.column(axes.u), v = turn.column(axes.v), base = turn.column(axes.main) * faces.height(),
                across = turn * seen;
  T nearest = std::numeric_limits<T>::infinity();
  FlatPoint<T> places[most_box_points];
  for (const FlatPoint<T>& q : corners) {
    const T apart = faces.apart(q);
    nearest = least(apart, nearest);
    if (apart > limit) continue;
    const std::uint32_t of_clip = faces.clip_feature(q), of_other = faces.other_feature(q),
                        feature = by_b ? feature_id(of_other, of_clip) : feature_id(of_clip, of_other);
    // Rounding splits a point in two where edges end about on a corner. The deeper one is kept.
    std::size_t place = 0;
    const auto same = [&](std::size_t i) {
      return found.points[i].feature == feature ||
             (std::abs(places[i].x - q.x) <= together && std::abs(places[i].y - q.y) <= together);
    };
    while (place < found.count && !same(place)) ++place;
    if (place == most_box_points || (place < found.count && !(apart < found.points[place].distance))) continue;
    places[place] = q;
    const Vec3<T> on_clip = base + u * q.x + v * q.y, on_other = on_clip + across * apart;
    ContactPoint<T>& point = found.points[place];
    point.a = frame.translation + (by_b ? on_other : on_clip);
    point.b = frame.translation + (by_b ? on_clip : on_other);
    point.distance = apart;
    point.feature = feature;
    point.weight = T(0.5);
    found.count += place == found.count;
  }
  found.normal = by_b ? -across : across;
  const T allowed = choice.distance > T(0) ? T(64) * noise : T(face_preference) * smaller;
  return found.count > 0 && nearest <= choice.distance + allowed;
}

template Vec3<float> box_normal(const BoxPair<float>&, int);
template Vec3<double> box_normal(const BoxPair<double>&, int);
template bool box_points(const BoxPair<float>&, const BoxChoice<float>&, float, const Pose<float>&, const Pose<float>&,
                         BoxPoints<float>&);
template bool box_points(const BoxPair<double>&, const BoxChoice<double>&, double, const Pose<double>&,
                         const Pose<double>&, BoxPoints<double>&);

}  // namespace graze
