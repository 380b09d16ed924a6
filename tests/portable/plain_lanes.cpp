// Whether the lanes of compilers without vector extensions give the bits of the scalar, alone and in the nodes of
// trees. Without the library, which has other lanes.
#define GRAZE_PLAIN_LANES
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>

#include "graze/detail/wide_node.hpp"
#include "graze/geometry.hpp"

namespace {

using namespace graze;

int failures = 0;
void expect(bool right, const char* what) {
  if (!right) std::printf("wrong: %s\n", what), ++failures;
}

/// By memcpy, since Emscripten's standard library has no std::bit_cast.
template <class T>
auto bits(T x) {
  typename Wide<T, 2>::Bits found;
  std::memcpy(&found, &x, sizeof found);
  return found;
}

/// Numbers of all kinds: of most sizes and both signs, zeros of both signs, equal ones, infinity, NaN.
template <class T>
T any_number(std::mt19937& random) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  constexpr T chosen[] = {T(0), -T(0), T(1), infinity, -infinity, std::numeric_limits<T>::quiet_NaN()};
  const auto which = random() % 16;
  const T sign = random() % 2 == 0 ? T(1) : T(-1);
  return which < 6 ? chosen[which]
                   : sign * std::ldexp(T(random() % 65536) + T(0.5), static_cast<int>(random() % 40) - 20);
}

template <class T, int N>
void operations(std::mt19937& random) {
  using Lanes = Wide<T, N>;
  T a[N], b[N];
  for (int i = 0; i < N; ++i) a[i] = any_number<T>(random), b[i] = any_number<T>(random);
  const Lanes x = Lanes::load(a), y = Lanes::load(b);
  bool some = false, every = true;
  for (int i = 0; i < N; ++i) {
    const auto same = [&](const Lanes& lanes, T alone) { return bits(lanes[i]) == bits(alone); };
    expect(same(x + y, a[i] + b[i]) && same(x - y, a[i] - b[i]), "sums");
    expect(same(x * y, a[i] * b[i]) && same(x / y, a[i] / b[i]), "products");
    expect(same(-x, -a[i]) && same(abs(x), std::abs(a[i])) && same(sqrt(x), std::sqrt(a[i])), "of one number");
    expect((x < y)[i] == (a[i] < b[i]) && (x <= y)[i] == (a[i] <= b[i]) && (x > y)[i] == (a[i] > b[i]) &&
               (x >= y)[i] == (a[i] >= b[i]) && (x == y)[i] == (a[i] == b[i]) && (x != y)[i] == (a[i] != b[i]),
           "comparisons");
    expect(same(least(x, y), b[i] < a[i] ? b[i] : a[i]) && same(greatest(x, y), a[i] < b[i] ? b[i] : a[i]), "choices");
    expect(((x == x) & !(x < y))[i] == (!(a[i] < b[i]) && a[i] == a[i]), "masks");
    some = some || a[i] < b[i];
    every = every && a[i] < b[i];
  }
  expect(any(x < y) == some && all(x < y) == every, "any and all");
}

template <class T>
void nodes(std::mt19937& random) {
  const auto coordinate = [&] { return T(random() % 64) / T(4); };
  const auto box = [&] {
    const Vec3<T> low{coordinate(), coordinate(), coordinate()};
    return Aabb<T>{low, low + Vec3<T>{coordinate(), coordinate(), coordinate()}};
  };
  WideNode<T> node;
  const auto there = static_cast<std::uint32_t>(random() % (WideNode<T>::width + 1));
  for (std::uint32_t i = 0; i < there; ++i) node.set(i, box(), i);
  const Aabb<T> asked = box();
  std::uint32_t met = 0;
  std::array<T, WideNode<T>::width> distances;
  node.distances(asked, distances);
  for (std::uint32_t i = 0; i < there; ++i) {
    const Aabb<T> child = node.box(i);
    bool overlap = true;
    T squares = T(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      overlap = overlap && child.lower[axis] <= asked.upper[axis] && asked.lower[axis] <= child.upper[axis];
      const T gap =
          greatest(T(0), greatest(child.lower[axis] - asked.upper[axis], asked.lower[axis] - child.upper[axis]));
      squares += gap * gap;
    }
    met |= (overlap ? 1u : 0u) << i;
    // Shares of the largest gap, squared, their sum and its root: a few roundings.
    expect(std::abs(distances[i] - std::sqrt(squares)) <= T(8) * std::numeric_limits<T>::epsilon() * distances[i],
           "distances of children");
  }
  expect(node.overlapping(asked) == met, "overlaps of children");
}

template <class T>
void everything() {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    operations<T, 16 / sizeof(T)>(random);
    operations<T, 32 / sizeof(T)>(random);
    operations<T, 64 / sizeof(T)>(random);
    nodes<T>(random);
  }
}

}  // namespace

int main() {
  everything<float>();
  everything<double>();
  return failures == 0 ? 0 : 1;
}
