// Broad phases side by side: update and the whole set of pairs, every frame, on one thread.
//
//   bench_broad [--largest N] [--frames N] [--filter REGEX] [--scene REGEX]
//
// Scenes: `coherent` all boxes drift, `tenth` every tenth does, `teleport` all jump anywhere, `uneven` one in a hundred
// is 50 times larger, `spread` the same with room for these, `clustered` in a few heaps far apart. Each box has three
// to six neighbours, but for `uneven`, where the larger ones overlap a good part of all. All libraries get the same
// boxes in single precision (`double` those boxes in double), in turns frame by frame. Told are the median and the mean
// of the processor's time, how many pairs each finds (those that keep fat boxes find more than there are; `moved` asks
// only for the pairs of what moved), and the bytes it holds a box. The mean is what counts for those that do much of
// their work in few of the frames. One that takes more than two seconds over the first frame, or took a fifth of one
// with a tenth of the boxes, is left out.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <numeric>
#include <regex>
#include <set>
#include <string>

#ifdef GRAZE_BENCH_BULLET
#include <btBulletCollisionCommon.h>
#endif
#ifdef GRAZE_BENCH_FCL
#include <fcl/fcl.h>
#endif

#include "command_line.hpp"
#include "graze/broad_phase.hpp"
#include "graze/pair_changes.hpp"
#include "graze/pairs.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

using Boxes = std::vector<Aabbf>;

/// A broad phase that is given the boxes of a frame and returns how many pairs there are.
struct Contender {
  std::string name;
  std::function<void(const Boxes&)> begin;
  std::function<std::size_t(const Boxes&, const std::vector<std::uint32_t>& moved)> frame;
  std::function<std::size_t()> memory = [] { return std::size_t{0}; };  ///< in bytes; 0 where it cannot be known
  std::function<void(const Boxes&)> convert = [](const Boxes&) {};      ///< before each frame, and not timed
};

Contender pair_finder() {
  struct State {
    std::vector<IdPair> pairs;
    PairFinder<float> finder;
  };
  auto state = std::make_shared<State>();
  return {"graze pairs", [](const Boxes&) {},
          [state](const Boxes& boxes, const auto&) {
            state->finder.find(boxes, state->pairs);
            return state->pairs.size();
          },
          [state] { return state->finder.memory(); }};
}
Contender pair_finder_in_double() {
  struct State {
    std::vector<Aabbd> boxes;
    std::vector<IdPair> pairs;
    PairFinder<double> finder;
  };
  auto state = std::make_shared<State>();
  return {"graze pairs double", [](const Boxes&) {},
          [state](const Boxes&, const auto&) {
            state->finder.find(state->boxes, state->pairs);
            return state->pairs.size();
          },
          [state] { return state->finder.memory(); },
          [state](const Boxes& boxes) {
            state->boxes.clear();
            for (const Aabbf& b : boxes)
              state->boxes.push_back({converted<double>(b.lower), converted<double>(b.upper)});
          }};
}

enum class Asked { all, moved };

Contender structure(const char* name, std::unique_ptr<BroadPhase<float>> (*make)(), Asked asked = Asked::all) {
  struct State {
    std::unique_ptr<BroadPhase<float>> broad;
    std::vector<IdPair> pairs;
  };
  auto state = std::make_shared<State>();
  return {name,
          [state, make](const Boxes& boxes) {
            state->broad = make();
            for (std::uint32_t i = 0; i < boxes.size(); ++i) state->broad->insert(i, boxes[i]);
          },
          [state, asked](const Boxes& boxes, const std::vector<std::uint32_t>& moved) {
            for (const std::uint32_t i : moved) state->broad->move(i, boxes[i]);
            if (asked == Asked::all)
              state->broad->pairs(state->pairs);
            else
              state->broad->moved_pairs(state->pairs);
            return state->pairs.size();
          },
          [state] { return state->broad->memory(); }};
}

