// The least that a user of the installed library writes: two balls, how far apart.
#include <graze/graze.hpp>

int main() {
  const graze::Shaped ball = graze::Sphere<double>(1);
  const graze::Distance<double> d = graze::distance(ball, {}, ball, graze::Posed{{0, 3, 0}, {}});
  return d.distance == 1 && d.normal == graze::Vec3d{0, 1, 0} ? 0 : 1;
}
