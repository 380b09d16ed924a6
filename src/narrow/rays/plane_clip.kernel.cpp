#include "narrow/rays/plane_clip.hpp"

#include "narrow/rays/lane_vec3.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
constexpr auto step = static_cast<std::size_t>(S::lanes);

/// One number of each of some planes that lie one behind the other; of the last one in place of any beyond it.
template <class T>
[[gnu::always_inline]] inline S column(const T* planes, std::size_t from, std::size_t last, std::size_t which) {
  typedef T Narrow __attribute__((vector_size(sizeof(T) * S::lanes)));
  const auto at = [&](std::size_t i) __attribute__((always_inline)) {
    const std::size_t place = from + i;
    return planes[4 * (place < last ? place : last) + which];
  };
  Narrow n;
  if constexpr (S::lanes == 8)
    n = Narrow{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
  else if constexpr (S::lanes == 4)
    n = Narrow{at(0), at(1), at(2), at(3)};
  else
    n = Narrow{at(0), at(1)};
  return S::of(__builtin_convertvector(n, S::Vector));
}

}  // namespace

template <class T>
void clip_by_planes(const T* planes, std::size_t count, const double (&origin)[3], const double (&direction)[3],
                    rays::PlaneClip& clip) {
  constexpr double infinity = __builtin_inf();
  const Lane3<S> o = Lane3<S>::all(origin), d = Lane3<S>::all(direction);
  const S zero(0);
  S enter(-infinity), leave(infinity), entered_by(0), place(0);
  for (int i = 0; i < S::lanes; ++i) place.set(i, i);
  auto outside = zero < zero;
  for (std::size_t i = 0; i < count; i += step, place += S(static_cast<double>(step))) {
    const auto get = [&](std::size_t which) __attribute__((always_inline)) {
      return column(planes, i, count - 1, which);
    };
    const Lane3<S> n{get(0), get(1), get(2)};
    const S above = dot(n, o) - get(3), toward = dot(n, d), t = -above / toward;
    outside = outside | ((toward == zero) & (above > zero));
    leave = select((toward > zero) & (t < leave), t, leave);
    const auto later = (toward < zero) & (t > enter);
    enter = select(later, t, enter);
    entered_by = select(later, place, entered_by);
  }
  clip = {enter[0], leave[0], 0, any(outside)};
  double first = entered_by[0];
  for (int i = 1; i < S::lanes; ++i) {
    if (enter[i] > clip.enter || (enter[i] == clip.enter && entered_by[i] < first)) {
      clip.enter = enter[i];
      first = entered_by[i];
    }
    clip.leave = leave[i] < clip.leave ? leave[i] : clip.leave;
  }
  const auto plane = static_cast<std::size_t>(first);
  clip.plane = plane < count ? plane : count - 1;
}

template void clip_by_planes(const float*, std::size_t, const double (&)[3], const double (&)[3], rays::PlaneClip&);
template void clip_by_planes(const double*, std::size_t, const double (&)[3], const double (&)[3], rays::PlaneClip&);

}  // namespace graze::GRAZE_ISA