/// Tells what began and what ended; counts the pairs that there are by that.
Contender changes() {
  struct State {
    std::unique_ptr<PairChanges<float>> broad;
    std::vector<IdPair> begun, ended;
    std::size_t pairs = 0;
  };
  auto state = std::make_shared<State>();
  return {"tree changes",
          [state](const Boxes& boxes) {
            state->broad = std::make_unique<PairChanges<float>>();
            state->pairs = 0;
            for (std::uint32_t i = 0; i < boxes.size(); ++i) state->broad->insert(i, boxes[i]);
          },
          [state](const Boxes& boxes, const std::vector<std::uint32_t>& moved) {
            for (const std::uint32_t i : moved) state->broad->move(i, boxes[i]);
            state->broad->find(state->begun, state->ended);
            state->pairs += state->begun.size() - state->ended.size();
            return state->pairs;
          },
          [state] { return state->broad->memory(); }};
}

#ifdef GRAZE_BENCH_BULLET
btVector3 vector(const Vec3f& v) { return {v.x, v.y, v.z}; }

template <class Make>
Contender bullet(const char* name, Make make) {
  struct State {
    std::unique_ptr<btBroadphaseInterface> broad;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    std::vector<btBroadphaseProxy*> proxies;
    ~State() { clear(); }
    void clear() {
      for (btBroadphaseProxy* proxy : proxies) broad->destroyProxy(proxy, &dispatcher);
      proxies.clear();
    }
  };
  auto state = std::make_shared<State>();
  return {name,
          [state, make](const Boxes& boxes) {
            state->clear();
            state->broad = make(boxes);
            for (const Aabbf& box : boxes)
              state->proxies.push_back(state->broad->createProxy(vector(box.lower), vector(box.upper), 0, nullptr, 1,
                                                                 -1, &state->dispatcher));
            state->broad->calculateOverlappingPairs(&state->dispatcher);
          },
          [state](const Boxes& boxes, const std::vector<std::uint32_t>& moved) {
            for (const std::uint32_t i : moved)
              state->broad->setAabb(state->proxies[i], vector(boxes[i].lower), vector(boxes[i].upper),
                                    &state->dispatcher);
            state->broad->calculateOverlappingPairs(&state->dispatcher);
            return static_cast<std::size_t>(state->broad->getOverlappingPairCache()->getNumOverlappingPairs());
          }};
}

std::unique_ptr<btBroadphaseInterface> bullet_tree(const Boxes&) { return std::make_unique<btDbvtBroadphase>(); }
std::unique_ptr<btBroadphaseInterface> bullet_sweep(const Boxes& boxes) {
  Aabbf all = Aabbf::empty();
  for (const Aabbf& box : boxes) all = merged(all, box);
  const Vec3f room = all.extent();
  return std::make_unique<bt32BitAxisSweep3>(vector(all.lower - room), vector(all.upper + room),
                                             static_cast<unsigned>(boxes.size() + 8));
}
#endif

#ifdef GRAZE_BENCH_FCL
Contender fcl_tree() {
  struct State {
    std::unique_ptr<fcl::DynamicAABBTreeCollisionManagerf> manager;
    std::vector<std::unique_ptr<fcl::CollisionObjectf>> objects;
  };
  auto state = std::make_shared<State>();
  const auto place = [](fcl::CollisionObjectf& object, const Aabbf& box) {
    const Vec3f c = box.center();
    object.setTranslation({c.x, c.y, c.z});
    object.computeAABB();
  };
  return {"fcl tree",
          [state, place](const Boxes& boxes) {
            state->objects.clear();
            state->manager = std::make_unique<fcl::DynamicAABBTreeCollisionManagerf>();
            std::vector<fcl::CollisionObjectf*> all;
            for (const Aabbf& box : boxes) {
              const Vec3f e = box.extent();
              state->objects.push_back(
                  std::make_unique<fcl::CollisionObjectf>(std::make_shared<fcl::Boxf>(e.x, e.y, e.z)));
              place(*state->objects.back(), box);
              all.push_back(state->objects.back().get());
            }
            state->manager->registerObjects(all);
            state->manager->setup();
          },
          [state, place](const Boxes& boxes, const std::vector<std::uint32_t>& moved) {
            for (const std::uint32_t i : moved) place(*state->objects[i], boxes[i]);
            state->manager->update();
            std::size_t count = 0;
            state->manager->collide(&count, [](fcl::CollisionObjectf*, fcl::CollisionObjectf*, void* data) {
              ++*static_cast<std::size_t*>(data);
              return false;
            });
            return count;
          }};
}
#endif

