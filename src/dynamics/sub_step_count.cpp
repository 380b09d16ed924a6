#include "dynamics/sub_step_count.hpp"

#include <algorithm>

#include "dynamics/contact_spring.hpp"

namespace graze {

namespace {

/// The depth to which a contact may sink under its load, as a part of the smaller body's size, before the island takes
/// more sub-steps.
template <class T>
constexpr T visible_sink = T(0.001);

/// The part of `visible_sink` within which the contacts of an island have to stay for it to take one sub-step less.
/// Fewer sub-steps soften every contact, and bodies on it sink: a blow to the island, which must not call for more of
/// them again. So they become fewer by one at a time, which changes the springs least, and four times the load has to
/// come before there are more. Measured: with half, towers of thirty boxes and more change their number for good and
/// keep 2 J; with a quarter none of up to forty does, nor ten boxes under one of 1 to 110 times the mass.
template <class T>
constexpr T calm_sink = T(0.25);

/// The part of its size by which a body may fall in a sub-step.
template <class T>
constexpr T fall_in_sub_step = T(0.02);

/// The mean of the depths to which contacts sink, as a part of a size, times the square of the mean number of bodies
/// that a contact bears: above that an island takes more sub-steps than `most_for_one`. A tower bends at each of its
/// contacts and leans until it falls if they are too soft, as a column buckles under its own weight: where stiffness is
/// below a limit that grows with the cube of the height (Greenhill 1881). Measured with towers of 40 to 100 boxes that
/// were built 2 cm out of line, in 16 to 36 sub-steps: they stand up to 0.68 and fall from 0.88 on.
template <class T>
constexpr T slender = T(0.6);

/// The mean speed of bodies, as a part of that of a fall through half the size of the smallest, up to which an island
/// may take more sub-steps than `most_for_one`: bodies that fall onto each other strike, and do not stand; and up to
/// which it may take fewer of these. A tower that bounces bears more when it is pressed and less when it stretches:
/// softer contacts at every stretch would keep it bouncing.
template <class T>
constexpr T standing_speed = T(0.1);
template <class T>
constexpr T calm_speed = T(0.01);

/// Reasons for more sub-steps than a count.
template <class T>
struct Need {
  const IslandLoad<T>& load;
  T step, gravity;

  bool falls_far(int count) const {
    const T h = step / T(count);
    return gravity * h * h > fall_in_sub_step<T> * load.smallest;
  }
  bool sinks(int count, T part) const { return predicted_sink(load.strain, step / T(count)) > part * visible_sink<T>; }
  bool leans(int count, T part) const {
    const T sink = predicted_sink(load.mean_strain, step / T(count));
    return sink * load.mean_borne * load.mean_borne > part * slender<T>;
  }
  bool too_few(int count, T part) const {
    return falls_far(count) || (count < most_for_one ? sinks(count, part) : leans(count, part));
  }
  bool is_slower(T part) const { return load.mean_square_speed <= part * part * gravity * load.smallest; }
  /// Whether an island that took one more than `count` has to keep it.
  bool is_held(int count) const {
    if (count < most_for_one) return too_few(count, calm_sink<T>);
    return too_few(most_for_one, calm_sink<T>) || falls_far(count) || !is_slower(calm_speed<T>);
  }
};

}  // namespace

template <class T>
int sub_step_count(const IslandLoad<T>& load, T step, T gravity, int last, int least, int most) {
  const Need<T> need{load, step, gravity};
  int count = least;
  while (count < most && need.too_few(count, T(1))) ++count;
  if (count < last) count = need.is_held(last - 1) ? last : last - 1;
  // Much stiffer springs throw off what softer ones let sink: those against leaning become stiffer one by one.
  int at_once = std::max({last, most_for_one, least});
  while (at_once < count && need.falls_far(at_once)) ++at_once;
  return count <= at_once ? count : at_once + (need.is_slower(standing_speed<T>) ? 1 : 0);
}

template int sub_step_count(const IslandLoad<float>&, float, float, int, int, int);
template int sub_step_count(const IslandLoad<double>&, double, double, int, int, int);

}  // namespace graze
