#include "io/keyframes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/angles.hpp"

namespace graze::io {

namespace {

using Values = std::array<double, 4>;

/// The place of a time: behind key `first`, by `part` of the `seconds` to the next. The part is 0 at a key, and where
/// there is no next one.
struct KeyPlace {
  std::size_t first = 0;
  double part = 0, seconds = 0;
};

KeyPlace place_of(const std::vector<float>& times, double t) {
  const auto above = std::upper_bound(times.begin(), times.end(), t,
                                      [](double value, float time) { return value < static_cast<double>(time); });
  if (above == times.begin()) return {};
  const auto first = static_cast<std::size_t>(above - times.begin()) - 1;
  if (above == times.end()) return {first, 0, 0};
  const auto begin = static_cast<double>(times[first]), seconds = static_cast<double>(*above) - begin;
  return {first, (t - begin) / seconds, seconds};
}

/// The numbers of one value.
Values value_at(const std::vector<float>& values, std::size_t width, std::size_t i) {
  Values out{};
  for (std::size_t k = 0; k < width; ++k) out[k] = static_cast<double>(values[i * width + k]);
  return out;
}

/// The place of a key among the values.
std::size_t key_index(Interpolation interpolation, std::size_t key) {
  return interpolation == Interpolation::cubic_spline ? 3 * key + 1 : key;
}

/// Hermite's cubic between two keys, tangents in units a second (glTF 2.0, appendix C.5).
Values spline(const std::vector<float>& values, std::size_t width, const KeyPlace& p) {
  const double t = p.part, t2 = t * t, t3 = t2 * t;
  const Values from = value_at(values, width, 3 * p.first + 1), away = value_at(values, width, 3 * p.first + 2),
               towards = value_at(values, width, 3 * p.first + 3), to = value_at(values, width, 3 * p.first + 4);
  Values out{};
  for (std::size_t k = 0; k < width; ++k)
    out[k] = (2 * t3 - 3 * t2 + 1) * from[k] + p.seconds * (t3 - 2 * t2 + t) * away[k] + (3 * t2 - 2 * t3) * to[k] +
             p.seconds * (t3 - t2) * towards[k];
  return out;
}

Quatd quaternion(const Values& v) { return {v[0], v[1], v[2], v[3]}; }

double norm(const Quatd& q) { return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w); }

Quatd sum(const Quatd& a, double s, const Quatd& b, double t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w};
}

/// The rotation along the shorter arc at constant speed (Shoemake 1985, "Animating rotation with quaternion
/// curves"; glTF 2.0, appendix C.4). The angle comes from the chord and its complement: an arc cosine would lose
/// half of the digits of a small one.
Quatd slerp(const Quatd& a, Quatd b, double t) {
  const double cosine = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
  if (cosine < 0) b = {-b.x, -b.y, -b.z, -b.w};
  const double angle = 2 * angle_of(norm(sum(b, 1, a, 1)), norm(sum(b, 1, a, -1))), sine = cosine_sine(angle).sine;
  if (!(sine > 0)) return a;
  return normalized(sum(a, cosine_sine(angle * (1 - t)).sine / sine, b, cosine_sine(angle * t).sine / sine));
}

}  // namespace

Vec3d Keyframes::vector(double t) const {
  const KeyPlace p = place_of(*times, t);
  const auto key = [&](std::size_t i) {
    const Values v = value_at(*values, 3, key_index(interpolation, i));
    return Vec3d{v[0], v[1], v[2]};
  };
  if (p.part == 0 || interpolation == Interpolation::step) return key(p.first);
  if (interpolation == Interpolation::cubic_spline) {
    const Values v = spline(*values, 3, p);
    return {v[0], v[1], v[2]};
  }
  return key(p.first) * (1 - p.part) + key(p.first + 1) * p.part;
}

Quatd Keyframes::rotation(double t) const {
  const KeyPlace p = place_of(*times, t);
  const auto key = [&](std::size_t i) {
    return normalized(quaternion(value_at(*values, 4, key_index(interpolation, i))));
  };
  if (p.part == 0 || interpolation == Interpolation::step) return key(p.first);
  if (interpolation == Interpolation::linear) return slerp(key(p.first), key(p.first + 1), p.part);
  const Quatd q = quaternion(spline(*values, 4, p));
  return q == Quatd{0, 0, 0, 0} ? key(p.part < 0.5 ? p.first : p.first + 1) : normalized(q);
}

}  // namespace graze::io