struct Scene {
  const char* name;
  double moving = 1;  ///< the share that moves in a frame
  bool jumps = false, uneven = false, spread = false, clustered = false;
};
constexpr Scene scenes[] = {{.name = "coherent"},
                            {.name = "tenth", .moving = 0.1},
                            {.name = "teleport", .jumps = true},
                            {.name = "uneven", .uneven = true},
                            {.name = "spread", .uneven = true, .spread = true},
                            {.name = "clustered", .clustered = true}};
/// One in so many boxes of an uneven scene is so many times larger.
constexpr std::size_t few = 100;
constexpr double larger = 50;

class Motion {
 public:
  Motion(const Scene& scene, std::size_t count) : scene_(scene), velocity_(count) {
    // So many boxes of a mean side of 1 in a cube of this side have about four neighbours each: two of them overlap in
    // a share of the cube's volume that is the cube of their sides' sum.
    const double share = 1.0 / few, sum = 1 + larger;
    const double volume = !scene.spread ? 8
                                        : (1 - share) * (1 - share) * 8 + 2 * share * (1 - share) * sum * sum * sum +
                                              share * share * 8 * larger * larger * larger;
    reach_ = 0.5 * std::cbrt(static_cast<double>(count) * volume / 4.0);
    for (std::size_t i = 0; i < count; ++i) {
      const double grown = scene.uneven && i % few == 0 ? larger : 1;
      boxes.push_back(box_at(
          anywhere(i), Vec3d{random_.number(0.5, 1.5), random_.number(0.5, 1.5), random_.number(0.5, 1.5)} * grown));
      velocity_[i] = converted<float>(random_.in_cube(0.02));
    }
  }
  void step() {
    moved.clear();
    const auto every = static_cast<std::size_t>(1 / scene_.moving);
    for (std::size_t i = frame_++ % every; i < boxes.size(); i += every) {
      Aabbf& box = boxes[i];
      if (scene_.jumps)
        box = box_at(anywhere(i), converted<double>(box.extent()));
      else
        box = {box.lower + velocity_[i], box.upper + velocity_[i]};
      moved.push_back(static_cast<std::uint32_t>(i));
    }
  }

  Boxes boxes;
  std::vector<std::uint32_t> moved;

 private:
  Vec3d anywhere(std::size_t i) {
    if (!scene_.clustered) return random_.in_cube(reach_);
    return random_.in_cube(reach_ / 4) +
           Vec3d{40 * double(i % 4), 60 * double(i % 3), 50 * double(i % 5)} * (reach_ / 4);
  }
  static Aabbf box_at(const Vec3d& center, const Vec3d& size) {
    return {converted<float>(center - size * 0.5), converted<float>(center + size * 0.5)};
  }

  Scene scene_;
  Random random_{11};
  double reach_;
  std::size_t frame_ = 0;
  std::vector<Vec3f> velocity_;
};

struct Result {
  std::vector<double> times;
  std::size_t pairs = 0;
  bool too_slow = false;
};

/// One that takes longer over its first frame, or that took a tenth as long with a tenth of the boxes, is left out.
constexpr double patience = 2;

