#include "graze/batch_pairs.hpp"

#include <algorithm>
#include <string>

#include "graze/plane/shape.hpp"

namespace graze {

namespace {

void check_place(std::size_t place, std::size_t size, const char* side, std::size_t pair) {
  if (place < size) return;
  std::string path = "pairs[";
  path += std::to_string(pair);
  path += "].";
  path += side;
  std::string expectation = "a place below ";
  expectation += std::to_string(size);
  validate::fail(path, expectation, static_cast<double>(place));
}

}  // namespace

template <class T, class Placed>
Batch<T, Placed>::Batch(const Bodies<T, Placed>& a, const Bodies<T, Placed>& b, std::span<const IdPair> pairs)
    : a_(a), b_(b), pairs_(pairs), size_(pairs.size()) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    check_place(pairs[i].a, a.size(), "a", i);
    check_place(pairs[i].b, b.size(), "b", i);
  }
}

template <class T, class Placed>
Batch<T, Placed>::Batch(const Bodies<T, Placed>& a, const Bodies<T, Placed>& b)
    : a_(a),
      b_(b),
      size_(a.size() == 1   ? b.size()
            : b.size() == 1 ? a.size()
                            : std::max(a.size(), b.size())) {
  if (a.size() != b.size() && a.size() != 1 && b.size() != 1)
    validate::fail("b", "as many bodies as a, or one", static_cast<double>(b.size()));
}

template class Batch<float>;
template class Batch<double>;
template class Batch<float, plane::Placed<float>>;
template class Batch<double, plane::Placed<double>>;

}  // namespace graze
