// Two boxes and a world on the threads of oneTBB.
#include <graze/graze.hpp>
#include <graze/tbb_executor.hpp>
#include <graze/world.hpp>

int main() {
  graze::TbbExecutor executor(2);
  graze::Worldd world({}, &executor);
  const graze::Shaped box = graze::Box<double>({1, 1, 1});
  world.add({box});
  world.add({box, {{0, 0.5, 0}, {}}});
  world.update();
  return world.events().size() == 1 ? 0 : 1;
}
