// What engines do with contacts: towers, pyramids, masses, slopes, bounces, spins, cards, piles, bullets and sizes, in
// Graze (float and double), and in Bullet and ODE as the system has them. Writes a Markdown table.
//
//   bench_resolution [--rows REGEX] [--quick] > bench/RESOLUTION.md
//
// 60 steps a second, g = 10 m/s², density 1000 kg/m³, friction 0.6, each engine's default solver, sleep off but where
// a row says so. What holds of all engines is computed here from poses and velocities alone; depths by contacts in
// double precision. Box3D and Jolt are quoted and not run: their figures were measured on another occasion on scenes of
// the same description; where a scene's layout matters (g, h) they are a hint and no comparison.
#include <cstdio>
#include <regex>

#include "command_line.hpp"
#include "resolution_scenes.hpp"
#include "table.hpp"

int main(int argc, char** argv) {
  using namespace graze::bench;
  std::string wanted = ".*";
  bool quick = false;
  CommandLine("Runs scenes of bodies in several engines and tells how they resolve contacts.")
      .expression("--rows", wanted, "only rows in whose name this is found")
      .flag("--quick", quick, "without the tallest towers and the pile")
      .read(argc, argv);
  const auto kinds = engine_kinds();
  std::vector<std::string> head{"Row", "Target"};
  for (const EngineKind& kind : kinds) head.push_back(kind.name);
  head.insert(head.end(), {"Box3D (quoted)", "Jolt (quoted)"});
  Table table(head, 2);
  const std::regex expression(wanted);
  for (const ResolutionRow& row : resolution_rows(!quick)) {
    if (!std::regex_search(row.what, expression)) continue;
    std::vector<std::string> line{row.what, row.target};
    for (const EngineKind& kind : kinds) {
      std::fprintf(stderr, "%s: %s\n", kind.name.c_str(), row.what.c_str());
      line.push_back(row.measure(kind));
    }
    line.push_back(row.box3d);
    line.push_back(row.jolt);
    table.add(line);
  }
  std::printf(
      "# How engines resolve contacts\n\n"
      "Written by `bench_resolution` (`make bench-resolution`). 60 steps a second, g = 10 m/s², density 1000\n"
      "kg/m³, friction 0.6, each engine's default solver, sleep off but where a row says so. Depths are\n"
      "those at the end of a row's run, measured alike for all engines, by contacts in double precision. Times\n"
      "are of one thread, by the processor's clock; what two threads gain is by the clock on the wall. Box3D\n"
      "(`30c67b5`) and Jolt (`3b47ec39`) are quoted from an earlier measurement on scenes of the same\n"
      "description, not run here: where layout matters (g, h) and for times they are a hint and no comparison.\n"
      "`docs/resolution.md` says where a target is missed, and why.\n\n%s",
      table.text().c_str());
}
