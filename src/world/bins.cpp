#include "graze/world/bins.hpp"

#include <array>

namespace graze {

template <class T>
void bin_pairs(std::span<const IdPair> pairs, std::span<const Shape<T>> shapes, Bins& out) {
  constexpr std::size_t types = Shape<T>::count;
  // A byte a shape is near whichever pair asks for it.
  out.types.resize(shapes.size());
  const auto look = [&](std::uint32_t i) { out.types[i] = static_cast<std::uint8_t>(shapes[i].index()); };
  if (pairs.size() < shapes.size())
    for (const IdPair& p : pairs) look(p.a), look(p.b);
  else
    for (std::uint32_t i = 0; i < shapes.size(); ++i) look(i);

  const std::uint8_t* const type = out.types.data();
  const auto bin = [&](const IdPair& p) { return type[p.a] * types + type[p.b]; };
  // In two arrays by turns: a pair of the same bin as the last one need not wait for that one's count.
  std::array<std::uint32_t, types * types> next{}, odd{};
  for (std::size_t i = 0; i < pairs.size(); ++i) ++(i % 2 == 0 ? next : odd)[bin(pairs[i])];
  out.bins.clear();
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < next.size(); ++b) {
    const std::uint32_t first = sum;
    sum += next[b] + odd[b];
    next[b] = first;
    if (sum > first)
      out.bins.push_back({static_cast<std::uint8_t>(b / types), static_cast<std::uint8_t>(b % types), first, sum});
  }

  out.order.resize(pairs.size());
  for (std::uint32_t i = 0; i < pairs.size(); ++i) out.order[next[bin(pairs[i])]++] = i;
}

template void bin_pairs(std::span<const IdPair>, std::span<const Shape<float>>, Bins&);
template void bin_pairs(std::span<const IdPair>, std::span<const Shape<double>>, Bins&);

}  // namespace graze
