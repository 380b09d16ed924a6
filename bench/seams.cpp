// Are seams felt? How often a body that lies on a flat floor of pieces has another normal than the floor's:
// `tests/common/space_slides.hpp` says which floors, bodies and poses.
//
//   bench_seams [--poses N] [--filter REGEX] [--double] [--show]
//
// A row is a floor where it stands: at the origin, turned there, or turned and far away. Of so many poses with each
// body it counts those with a normal that is wrong by more than a milliradian, and those in which nothing touches, and
// names the bodies at fault.
#include <cstdio>
#include <regex>
#include <string>

#include "command_line.hpp"
#include "common/space_slides.hpp"

namespace {

using namespace graze;
using namespace graze::slides;

struct Options {
  std::size_t poses = 1000;
  std::string filter = ".*";
  bool doubles = false, show = false;
};

template <class T>
void print_table(const Options& options) {
  Random random(1);
  const std::vector<Slider<T>> bodies = sliders<T>(random);
  const std::vector<Floor<T>> all_floors = floors<T>(random);
  const std::regex filter(options.filter);
  std::printf("| floor, %s | poses | wrong normal | nothing | bodies |\n|---|--:|--:|--:|---|\n",
              std::is_same_v<T, float> ? "float" : "double");
  Faults sum;
  for (const Floor<T>& floor : all_floors)
    for (const auto& [where, frame] : places<T>()) {
      const std::string name = std::string(floor.name) + where;
      if (!std::regex_search(name, filter)) continue;
      Faults row;
      std::string at_fault;
      Random of_row(2);  // random numbers of the row alone: it is the same whatever is left out
      for (const Slider<T>& body : bodies) {
        const Faults found =
            lay(floor, body, frame, options.poses, of_row, [&](const Pose<T>& at, T lean, bool touches) {
              if (!options.show) return;
              std::printf("  %s: %s at (%.9g, %.9g, %.9g), turned (%.9g, %.9g, %.9g, %.9g): %.3g off\n", name.c_str(),
                          body.name, double(at.translation.x), double(at.translation.y), double(at.translation.z),
                          double(at.rotation.x), double(at.rotation.y), double(at.rotation.z), double(at.rotation.w),
                          touches ? double(lean) : -1.0);
            });
        row.poses += found.poses, row.leaning += found.leaning, row.nothing += found.nothing;
        const std::size_t faults = found.leaning + found.nothing;
        if (faults > 0)
          at_fault += (at_fault.empty() ? "" : ", ") + std::string(body.name) + " " + std::to_string(faults);
      }
      std::printf("| %s | %zu | %zu | %zu | %s |\n", name.c_str(), row.poses, row.leaning, row.nothing,
                  at_fault.c_str());
      std::fflush(stdout);
      sum.poses += row.poses, sum.leaning += row.leaning, sum.nothing += row.nothing;
    }
  std::printf("| all | %zu | %zu | %zu | |\n\n", sum.poses, sum.leaning, sum.nothing);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  graze::bench::CommandLine("How often seams of flat floors are felt.")
      .number("--poses", options.poses, "poses of each body on each floor in each place")
      .expression("--filter", options.filter, "floors to look at")
      .flag("--double", options.doubles, "in double precision alone, else in single alone")
      .flag("--show", options.show, "each pose at fault")
      .read(argc, argv);
  options.doubles ? print_table<double>(options) : print_table<float>(options);
}
