// A settled pile, every body awake: the whole update of a world side by side, every frame, on one thread; and Graze on
// two.
//
//   bench_pile [--poses FILE.csv] [--frames N]
//
// Boxes lie on each other and on the plane y = 0. Without a file they are 5,000 of edge 1 in a pyramid, each on four,
// a little turned and a little sunk in; a file has a line px,py,pz,qx,qy,qz,qw,hx,hy,hz for each (metres, half edges)
// under a line of these names. From frame to frame every body moves to and fro by about 1e-4 of its size, so that
// nothing can be kept, and every library gets the same poses in single precision, in turns frame by frame. Told are the
// medians of the processor's time: of giving the poses, and of the update from poses to contacts. `pairs` are what the
// broad phase passes on, `contacts` points; of these Graze and Bullet keep those up to their margin apart (0.02 here,
// Bullet's own), ODE only those of boxes that overlap. `still` is Graze with nothing changed since the last frame. The
// second table has the stages of Graze's update, run one by one on arrays of their own, and the third what a second
// thread saves: worlds take turns alone, by the clock. In `2, awake` an empty task wakes the second thread before the
// poses are given, as other work of a program's frame would; else it has slept since the last update. `2 worlds` are
// updated at once, a thread each: what the processors have at that time for two threads that share nothing.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#ifdef GRAZE_BENCH_BULLET
#include <btBulletCollisionCommon.h>
#endif
#ifdef GRAZE_BENCH_ODE
#include <ode/ode.h>
#endif

#include "command_line.hpp"
#include "graze/world.hpp"
#include "measure.hpp"
#include "random.hpp"
#include "stages.hpp"
#include "threads.hpp"

