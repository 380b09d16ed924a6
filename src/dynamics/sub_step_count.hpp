// The number of sub-steps of an island: as many as its load needs to be borne stiffly, and no more.
#pragma once

#include <limits>

namespace graze {

/// The load that the contacts of an island bore in the last step.
template <class T>
struct IslandLoad {
  T strain{};             ///< greatest of a contact: force times inverse masses, of the smaller body's size
  T mean_strain{};        ///< of the contacts that press
  T mean_borne{};         ///< by one of them: its force as a number of weights of the bodies; 0 without gravity
  T mean_square_speed{};  ///< of the bodies
  T smallest = std::numeric_limits<T>::infinity();  ///< size of a body that touches another
};

/// The most sub-steps that the hardest pressed contact of an island can call for. In a pile some contact is always
/// struck, and more of them would be for that one alone. An island with a body that is new, whose load is not known
/// yet, takes no fewer.
inline constexpr int most_for_one = 16;

/// From `least` to `most`, for a step of duration `step` in an island that took at most `last` in the one before.
template <class T>
int sub_step_count(const IslandLoad<T>& load, T step, T gravity, int last, int least, int most);

}  // namespace graze
