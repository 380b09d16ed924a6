#include "narrow/rays/plane_clip.hpp"

#include "narrow/rays/lane_vec3.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
constexpr auto step = static_cast<std::size_t>(S::lanes);

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
      return column<4>(planes, i, count - 1, which);
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
