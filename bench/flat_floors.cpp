// Do contacts hold still on a floor that is flat but made of pieces?
//
//   bench_flat_floors [--frames N] [--filter REGEX]
//
// A body stands on a floor, about two thousandths deep, and leans by up to two milliradians about a horizontal axis
// that is drawn anew in every frame, as under a solver; it does not travel. A row is a floor and a body: in how many
// of the frames the set of feature numbers differs from the frame before, the fewest and the most points of a frame,
// in how many frames two points of one manifold share a number, in how many there is more than one manifold, and how
// long the contacts of a frame take (the median). Asked with `contact_margin`, in single precision. A box on a box, and
// on a half-space, is what the others are held against.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <regex>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "graze/query.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

constexpr float reach = 3;  ///< floors go at least so far from the origin, in x and z

struct Named {
  std::string name;
  Shapef shape;
};

std::size_t cells_across(float cell) { return static_cast<std::size_t>(std::ceil(2 * reach / cell)); }

Mesh<float> flat_mesh(float cell) {
  const std::size_t n = cells_across(cell), row = n + 1;
  const float half = static_cast<float>(n) * cell / 2;
  std::vector<Vec3f> points;
  for (std::size_t z = 0; z <= n; ++z)
    for (std::size_t x = 0; x <= n; ++x)
      points.push_back({static_cast<float>(x) * cell - half, 0, static_cast<float>(z) * cell - half});
  std::vector<Mesh<float>::Index> triangles;
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t x = 0; x < n; ++x) {
      const auto a = static_cast<std::uint32_t>(z * row + x), b = a + 1, c = static_cast<std::uint32_t>(a + row);
      triangles.push_back({a, c + 1, b});
      triangles.push_back({a, c, c + 1});
    }
  return {std::move(points), std::move(triangles)};
}

HeightField<float> flat_field(float cell) {
  const std::size_t side = cells_across(cell) + 1;
  return {side, side, std::vector<float>(side * side, 0.f), cell, cell};
}

Compound<float> boxes(float cell) {
  const std::size_t n = cells_across(cell);
  const float half = static_cast<float>(n) * cell / 2;
  std::vector<Placed<float>> children;
  for (std::size_t z = 0; z < n; ++z)
    for (std::size_t x = 0; x < n; ++x) {
      const Vec3f middle{(static_cast<float>(x) + 0.5f) * cell - half, -0.5f,
                         (static_cast<float>(z) + 0.5f) * cell - half};
      children.push_back({Box<float>({cell, 1, cell}), {middle, {}}});
    }
  return Compound<float>(std::move(children));
}

std::vector<Named> floors() {
  std::vector<Named> all{{"half-space", HalfSpace<float>()},
                         {"box", Compound<float>({{Box<float>({6, 1, 6}), {{0, -0.5f, 0}, {}}}})}};
  for (const float cell : {3.f, 1.f, 0.37f, 0.11f, 0.05f}) {
    char name[32];
    std::snprintf(name, sizeof name, "mesh %.2f", static_cast<double>(cell));
    all.push_back({name, flat_mesh(cell)});
  }
  for (const float cell : {1.f, 0.37f, 0.11f}) {
    char name[32];
    std::snprintf(name, sizeof name, "field %.2f", static_cast<double>(cell));
    all.push_back({name, flat_field(cell)});
  }
  all.push_back({"boxes 1.00", boxes(1)});
  return all;
}

/// What stands on them, and the height of its middle when it just touches.
struct Standing {
  std::string name;
  Shapef shape;
  float height;
  Quatf turn;
};