namespace graze::bench {

namespace {

struct PiledBox {
  Vec3f half;
  Posef pose;
};
using Pile = std::vector<PiledBox>;
using Poses = std::vector<Posef>;

/// How far apart contacts begin: Bullet's `gContactBreakingThreshold`.
constexpr double margin = 0.02;
/// How far a body moves from frame to frame, and turns, relative to its size.
constexpr double motion = 1e-4;

Pile make_pyramid(std::size_t count) {
  Random random(5);
  const double gap = 0.03, sunk = 0.003, turn = 0.02, tilt = 0.002;
  std::size_t side = 1, room = 1;
  while (room < count) {
    ++side;
    room += side * side;
  }
  Pile pile;
  for (std::size_t layer = 0; layer < side; ++layer)
    for (std::size_t i = 0; i < (side - layer) * (side - layer) && pile.size() < count; ++i) {
      const double first = -0.5 * static_cast<double>(side - layer - 1);
      const auto x = static_cast<double>(i % (side - layer)), z = static_cast<double>(i / (side - layer));
      const Quatd q =
          normalized(Quatd{random.number(-tilt, tilt), random.number(-turn, turn), random.number(-tilt, tilt), 1});
      const Vec3d p{(first + x) * (1 + gap), 0.5 - sunk + static_cast<double>(layer) * (1 - sunk),
                    (first + z) * (1 + gap)};
      pile.push_back({{0.5f, 0.5f, 0.5f}, converted<float>(Posed{p, q})});
    }
  return pile;
}

std::optional<Pile> read_pile(const char* path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line.rfind("px,py,pz,qx,qy,qz,qw,hx,hy,hz", 0) != 0) return std::nullopt;
  Pile pile;
  while (std::getline(file, line)) {
    float v[10];
    const char* at = line.c_str();
    for (float& number : v) {
      char* end = nullptr;
      number = std::strtof(at, &end);
      if (end == at) return std::nullopt;
      at = *end == ',' ? end + 1 : end;
    }
    pile.push_back({{v[7], v[8], v[9]}, {{v[0], v[1], v[2]}, normalized(Quatf{v[3], v[4], v[5], v[6]})}});
  }
  if (pile.empty()) return std::nullopt;
  return pile;
}

/// The pile moved a little: every body another way, the same for the same seed.
Poses moved(const Pile& pile, std::uint64_t seed) {
  Random random(seed);
  Poses poses;
  for (const PiledBox& box : pile) {
    const double size = static_cast<double>(length(box.half));
    const Posed at = converted<double>(box.pose);
    const Vec3d v = random.in_cube(motion / 2);
    poses.push_back(converted<float>(
        Posed{at.translation + random.in_cube(motion / 2) * size, normalized(Quatd{v.x, v.y, v.z, 1} * at.rotation)}));
  }
  return poses;
}

struct Counts {
  std::size_t pairs = 0, touching = 0, contacts = 0, memory = 0;
};

/// A world of the pile that is given the poses of a frame, finds its contacts, and then tells how many.
struct Contender {
  std::string name;
  std::function<void(const Poses&)> place;
  std::function<void()> update;
  std::function<Counts()> count;
};

template <class T>
struct GrazePile {
  GrazePile(const Pile& pile, std::unique_ptr<Executor> threads)
      : executor(std::move(threads)), world({.margin = T(margin), .allow = {}}, executor.get()) {
    for (const PiledBox& box : pile)
      ids.push_back(world.add({.shape = Box<T>(converted<T>(box.half) * T(2)), .pose = converted<T>(box.pose)}));
    world.add({.shape = HalfSpace<T>(), .fixed = true});
  }
  void place(const Poses& poses) {
    for (std::size_t i = 0; i < ids.size(); ++i) world.move(ids[i], converted<T>(poses[i]));
  }
  std::unique_ptr<Executor> executor;
  World<T> world;
  std::vector<BodyId> ids;
};

template <class T>
Contender graze_world(const char* name, const Pile& pile, bool still,
                      std::unique_ptr<Executor> threads = std::make_unique<SerialExecutor>(), bool awake = false) {
  auto state = std::make_shared<GrazePile<T>>(pile, std::move(threads));
  return {name,
          [state, still, awake](const Poses& poses) {
            if (awake) state->executor->run(state->executor->concurrency(), [](std::size_t) {});
            if (!still) state->place(poses);
          },
          [state] { state->world.update(); },
          [state]() -> Counts {
            const auto& found = state->world.contacts();
            return {0, found.pairs.size(), found.points.size(), state->world.memory()};
          }};
}

#ifdef GRAZE_BENCH_BULLET
Contender bullet_world(const Pile& pile) {
  struct State {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broad;
    btCollisionWorld world{&dispatcher, &broad, &configuration};
    btStaticPlaneShape ground{{0, 1, 0}, 0};
    std::vector<std::unique_ptr<btBoxShape>> shapes;
    std::vector<std::unique_ptr<btCollisionObject>> objects;
    ~State() {
      for (const auto& object : objects) world.removeCollisionObject(object.get());
    }
    void add(btCollisionShape& shape, const Posef& pose, int flags, int group, int mask) {
      objects.push_back(std::make_unique<btCollisionObject>());
      objects.back()->setCollisionShape(&shape);
      place(objects.size() - 1, pose);
      objects.back()->setCollisionFlags(flags);
      objects.back()->setActivationState(DISABLE_DEACTIVATION);
      world.addCollisionObject(objects.back().get(), group, mask);
    }
    void place(std::size_t i, const Posef& pose) {
      const Vec3f& t = pose.translation;
      const Quatf& q = pose.rotation;
      objects[i]->setWorldTransform(btTransform(btQuaternion(q.x, q.y, q.z, q.w), btVector3(t.x, t.y, t.z)));
    }
  };
  auto state = std::make_shared<State>();
  state->world.setForceUpdateAllAabbs(false);  // the plane has not moved
  for (const PiledBox& box : pile) {
    state->shapes.push_back(std::make_unique<btBoxShape>(btVector3(box.half.x, box.half.y, box.half.z)));
    // Its faces stay where they are whatever its margin, which is cut out of the box and put on again.
    state->shapes.back()->setMargin(btScalar(motion) * length(box.half));
    state->add(*state->shapes.back(), box.pose, 0, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
  state->ground.setMargin(0);
  state->add(state->ground, {}, btCollisionObject::CF_STATIC_OBJECT, btBroadphaseProxy::StaticFilter,
             btBroadphaseProxy::DefaultFilter);
  return {"bullet",
          [state](const Poses& poses) {
            for (std::size_t i = 0; i < poses.size(); ++i) state->place(i, poses[i]);
          },
          [state] { state->world.performDiscreteCollisionDetection(); },
          [state]() -> Counts {
            Counts counts{static_cast<std::size_t>(state->broad.getOverlappingPairCache()->getNumOverlappingPairs())};
            for (int i = 0; i < state->dispatcher.getNumManifolds(); ++i) {
              const int points = state->dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
              counts.touching += points > 0;
              counts.contacts += static_cast<std::size_t>(points);
            }
            return counts;
          }};
}
#endif

#ifdef GRAZE_BENCH_ODE
Contender ode_space(const Pile& pile) {
  struct State {
    dSpaceID space = nullptr;
    std::vector<dGeomID> geoms;
    std::vector<dContactGeom> contacts;  ///< kept, as a solver would
    Counts counts;
    State() {
      dInitODE2(0);
      dAllocateODEDataForThread(dAllocateMaskAll);
      space = dHashSpaceCreate(nullptr);
    }
    ~State() { dSpaceDestroy(space); }
  };
  auto state = std::make_shared<State>();
  for (const PiledBox& box : pile)
    state->geoms.push_back(
        dCreateBox(state->space, dReal(2 * box.half.x), dReal(2 * box.half.y), dReal(2 * box.half.z)));
  dCreatePlane(state->space, 0, 1, 0, 0);
  return {sizeof(dReal) == sizeof(double) ? "ode double" : "ode float",
          [state](const Poses& poses) {
            for (std::size_t i = 0; i < poses.size(); ++i) {
              const Vec3f& t = poses[i].translation;
              const Quatf& q = poses[i].rotation;
              const dQuaternion turn = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
              dGeomSetPosition(state->geoms[i], dReal(t.x), dReal(t.y), dReal(t.z));
              dGeomSetQuaternion(state->geoms[i], turn);
            }
          },
          [state] {
            state->counts = {};
            state->contacts.clear();
            dSpaceCollide(state->space, state.get(), [](void* data, dGeomID a, dGeomID b) {
              State& s = *static_cast<State*>(data);
              dContactGeom found[8];
              const int count = dCollide(a, b, 8, found, sizeof(dContactGeom));
              s.contacts.insert(s.contacts.end(), found, found + count);
              ++s.counts.pairs;
              s.counts.touching += count > 0;
            });
          },
          [state]() -> Counts {
            state->counts.contacts = state->contacts.size();
            return state->counts;
          }};
}
#endif

/// The stages of a world's update, frame by frame.
template <class T>
class StagedPile {
 public:
  explicit StagedPile(const Pile& pile) : stages_(serial_, processor_seconds, T(margin)) {
    for (const PiledBox& box : pile)
      ids_.push_back(stages_.add({.shape = Box<T>(converted<T>(box.half) * T(2)), .pose = converted<T>(box.pose)}));
    stages_.add({.shape = HalfSpace<T>(), .fixed = true});
  }
  void frame(const Poses& poses) {
    for (std::size_t i = 0; i < ids_.size(); ++i) stages_.move(ids_[i], converted<T>(poses[i]));
    times_.push_back(stages_.update());
  }
  double time(std::size_t stage) const {
    std::vector<double> times;
    // The first frame allocates, and the second is the first that remembers one.
    for (std::size_t frame = 2; frame < times_.size(); ++frame) times.push_back(times_[frame][stage]);
    return quantile(times, 0.5);
  }
  std::size_t pairs() const { return stages_.pairs(); }

 private:
  SerialExecutor serial_;
  Stages<T> stages_;
  std::vector<BodyId> ids_;
  std::vector<typename Stages<T>::Times> times_;
};

/// What a second thread saves, and what the processors have for it: two worlds at once, which share nothing. These
/// take turns alone: the other libraries' memory would take their place in the caches.
void compare_threads(const Pile& pile, std::span<const Poses, 2> poses, std::size_t frames) {
  auto shared = make_executor(2), woken = make_executor(2), apart = make_executor(2);
  if (!shared || !woken || !apart) return;
  Contender alone = graze_world<float>("1 thread", pile, false), other = graze_world<float>("another", pile, false),
            two = graze_world<float>("2 threads", pile, false, std::move(shared)),
            awake = graze_world<float>("2, awake", pile, false, std::move(woken), true);
  const auto clocked = [](const auto& f) {
    const double begin = clock_seconds();
    f();
    return 1e3 * (clock_seconds() - begin);
  };
  std::vector<double> times[4];
  for (std::size_t frame = 0; frame < 10 * frames; ++frame) {
    const auto place = [&](Contender& world) { world.place(poses[frame % 2]); };
    place(alone);
    times[0].push_back(clocked(alone.update));
    place(two);
    times[1].push_back(clocked(two.update));
    place(awake);
    times[2].push_back(clocked(awake.update));
    place(alone);
    place(other);
    times[3].push_back(clocked([&] { apart->run(2, [&](std::size_t i) { (i == 0 ? alone : other).update(); }); }));
  }
  std::printf("\n| graze float | update ms | times faster |\n|-------------|----------:|-------------:|\n");
  const double first = quantile(times[0], 0.5);
  const auto print = [&](const char* name, double worlds, double time) {
    std::printf("| %-11s | %9.3f | %12.2f |\n", name, time, worlds * first / time);
  };
  print(alone.name.c_str(), 1, first);
  print(two.name.c_str(), 1, quantile(times[1], 0.5));
  print(awake.name.c_str(), 1, quantile(times[2], 0.5));
  print("2 worlds", 2, quantile(times[3], 0.5));
}

int run(int argc, char** argv) {
  std::size_t frames = 15;
  std::string file;
  CommandLine(
      "A settled pile, every body awake: the whole update of a world, beside other libraries and on two threads.")
      .file("--poses", file, "a pile of one's own (CSV: px,py,pz,qx,qy,qz,qw,hx,hy,hz)")
      .number("--frames", frames, "of which the median is taken")
      .read(argc, argv);
  std::optional<Pile> pile;
  if (!file.empty()) {
    pile = read_pile(file.c_str());
    if (!pile) {
      std::fprintf(stderr, "%s: no lines px,py,pz,qx,qy,qz,qw,hx,hy,hz\n", file.c_str());
      return 1;
    }
  }
  if (!pile) pile = make_pyramid(5000);
  const Poses poses[] = {moved(*pile, 1), moved(*pile, 2)};

  std::vector<Contender> all{graze_world<float>("graze float", *pile, false),
                             graze_world<double>("graze double", *pile, false),
                             graze_world<float>("graze float still", *pile, true)};
#ifdef GRAZE_BENCH_BULLET
  all.push_back(bullet_world(*pile));
#endif
#ifdef GRAZE_BENCH_ODE
  all.push_back(ode_space(*pile));
#endif
  StagedPile<float> stages_f(*pile);
  StagedPile<double> stages_d(*pile);
  std::vector<std::vector<double>> placing(all.size()), updating(all.size());
  for (std::size_t frame = 0; frame < frames + 2; ++frame) {
    const Poses& now = poses[frame % 2];
    for (std::size_t c = 0; c < all.size(); ++c) {
      const double begin = processor_seconds();
      all[c].place(now);
      const double placed = processor_seconds();
      all[c].update();
      const double end = processor_seconds();
      if (frame < 2) continue;
      placing[c].push_back(1e3 * (placed - begin));
      updating[c].push_back(1e3 * (end - placed));
    }
    stages_f.frame(now);
    stages_d.frame(now);
  }

  std::printf("%zu boxes, medians of %zu frames\n\n", pile->size(), frames);
  std::printf("| world             | poses ms | update ms |  pairs | ns/pair | touching | contacts | B/body |\n");
  std::printf("|-------------------|---------:|----------:|-------:|--------:|---------:|---------:|-------:|\n");
  for (std::size_t c = 0; c < all.size(); ++c) {
    Counts counts = all[c].count();
    if (counts.pairs == 0) counts.pairs = stages_f.pairs();  // a world of Graze does not tell
    const double update = quantile(updating[c], 0.5);
    std::printf("| %-17s | %8.3f | %9.3f | %6zu | %7.1f | %8zu | %8zu |", all[c].name.c_str(),
                quantile(placing[c], 0.5), update, counts.pairs, 1e6 * update / static_cast<double>(counts.pairs),
                counts.touching, counts.contacts);
    if (counts.memory > 0)
      std::printf(" %6zu |\n", counts.memory / pile->size());
    else
      std::printf("      ? |\n");
  }
  std::printf("\n| stage of graze      | float ms | double ms |\n|---------------------|---------:|----------:|\n");
  for (std::size_t s = 0; s < Stages<float>::count; ++s)
    std::printf("| %-19s | %8.3f | %9.3f |\n", Stages<float>::names[s], stages_f.time(s), stages_d.time(s));
  compare_threads(*pile, poses, frames);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
