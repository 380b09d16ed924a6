#include "graze/world/bins.hpp"

#include <array>
#include <utility>

namespace graze {

template <class T>
void bin_pairs(std::span<const IdPair> pairs, std::span<const Shape<T>> shapes, Bins& out) {
  constexpr std::size_t types = Shape<T>::count;
  std::array<std::uint32_t, types * types> begin{};
  // A byte a shape is near whichever pair asks for it.
  out.types.resize(shapes.size());
  const auto look = [&](std::uint32_t i) { out.types[i] = static_cast<std::uint8_t>(shapes[i].index()); };
  if (pairs.size() < shapes.size())
    for (const IdPair& p : pairs) look(p.a), look(p.b);
  else
    for (std::uint32_t i = 0; i < shapes.size(); ++i) look(i);
  const auto bin = [&](const IdPair& p) { return out.types[p.a] * types + out.types[p.b]; };
  // Pairs that follow each other are mostly of one bin: what is counted there stays out of memory.
  std::size_t last = 0;
  std::uint32_t run = 0;
  for (const IdPair& p : pairs) {
    const std::size_t b = bin(p);
    if (b != last) begin[std::exchange(last, b)] += std::exchange(run, 0);
    ++run;
  }
  begin[last] += run;
  out.bins.clear();
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < begin.size(); ++b) {
    const std::uint32_t count = std::exchange(begin[b], sum);
    sum += count;
    if (count > 0)
      out.bins.push_back(
          {static_cast<std::uint8_t>(b / types), static_cast<std::uint8_t>(b % types), sum - count, sum});
  }
  out.order.resize(pairs.size());
  std::uint32_t to = begin[last = 0];
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    const std::size_t b = bin(pairs[i]);
    if (b != last) {
      begin[last] = to;
      to = begin[last = b];
    }
    out.order[to++] = i;
  }
}

template void bin_pairs(std::span<const IdPair>, std::span<const Shape<float>>, Bins&);
template void bin_pairs(std::span<const IdPair>, std::span<const Shape<double>>, Bins&);

}  // namespace graze