std::vector<Standing> bodies() {
  const Quatf lying = normalized(Quatf{0, 0, 1, 1});
  const Quatf yaw = normalized(Quatf{0, 0.1f, 0, 1});  // aside of the lines of every floor
  return {{"box", Box<float>({1, 1, 1}), 0.5f, yaw},
          {"aligned box", Box<float>({1, 1, 1}), 0.5f, {}},
          {"rounded box", Shapef(Box<float>({0.8f, 0.8f, 0.8f}), 0.1f), 0.5f, yaw},
          {"aligned rounded box", Shapef(Box<float>({0.8f, 0.8f, 0.8f}), 0.1f), 0.5f, {}},
          {"cylinder", Cylinder<float>(1, 0.5f), 0.5f, yaw},
          {"lying capsule", Capsule<float>(1, 0.3f), 0.3f, yaw * lying}};
}

struct Row {
  std::size_t changes = 0, repeats = 0, split = 0, fewest = ~std::size_t{0}, most = 0;
  std::vector<double> microseconds;  ///< of each frame
};

Row measure(const Shapef& floor, const Standing& body, std::size_t frames) {
  constexpr double lean = 0.002, depth = 0.002, full_turn = 6.283185307179586;
  Random random(11);
  const float margin = contact_margin(floor, body.shape);
  Row row;
  std::vector<std::uint32_t> last;
  Manifolds<float> manifolds;
  for (std::size_t i = 0; i < frames; ++i) {
    const double about = random.number(0, full_turn), half = random.number(0, lean) / 2;
    const Quatf tilt =
        normalized(Quatf{static_cast<float>(std::cos(about) * half), 0, static_cast<float>(std::sin(about) * half), 1});
    const auto deep = static_cast<float>(depth * random.number(0.9, 1.1));
    const Posef pose{{0.13f, body.height - deep, 0.07f}, normalized(tilt * body.turn)};
    manifolds.clear();
    const auto before = std::chrono::steady_clock::now();
    contacts(floor, Posef{}, body.shape, pose, margin, manifolds);
    const auto passed = std::chrono::steady_clock::now() - before;
    row.microseconds.push_back(std::chrono::duration<double, std::micro>(passed).count());
    std::vector<std::uint32_t> ids;
    bool repeats = false;
    for (const Manifold<float>& manifold : manifolds) {
      std::vector<std::uint32_t> own;
      for (const ContactPoint<float>& point : manifold.points) own.push_back(point.feature);
      std::sort(own.begin(), own.end());
      repeats |= std::adjacent_find(own.begin(), own.end()) != own.end();
      ids.insert(ids.end(), own.begin(), own.end());
    }
    std::sort(ids.begin(), ids.end());
    row.repeats += repeats ? 1 : 0;
    row.split += manifolds.size() > 1 ? 1 : 0;
    row.fewest = std::min(row.fewest, ids.size());
    row.most = std::max(row.most, ids.size());
    row.changes += i > 0 && ids != last ? 1 : 0;
    last = std::move(ids);
  }
  return row;
}

double percent(std::size_t part, std::size_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void run(std::size_t frames, const std::string& filter) {
  const std::regex wanted(filter);
  std::printf(
      "| floor | body | frames that change, %% | points | frames with a repeated number, %% | in parts, %% | µs |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (const Named& floor : floors())
    for (const Standing& body : bodies()) {
      if (!std::regex_search(floor.name + "/" + body.name, wanted)) continue;
      Row row = measure(floor.shape, body, frames);
      const auto middle = row.microseconds.begin() + static_cast<std::ptrdiff_t>(frames / 2);
      std::nth_element(row.microseconds.begin(), middle, row.microseconds.end());
      std::printf("| %s | %s | %.2f | %zu to %zu | %.1f | %.1f | %.1f |\n", floor.name.c_str(), body.name.c_str(),
                  percent(row.changes, frames - 1), row.fewest, row.most, percent(row.repeats, frames),
                  percent(row.split, frames), *middle);
    }
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) {
  std::size_t frames = 2000;
  std::string filter = ".";
  graze::bench::CommandLine("Whether the contacts of bodies that lean by milliradians hold still on flat floors.")
      .number("--frames", frames, "frames of each row")
      .expression("--filter", filter, "only the rows whose 'floor/body' it matches")
      .read(argc, argv);
  graze::bench::run(std::max<std::size_t>(frames, 2), filter);
}