/// `slow` are the names of those not to try in this scene, and is added to.
void run_scene(const Scene& scene, std::size_t count, std::size_t frames, std::vector<Contender>& contenders,
               std::set<std::string>& slow) {
  Motion motion(scene, count);
  std::vector<Result> results(contenders.size());
  const auto seconds = [](std::clock_t begin) {
    return static_cast<double>(std::clock() - begin) / static_cast<double>(CLOCKS_PER_SEC);
  };
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    results[c].too_slow = slow.count(contenders[c].name) != 0;
    const auto begin = std::clock();
    if (!results[c].too_slow) contenders[c].begin(motion.boxes);
    if (seconds(begin) > patience / 10) slow.insert(contenders[c].name);
  }
  for (std::size_t frame = 0; frame < frames + 1; ++frame) {
    motion.step();
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      if (results[c].too_slow) continue;
      contenders[c].convert(motion.boxes);
      const auto begin = std::clock();
      results[c].pairs = contenders[c].frame(motion.boxes, motion.moved);
      const double time = seconds(begin);
      if (frame > 0)
        results[c].times.push_back(time);
      else
        results[c].too_slow = time > patience;
      if (time > patience / 10) slow.insert(contenders[c].name);
    }
  }
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    Result& r = results[c];
    std::printf("| %-9s | %7zu | %-18s |", scene.name, count, contenders[c].name.c_str());
    if (r.too_slow) {
      std::printf("  too slow |           |          |       |\n");
      continue;
    }
    const auto middle = r.times.begin() + static_cast<std::ptrdiff_t>(r.times.size() / 2);
    std::nth_element(r.times.begin(), middle, r.times.end());
    const std::size_t memory = contenders[c].memory();
    const double mean = std::accumulate(r.times.begin(), r.times.end(), 0.0) / static_cast<double>(r.times.size());
    std::printf(" %9.3f | %9.3f | %8zu |", *middle * 1e3, mean * 1e3, r.pairs);
    if (memory > 0)
      std::printf(" %5zu |\n", memory / count);
    else
      std::printf("     ? |\n");
  }
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  std::size_t largest = 100000, frames = 9;
  std::string filter = ".*", only = ".*";
  CommandLine("Broad phases side by side: update and the whole set of pairs, every frame, on one thread.")
      .number("--largest", largest, "boxes at most")
      .number("--frames", frames, "of which the median is taken")
      .expression("--filter", filter, "only structures and libraries whose names match")
      .expression("--scene", only, "only these scenes")
      .read(argc, argv);
  const auto make = [&] {
    std::vector<Contender> all{pair_finder(),
                               pair_finder_in_double(),
                               structure("dynamic tree", make_dynamic_tree<float>),
                               structure("dynamic tree moved", make_dynamic_tree<float>, Asked::moved),
                               changes(),
                               structure("sort+sweep", make_sort_and_sweep<float>),
                               structure("sweep+prune", make_sweep_and_prune<float>),
                               structure("hashed grid", make_hashed_grid<float>),
                               structure("loose octree", make_loose_octree<float>),
                               structure("bsp", make_bsp<float>)};
#ifdef GRAZE_BENCH_BULLET
    all.push_back(bullet("bullet dbvt", bullet_tree));
    all.push_back(bullet("bullet sap", bullet_sweep));
#endif
#ifdef GRAZE_BENCH_FCL
    all.push_back(fcl_tree());
#endif
    std::erase_if(all, [&](const Contender& c) { return !std::regex_search(c.name, std::regex(filter)); });
    return all;
  };
  std::printf("| scene     |   boxes | structure          |  ms/frame |      mean |    pairs | B/box |\n");
  std::printf("|-----------|--------:|--------------------|----------:|----------:|---------:|------:|\n");
  for (const Scene& scene : scenes) {
    if (!std::regex_search(scene.name, std::regex(only))) continue;
    std::set<std::string> slow;
    for (std::size_t count = 1000; count <= largest; count *= 10) {
      auto contenders = make();
      run_scene(scene, count, frames, contenders, slow);
    }
  }
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
