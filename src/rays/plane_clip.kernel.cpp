#include "rays/plane_clip.hpp"

#include <cstring>

#include "rays/lane_vec3.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
constexpr double infinity = __builtin_inf();

/// The remaining part of a ray in each lane, and the plane by which it enters.
struct LaneClip {
  S enter{-infinity}, leave{infinity}, entered_by{0};
  S::Mask outside{};

  [[gnu::always_inline]] void clip(const S (&plane)[4], const S& place, const Vec3<S>& o, const Vec3<S>& d) {
    const S zero(0);
    const Vec3<S> n{plane[0], plane[1], plane[2]};
    const S above = dot(n, o) - plane[3], toward = dot(n, d), t = -above / toward;
    outside = outside | ((toward == zero) & (above > zero));
    leave = select((toward > zero) & (t < leave), t, leave);
    const auto later = (toward < zero) & (t > enter);
    enter = select(later, t, enter);
    entered_by = select(later, place, entered_by);
  }
};

/// Clips by the `part`-th register in double of planes in rows from the `first` on.
template <std::size_t part, class T>
[[gnu::always_inline]] inline void clip_part(const Lanes<T> (&rows)[4], std::size_t first, const S& places,
                                             const Vec3<S>& o, const Vec3<S>& d, LaneClip& clip) {
  const S plane[4] = {lanes_in_double<part>(rows[0]), lanes_in_double<part>(rows[1]), lanes_in_double<part>(rows[2]),
                      lanes_in_double<part>(rows[3])};
  clip.clip(plane, places + S(static_cast<double>(first + part * lanes_of<double>)), o, d);
}

}  // namespace

template <class T>
void clip_by_planes(const T* planes, std::size_t count, const double (&origin)[3], const double (&direction)[3],
                    rays::PlaneClip& clip) {
  constexpr auto step = static_cast<std::size_t>(lanes_of<T>);
  const Vec3<S> o = broadcast<S>(origin), d = broadcast<S>(direction);
  S places(0);
  for (int i = 0; i < S::lanes; ++i) places.set(i, i);
  T few[4 * step];
  if (count < step) {  // lanes without a plane repeat the last one
    for (std::size_t i = 0; i < step; ++i)
      std::memcpy(few + 4 * i, planes + 4 * (i < count ? i : count - 1), 4 * sizeof(T));
    planes = few;
  }
  const std::size_t rows = count < step ? step : count;
  LaneClip found;
  for (std::size_t i = 0; i < rows; i += step) {
    // Planes that the last register shares with the one before count twice.
    const std::size_t first = i + step <= rows ? i : rows - step;
    Lanes<T> row[4];
    load_rows<4, 0, T>(planes + 4 * first, row);
    clip_part<0>(row, first, places, o, d, found);
    if constexpr (sizeof(T) == 4) clip_part<1>(row, first, places, o, d, found);
  }
  clip = {found.enter[0], found.leave[0], 0, any(found.outside)};
  double entered_by = found.entered_by[0];
  for (int i = 1; i < S::lanes; ++i) {
    if (found.enter[i] > clip.enter || (found.enter[i] == clip.enter && found.entered_by[i] < entered_by)) {
      clip.enter = found.enter[i];
      entered_by = found.entered_by[i];
    }
    clip.leave = found.leave[i] < clip.leave ? found.leave[i] : clip.leave;
  }
  const auto plane = static_cast<std::size_t>(entered_by);
  clip.plane = plane < count ? plane : count - 1;
}

template void clip_by_planes(const float*, std::size_t, const double (&)[3], const double (&)[3], rays::PlaneClip&);
template void clip_by_planes(const double*, std::size_t, const double (&)[3], const double (&)[3], rays::PlaneClip&);

}  // namespace graze::GRAZE_ISA
