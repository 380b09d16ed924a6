// Are seams of the plane felt? How often a body that slides over a floor of pieces meets something else than a
// half-plane: `tests/common/plane_slides.hpp` says which floors, bodies and poses.
//
//   bench_slides [--poses N] [--filter REGEX] [--double] [--show]
//
// A row is a floor where it stands: at the origin, turned there, or turned and far away.
#include <cstdio>
#include <map>
#include <regex>

#include "command_line.hpp"
#include "common/plane_slides.hpp"

namespace {

using namespace graze::plane;
using namespace graze::plane::slides;

struct Options {
  std::size_t poses = 1000000;
  std::string filter = ".*";
  bool doubles = false, show = false;
};

template <class T>
void print_table(const Options& options) {
  Random random(1);
  const std::vector<Floor<T>> all_floors = floors<T>(random);
  const std::vector<Slider<T>> bodies = sliders<T>();
  const Rot2<T> turn = Rot2<T>::from_angle(T(0.7));
  const std::pair<const char*, Pose2<T>> frames[] = {
      {"", {}}, {", turned", {{}, turn}}, {", far", {{T(20), T(-30)}, turn}}};
  const std::size_t each = options.poses / (all_floors.size() * bodies.size() * 3) + 1;
  std::printf("| floor, %s | poses | leaning | nothing | other points | bodies |\n|---|--:|--:|--:|--:|---|\n",
              std::is_same_v<T, float> ? "float" : "double");
  Faults sum;
  for (const Floor<T>& floor : all_floors)
    for (const auto& [where, frame] : frames) {
      const std::string name = std::string(floor.name) + where;
      if (!std::regex_search(name, std::regex(options.filter))) continue;
      Faults row;
      std::string at_fault;
      Random of_row(2);  // so that a row is the same whatever is left out
      for (const Slider<T>& body : bodies) {
        const Faults found = slide(floor, body, frame, each, of_row, [&](const Pose2<T>& at) {
          if (options.show)
            std::printf("  %s on %s at (%.9g, %.9g), turned (%.9g, %.9g)\n", body.name, name.c_str(),
                        double(at.translation.x), double(at.translation.y), double(at.rotation.cosine),
                        double(at.rotation.sine));
        });
        row.poses += found.poses, row.leaning += found.leaning, row.nothing += found.nothing, row.other += found.other;
        if (found.all() > 0)
          at_fault += (at_fault.empty() ? "" : ", ") + std::string(body.name) + " " + std::to_string(found.all());
      }
      std::printf("| %s | %zu | %zu | %zu | %zu | %s |\n", name.c_str(), row.poses, row.leaning, row.nothing, row.other,
                  at_fault.c_str());
      std::fflush(stdout);
      sum.poses += row.poses, sum.leaning += row.leaning, sum.nothing += row.nothing, sum.other += row.other;
    }
  std::printf("| all | %zu | %zu | %zu | %zu | |\n", sum.poses, sum.leaning, sum.nothing, sum.other);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  graze::bench::CommandLine("How often seams of floors in the plane are felt.")
      .number("--poses", options.poses, "poses in all")
      .expression("--filter", options.filter, "floors to look at")
      .flag("--double", options.doubles, "in double precision alone, else in single alone")
      .flag("--show", options.show, "each pose at fault")
      .read(argc, argv);
  options.doubles ? print_table<double>(options) : print_table<float>(options);
}
