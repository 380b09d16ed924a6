// A world: boxes fall through a zone onto a floor, and every frame tells who began to touch and who no longer does.
#include <graze/graze.hpp>
#include <graze/world.hpp>

#include <atomic>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace {

/// Threads come from you: two functions bring your own. `graze::TbbExecutor` brings those of oneTBB.
class Threads final : public graze::Executor {
 public:
  std::size_t concurrency() const override { return 2; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    std::thread other(work);
    work();
    other.join();
  }
};

}  // namespace

int main() {
  Threads threads;
  graze::Worldd world({}, &threads);
  std::map<graze::BodyId, std::string> names;

  graze::Body<double> floor{graze::HalfSpace<double>()};  // below the plane y = 0
  floor.fixed = true;
  names[world.add(floor)] = "floor";

  graze::Body<double> zone{graze::Box<double>({10, 0.5, 10}), {{0, 2, 0}, {}}};
  zone.fixed = zone.trigger = true;  // tells who is inside, and holds nobody up
  names[world.add(zone)] = "zone";

  struct Falling {
    graze::BodyId id;
    graze::Posed pose;
    double speed = 0;
  };
  std::vector<Falling> boxes;
  for (int i = 0; i < 3; ++i) {
    const graze::Posed pose{{2.0 * i, 3.0 + 0.5 * i, 0}, {}};
    boxes.push_back({world.add({graze::Box<double>({1, 1, 1}), pose}), pose});
    names[boxes.back().id] = "box " + std::to_string(i);
  }

  for (int frame = 0; frame < 60; ++frame) {
    for (Falling& box : boxes) {
      box.speed -= 9.81 / 60;
      box.pose.translation.y += box.speed / 60;
      world.move(box.id, box.pose);
    }
    world.update();

    const auto& contacts = world.contacts();
    for (const graze::ContactEvent& e : world.events()) {
      if (e.kind == graze::EventKind::stay) continue;
      std::printf("frame %2d: %s and %s %s", frame, names[e.a].c_str(), names[e.b].c_str(),
                  e.kind == graze::EventKind::begin ? "begin to touch" : "no longer touch");
      std::size_t points = 0;
      if (e.pair != e.no_pair)
        for (const auto& manifold : contacts.manifolds_of(contacts.pairs[e.pair])) points += manifold.point_count;
      std::printf(points > 0 ? " at %zu points\n" : "\n", points);
    }

    // A poor man's solver: what has sunk into the floor is lifted out of it and stays there.
    for (Falling& box : boxes)
      if (const double sunk = 0.5 - box.pose.translation.y; sunk > 0) {
        box.pose.translation.y += sunk;
        box.speed = 0;
      }
  }
}
