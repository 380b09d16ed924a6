// A convex shape of one's own: a superellipsoid |x|^4 + |y|^4 + |z|^4 <= 1, by its support function alone.
#include <graze/graze.hpp>

#include <cmath>
#include <cstdio>

namespace {

class Superellipsoid final : public graze::SupportFunction<double> {
 public:
  /// The gradient of the surface is along the direction where each coordinate is the cube root of the direction's.
  graze::Vec3d support(const graze::Vec3d& d) const override {
    const graze::Vec3d p{std::cbrt(d.x), std::cbrt(d.y), std::cbrt(d.z)};
    const double norm = std::pow(p.x * p.x * p.x * p.x + p.y * p.y * p.y * p.y + p.z * p.z * p.z * p.z, 0.25);
    return norm > 0 ? p / norm : graze::Vec3d{1, 0, 0};
  }
};

}  // namespace

int main() {
  const graze::Shaped mine = graze::UserConvex<double>(std::make_shared<Superellipsoid>());
  const graze::Shaped box = graze::Box<double>({1, 1, 1});
  for (const double x : {2.0, 1.5, 1.0, 0.0}) {
    const auto d = graze::distance(mine, {}, box, graze::Posed{{x, 0.3, 0}, {}});
    std::printf("box at x = %.1f: distance %9.6f\n", x, d.distance);
  }
}
