#include "graze/world/bins.hpp"

#include <array>
#include <utility>

#include "graze/plane/space.hpp"

namespace graze {

template <class T, class Space>
void bin_pairs(std::span<const IdPair> pairs, std::span<const typename Space::Shape> shapes, Bins& out) {
  constexpr std::size_t types = Space::Shape::count;
  // A byte a shape stays in a near cache, in whatever order pairs come.
  out.types.resize(shapes.size(), Bins::unseen);
  const auto look = [&](std::uint32_t i) { out.types[i] = static_cast<std::uint8_t>(shapes[i].index()); };
  if (pairs.size() < shapes.size())
    for (const IdPair& p : pairs) look(p.a), look(p.b);
  else
    for (std::uint32_t i = 0; i < shapes.size(); ++i) look(i);

  const std::uint8_t* const type = out.types.data();
  const auto bin = [&](const IdPair& p) { return type[p.a] * types + type[p.b]; };
  // Several parts of the pairs by turns, each with counts of its own: a pair of the same bin as the last one need not
  // wait for that one's count.
  constexpr std::size_t parts = 4;
  std::array<std::array<std::uint32_t, types * types>, parts> next{};
  const std::size_t length = pairs.size() / parts;
  const auto each = [&](const auto& f) {
    for (std::size_t i = 0; i < length; ++i)
      for (std::size_t part = 0; part < parts; ++part) f(part, part * length + i);
    for (std::size_t i = parts * length; i < pairs.size(); ++i) f(parts - 1, i);
  };
  each([&](std::size_t part, std::size_t i) { ++next[part][bin(pairs[i])]; });
  out.bins.clear();
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < types * types; ++b) {
    const std::uint32_t first = sum;
    for (auto& of_part : next) sum += std::exchange(of_part[b], sum);
    if (sum > first)
      out.bins.push_back({static_cast<std::uint8_t>(b / types), static_cast<std::uint8_t>(b % types), first, sum});
  }

  out.order.resize(pairs.size());
  each(
      [&](std::size_t part, std::size_t i) { out.order[next[part][bin(pairs[i])]++] = static_cast<std::uint32_t>(i); });
}

#define GRAZE_INSTANTIATE(T, Space)                                                                                    \
  template void bin_pairs<T, Space<T>>(std::span<const IdPair>, std::span<const Space<T>::Shape>, Bins&);
GRAZE_INSTANTIATE(float, Space)
GRAZE_INSTANTIATE(double, Space)
GRAZE_INSTANTIATE(float, plane::Space)
GRAZE_INSTANTIATE(double, plane::Space)
#undef GRAZE_INSTANTIATE

}  // namespace graze
