// The least that a user of the installed library writes.
#include <graze/graze.hpp>

int main() {
  const graze::Vec3<double> a{1, 2, 3};
  const graze::Vec3<double> b{4, 5, 6};
  return graze::dot(a, b) == 32 ? 0 : 1;
}
