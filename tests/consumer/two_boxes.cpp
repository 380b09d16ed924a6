// The smallest use of the library: what it links to is the size of a program that asks for one distance.
#include <graze/graze.hpp>

int main() {
  const graze::Shaped box = graze::Box<double>({2, 2, 2});
  return graze::distance(box, {}, box, {{3, 0, 0}, {}}).distance == 1 ? 0 : 1;
}
