#include <array>

#include "plane/pairs/lane_answers.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

using Beside = Lanes<double>;

template <class Pair>
[[gnu::flatten]] void overlaps(const PairColumns<block_pairs>& columns, std::size_t count,
                               OverlapColumns<block_pairs>& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes) plane_answers::overlap_at<Pair, Beside>(columns, i, out);
}
template <class Pair>
[[gnu::flatten]] void distances(const PairColumns<block_pairs>& columns, std::size_t count,
                                DistanceColumns<block_pairs>& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes) plane_answers::distance_at<Pair, Beside>(columns, i, out);
}
template <class Pair>
[[gnu::flatten]] void contacts(const PairColumns<block_pairs>& columns, std::size_t count,
                               const double (&margins)[block_pairs], ContactColumns<block_pairs>& out) {
  for (std::size_t i = 0; i < count; i += Beside::lanes)
    plane_answers::contacts_at<Pair, Beside>(columns, i, margins, out);
}

template <class... P>
constexpr std::array<PairKernels, sizeof...(P)> kernels_of(Pairs<P...>) {
  return {PairKernels{overlaps<P>, distances<P>, contacts<P>}...};
}
constexpr auto kernels = kernels_of(PairList());

}  // namespace

const PairKernels* plane_pair_kernels() { return kernels.data(); }

}  // namespace graze::GRAZE_ISA
