// A program compiled without exceptions and run-time type information that includes every public header, derives from
// what is there to be derived from, and runs.
#include "everything.hpp"

#include <cstdio>

namespace {

class Ball final : public graze::SupportFunction<double> {
 public:
  graze::Vec3d support(const graze::Vec3d& direction) const override { return normalized(direction); }
};

class Threads final : public graze::Executor {
 public:
  std::size_t concurrency() const override { return 2; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t i = count; i-- > 0;) task(i);
  }
};

}  // namespace

int main() {
  const graze::Shaped own = graze::UserConvex<double>(std::make_shared<Ball>());
  const graze::Distance<double> d = graze::distance(own, {}, own, graze::Posed{{0, 3, 0}, {}});
  Threads threads;
  graze::Worldd world({}, &threads);
  for (int i = 0; i < 3; ++i) world.add({own, graze::Posed{{1.9 * i, 0, 0}, {}}});
  world.update();
  graze::Simulationd simulation({}, &threads);
  simulation.add({graze::Box<double>({1, 1, 1})});
  simulation.step(1.0 / 60);
  std::printf("%.9f %zu %.3f\n", d.distance, world.contacts().pairs.size(), simulation.report().whole_ms);
  return d.distance > 0.999 && d.distance < 1.001 && world.contacts().pairs.size() == 2 ? 0 : 1;
}
