// A sweep over configurations of a chain, beside every distance of it alone; with as many ranks as it is started by.
//
//   mpirun -n RANKS mpi_configurations_test FOLDER
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "graze/mpi/configurations.hpp"
#include "graze/query.hpp"

namespace {

using namespace graze;

int rank = 0;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "FAILED on rank %d: %s\n", rank, what.c_str());
  MPI_Abort(MPI_COMM_WORLD, 1);
  std::abort();
}

constexpr std::size_t links = 3, count = 1500, bad = 700;

template <class T>
struct Scene {
  Scene() {
    chain.links = {Capsule<T>(T(1), T(0.2), T(0.1)), Box<T>({T(0.3), T(0.5), T(0.4)}), Sphere<T>(T(0.3))};
    chain.pairs = {{0, 2}};
    std::mt19937 random(5);
    const auto number = [&] { return static_cast<T>(static_cast<double>(random() % 2000) / 200 - 5); };
    for (int i = 0; i < 25; ++i) {
      Body<T> body{Box<T>({T(0.5), T(0.3), T(0.2)}), {{number(), number(), number()}, {}}};
      body.fixed = true;
      bodies.push_back(body);
      world.add(body);
    }
    world.update();
  }
  std::vector<Body<T>> bodies;
  World<T> world;
  mpi::Chain<T> chain;
};

void write_poses(const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  std::mt19937 random(6);
  const auto number = [&] { return static_cast<double>(random() % 100000) / 10000 - 5; };
  for (std::size_t i = 0; i < count * links; ++i) {
    double n[7];
    for (double& x : n) x = number();
    n[6] += 20;
    if (i == bad * links + 1) n[2] = std::nan("");
    out.write(reinterpret_cast<const char*>(n), sizeof n);
  }
}

template <class T>
std::vector<Pose<T>> read_poses(const std::string& file, std::size_t configuration) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(configuration * links * 7 * sizeof(double)));
  std::vector<Pose<T>> poses;
  for (std::size_t i = 0; i < links; ++i) {
    double n[7];
    in.read(reinterpret_cast<char*>(n), sizeof n);
    poses.push_back(
        {{static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2])},
         normalized(Quat<T>{static_cast<T>(n[3]), static_cast<T>(n[4]), static_cast<T>(n[5]), static_cast<T>(n[6])})});
  }
  return poses;
}

/// The least of all distances, each asked for by itself.
template <class T>
double least_distance(const Scene<T>& scene, const std::vector<Pose<T>>& poses) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links; ++i)
    for (const Body<T>& b : scene.bodies)
      best = std::min(best, static_cast<double>(distance(scene.chain.links[i], poses[i], b.shape, b.pose).distance));
  for (const auto& [a, b] : scene.chain.pairs)
    best = std::min(
        best, static_cast<double>(distance(scene.chain.links[a], poses[a], scene.chain.links[b], poses[b]).distance));
  return best;
}

template <class T>
void compare(const std::string& folder) {
  const Scene<T> scene;
  mpi::SweepSettings settings;
  settings.questions = folder + "/poses";
  settings.out = folder + "/nearest";
  settings.kind = "test";
  const mpi::SweepReport report =
      mpi::sweep_configurations<T>(MPI_COMM_WORLD, settings, scene.chain, scene.world, std::cout);
  if (report.lines != count || report.errors != 1) fail("another number of configurations");
  if (rank != 0) return;
  std::ifstream in(settings.out, std::ios::binary);
  std::vector<mpi::NearestOfChain> answers(count + 1);
  in.read(reinterpret_cast<char*>(answers.data()), static_cast<std::streamsize>(answers.size() * sizeof answers[0]));
  if (in.gcount() != static_cast<std::streamsize>(count * sizeof answers[0])) fail("another number of answers");
  std::size_t overlaps = 0, own = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == bad) {
      if (!std::isnan(answers[i].distance)) fail("an answer to what is no pose");
      continue;
    }
    const std::vector<Pose<T>> poses = read_poses<T>(settings.questions, i);
    const mpi::NearestOfChain wanted = mpi::nearest_of_chain<T>(scene.chain, scene.world, poses);
    if (std::memcmp(&wanted, &answers[i], sizeof wanted) != 0) fail("another answer than that of one process");
    const double least = least_distance(scene, poses);
    constexpr double part = sizeof(T) == sizeof(float) ? 1e-4 : 1e-9;  // of sizes near 1, in each precision
    if (!(std::abs(wanted.distance - least) <= part)) fail("not the least distance");
    overlaps += least < 0;
    own += wanted.other < links;
    const mpi::NearestOfChain near =
        mpi::nearest_of_chain<T>(scene.chain, scene.world, poses, static_cast<T>(least / 2));
    if (least > 0 && near.distance < std::numeric_limits<double>::infinity()) fail("what is beyond the limit");
  }
  if (overlaps < 20 || own < 20)
    fail("poses in which too little happens: " + std::to_string(overlaps) + ", " + std::to_string(own));
}

template <class F>
void expect_common_error(const std::string& words, F&& f) {
  try {
    f();
  } catch (const mpi::CommonError& e) {
    if (std::string(e.what()).find(words) == std::string::npos) fail(e.what());
    return;
  }
  fail("no error: " + words);
}

void refuse(const std::string& folder) {
  Scene<double> scene;
  mpi::SweepSettings settings;
  settings.questions = folder + "/poses";
  settings.out = folder + "/none";
  const auto sweep = [&] {
    mpi::sweep_configurations<double>(MPI_COMM_WORLD, settings, scene.chain, scene.world, std::cout);
  };
  scene.chain.links.push_back(Sphere<double>(1));
  scene.chain.links.push_back(Sphere<double>(1));
  scene.chain.links.push_back(Sphere<double>(1));
  scene.chain.links.push_back(Sphere<double>(1));
  expect_common_error("records of 392 bytes each", sweep);
  scene.chain.pairs = {{0, 7}};
  expect_common_error("chain.pairs: expected two links below 7, got 7 and 0", [&] {
    std::swap(scene.chain.pairs[0].first, scene.chain.pairs[0].second);
    sweep();
  });
  scene.chain = {};
  expect_common_error("chain.links: expected at least one", sweep);
  if (std::filesystem::exists(settings.out)) fail("an answer to what was refused");
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::string folder = argc > 1 ? argv[1] : ".";
  if (rank == 0) {
    std::filesystem::create_directories(folder);
    write_poses(folder + "/poses");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  compare<double>(folder);
  compare<float>(folder);
  refuse(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == 0) std::filesystem::remove_all(folder);
  MPI_Finalize();
}
