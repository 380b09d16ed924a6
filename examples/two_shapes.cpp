// The four questions about two shapes.
#include <graze/graze.hpp>

#include <cstdio>

int main() {
  const graze::Shaped box = graze::Box<double>({2, 2, 2});
  const graze::Shaped can = graze::Cylinder<double>(1.5, 0.5);
  const graze::Posed standing{};
  const graze::Posed leaning{{1.3, 0.4, 0}, graze::Quatd::from_axis_angle({0, 0, 1}, 0.5)};

  std::printf("touch: %s\n", graze::overlap(box, standing, can, leaning) ? "yes" : "no");

  const graze::Distance<double> d = graze::distance(box, standing, can, leaning);
  std::printf("distance %.6f along (%.3f, %.3f, %.3f)\n", d.distance, d.normal.x, d.normal.y, d.normal.z);

  graze::Manifolds<double> manifolds;
  graze::contacts(box, standing, can, leaning, 0.01, manifolds);
  for (const auto& manifold : manifolds)
    for (const auto& point : manifold.points) {
      const graze::Vec3d p = point.position();
      std::printf("contact at (%.3f, %.3f, %.3f), %.6f apart\n", p.x, p.y, p.z, point.distance);
    }

  const graze::Closest<double> c = graze::closest(can, leaning, graze::Vec3d{3, 0, 0});
  std::printf("nearest to (3, 0, 0): (%.3f, %.3f, %.3f), %.6f away\n", c.point.x, c.point.y, c.point.z, c.distance);
}
