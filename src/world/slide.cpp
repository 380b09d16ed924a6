#include "graze/slide.hpp"

namespace graze {

namespace {

/// The sine from which on a motion leads into a plane: below are the roundings of a normal.
template <class T>
constexpr T into = T(-64) * std::numeric_limits<T>::epsilon();

template <class T>
bool leads_into_none(const Vec3<T>& motion, std::span<const Vec3<T>> normals) {
  for (const Vec3<T>& n : normals)
    if (dot(motion, n) < into<T> * length(motion)) return false;
  return true;
}

}  // namespace

template <class T>
Vec3<T> along_planes(const Vec3<T>& motion, std::span<const Vec3<T>> normals) {
  if (leads_into_none(motion, normals)) return motion;
  // The nearest motion that is allowed is `motion` projected on one plane or on the line of two; there are few of them.
  Vec3<T> best{};
  T most(0);
  const auto consider = [&](const Vec3<T>& candidate) {
    const T made = dot(candidate, motion);
    if (!(made > most) || !leads_into_none(candidate, normals)) return;
    most = made;
    best = candidate;
  };
  for (std::size_t i = 0; i < normals.size(); ++i) {
    consider(motion - normals[i] * dot(motion, normals[i]));
    for (std::size_t j = i + 1; j < normals.size(); ++j) {
      const Vec3<T> line = normalized(cross(normals[i], normals[j]), Vec3<T>{});
      consider(line * dot(motion, line));
    }
  }
  return best;
}

template <class T>
SlideResult<T> slide(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion, const World<T>& world,
                     const QueryFilter& filter, const SlideOptions& options) {
  SlideResult<T> result{pose, motion, {}};
  std::vector<Vec3<T>> normals;
  Vec3<T> whole = motion;  // what is left to do, before the planes that are met take from it
  for (int i = 0; i < options.iterations && result.left != Vec3<T>{}; ++i) {
    const auto hit = world.cast(shape, result.pose, {result.left, {}}, T(1), filter, CastOptions{Separating::ignored});
    if (!hit) {
      result.pose.translation += result.left;
      result.left = {};
      break;
    }
    result.touched.push_back(*hit);
    const T made = hit->hit.t;
    result.pose.translation += result.left * made;
    // A plane need not hold any more away from where it was met.
    if (made > T(0)) normals.clear();
    normals.push_back(-hit->hit.normal);
    whole = whole * (T(1) - made);
    result.left = along_planes<T>(whole, normals);
  }
  return result;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Vec3<T> along_planes(const Vec3<T>&, std::span<const Vec3<T>>);                                             \
  template SlideResult<T> slide(const Shape<T>&, const Pose<T>&, const Vec3<T>&, const World<T>&, const QueryFilter&,  \
                                const SlideOptions&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
