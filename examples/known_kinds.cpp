// A ball that rolls about in a room of boxes, asked about by a caller who knows both kinds: nothing is allocated.
#include <graze/typed_query.hpp>

#include <cstdio>

int main() {
  const graze::Sphere<float> ball(0.5f);
  const graze::Box<float> floor({8, 1, 8}), wall({1, 4, 8});
  const graze::Posef below{{0, -0.5f, 0}, {}}, beside{{4, 2, 0}, {}};

  for (const float x : {0.0f, 2.0f, 3.1f}) {
    const graze::Posef here{{x, 0.45f, 0}, {}};
    std::printf("ball at %.1f:%s\n", static_cast<double>(x), overlap(ball, here, wall, beside) ? " at the wall" : "");
    const auto ground = contacts(ball, here, floor, below, /*margin*/ 0.01f);  // at most one point, in place
    for (const auto& point : ground.points)
      std::printf("  %.2f deep in the floor at x = %.1f\n", static_cast<double>(-point.distance),
                  static_cast<double>(point.position().x));
    std::printf("  wall %.2f away\n", static_cast<double>(distance(ball, here, wall, beside).distance));
  }
}
