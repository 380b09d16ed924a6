#include <array>

#include "plane/pairs/lane_answers.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

/// Two lanes of which the second repeats the first: a pair alone goes through the same selections, where jumps that
/// cannot be foreseen would take several times as long.
using Alone = Wide<double, 2>;

template <class Pair>
[[gnu::flatten]] void overlap_one(const PairColumns<1>& columns, OverlapColumns<1>& out) {
  plane_answers::overlap_at<Pair, Alone>(columns, 0, out);
}
template <class Pair>
[[gnu::flatten]] void distance_one(const PairColumns<1>& columns, DistanceColumns<1>& out) {
  plane_answers::distance_at<Pair, Alone>(columns, 0, out);
}
template <class Pair>
[[gnu::flatten]] void contacts_one(const PairColumns<1>& columns, double margin, ContactColumns<1>& out) {
  const double margins[1] = {margin};
  plane_answers::contacts_at<Pair, Alone>(columns, 0, margins, out);
}

template <class... P>
constexpr std::array<AloneKernels, sizeof...(P)> kernels_of(Pairs<P...>) {
  return {AloneKernels{overlap_one<P>, distance_one<P>, contacts_one<P>}...};
}
constexpr auto kernels = kernels_of(PairList());

}  // namespace

const AloneKernels* plane_alone_kernels() { return kernels.data(); }

}  // namespace graze::GRAZE_ISA
