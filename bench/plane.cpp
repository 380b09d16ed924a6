// The plane beside Debian's Box2D 2.4, on one thread: times are the least of the rounds, in ns a pair.
//
//   bench_plane [--pairs N] [--cached N] [--rounds N] [--scale S] [--steps N] [--scene REGEX]
//
// plane_pairs.hpp says which pairs, plane_contacts.cpp and plane_motion.cpp what is asked, plane_scenes.cpp what
// is played.
#include <cstdio>

#include "command_line.hpp"
#include "plane_pairs.hpp"
#include "plane_scene.hpp"

int main(int argc, char** argv) {
  using namespace graze::plane;
  Options options;
  std::string scenes;
  graze::bench::CommandLine("Contacts, distances, casts and rays in the plane, beside Box2D.")
      .number("--pairs", options.pairs, "pairs of a batch")
      .number("--cached", options.cached, "pairs that are asked about one at a time, over and over")
      .number("--rounds", options.rounds, "rounds, of which the fastest counts")
      .real("--scale", options.scale, "bodies along each side of a scene, times those of the table")
      .number("--steps", options.steps, "steps that a scene is played at most")
      .expression("--scene", scenes, "the scenes alone that match it")
      .read(argc, argv);
  if (!scenes.empty()) {
    print_scenes(scenes, options.scale, options.steps);
    return 0;
  }
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "", "", "contacts", "", "distance", "",
              "overlap", "Box2D", "", "faster", "", "", "");
  std::printf("%-24s %6s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "pair", "meet", "one", "batch", "one", "batch",
              "batch", "manifold", "distance", "one", "batch", "distance", "batch");
  struct Row {
    const char* name;
    Kind a, b;
    double spread;
    bool stacked;
  };
  const Row rows[] = {
      {"circle-circle", Kind::circle, Kind::circle, 1.967, false},
      {"capsule-circle", Kind::capsule, Kind::circle, 1.6, false},
      {"capsule-capsule", Kind::capsule, Kind::capsule, 1.344, false},
      {"box-circle", Kind::box, Kind::circle, 1.75, false},
      {"box-capsule", Kind::box, Kind::capsule, 1.477, false},
      {"box-box", Kind::box, Kind::box, 1.602, false},
      {"rounded box-rounded box", Kind::rounded_box, Kind::rounded_box, 1.602, false},
      {"segment-box", Kind::segment, Kind::box, 1.3, false},
      {"hexagon-hexagon", Kind::hexagon, Kind::hexagon, 1.839, false},
      {"octagon-octagon", Kind::octagon, Kind::octagon, 1.889, false},
      {"hexagon-capsule", Kind::hexagon, Kind::capsule, 1.555, false},
      {"stacked boxes", Kind::box, Kind::box, 1, true},
  };
  for (const Row& row : rows)
    print_contacts_row(options, row.name, make_pairs(row.a, row.b, row.spread, row.stacked, options.pairs));
  print_motion_head();
  std::vector<Pairs> some;
  for (const Row& row : rows) {
    if (row.stacked) continue;
    print_motion_row(options, row.name, make_pairs(row.a, row.b, row.spread, false, options.pairs));
    some.push_back(make_pairs(row.a, row.b, row.spread, false, options.cached));
  }
  print_mixed_casts(options, some);
  print_scenes(".", options.scale, options.steps);
}
