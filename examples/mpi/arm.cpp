// A robot's arm in ever other poses: which of them are free? Answered by all ranks, in order, with a journal.
//
//   mpirun -n 4 example_mpi_arm poses.bin nearest.bin [COUNT]
//
// writes COUNT random poses (100,000) if poses.bin is not there, and what is nearest in each to nearest.bin.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "graze/mpi/configurations.hpp"

namespace {

constexpr int joints = 5;
constexpr double length = 0.5;

/// Capsules along Y, each from its joint on.
graze::mpi::Chain<double> make_arm() {
  graze::mpi::Chain<double> arm;
  for (std::uint32_t i = 0; i < joints; ++i) {
    arm.links.emplace_back(graze::Capsule<double>(length, 0.06, 0.06));
    for (std::uint32_t k = 0; k + 2 <= i; ++k) arm.pairs.emplace_back(k, i);
  }
  return arm;
}

/// A floor, and posts around the arm.
void make_room(graze::World<double>& room) {
  graze::Body<double> floor{graze::HalfSpace<double>(), {{0, -0.1, 0}, {}}};
  floor.fixed = true;
  room.add(floor);
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 0.7, away = 0.6 + 0.07 * i;
    graze::Body<double> post{graze::Box<double>({0.1, 0.4 + 0.1 * (i % 7), 0.1}),
                             {{away * std::cos(angle), 0.3, away * std::sin(angle)}, {}}};
    post.fixed = true;
    room.add(post);
  }
  room.update();
}

/// The poses of the links for random angles: each joint turns about X and Y of the link before.
void write_poses(const char* file, std::size_t count) {
  std::ofstream out(file, std::ios::binary);
  std::mt19937_64 random(1);
  const auto angle = [&] { return (static_cast<double>(random() >> 11) / 9007199254740992.0 - 0.5) * 3; };
  for (std::size_t n = 0; n < count; ++n) {
    graze::Posed joint;
    for (int i = 0; i < joints; ++i) {
      const double x = angle() / 2, y = angle() / 2;
      const graze::Quatd turn =
          graze::Quatd{0, std::sin(y), 0, std::cos(y)} * graze::Quatd{std::sin(x), 0, 0, std::cos(x)};
      joint.rotation = graze::normalized(joint.rotation * turn);
      const graze::Vec3d middle = graze::transform(joint, {0, length / 2, 0});
      const graze::Quatd& q = joint.rotation;
      const double numbers[] = {middle.x, middle.y, middle.z, q.x, q.y, q.z, q.w};
      out.write(reinterpret_cast<const char*>(numbers), sizeof numbers);
      joint.translation = graze::transform(joint, {0, length, 0});
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    if (argc < 3) throw std::runtime_error("example_mpi_arm POSES NEAREST [COUNT]");
    if (rank == 0 && !std::filesystem::exists(argv[1]))
      write_poses(argv[1], argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 100000);
    MPI_Barrier(MPI_COMM_WORLD);
    graze::World<double> room;
    make_room(room);
    graze::mpi::SweepSettings settings;
    settings.questions = argv[1];
    settings.out = argv[2];
    settings.kind = "example_mpi_arm 1";
    const graze::mpi::SweepReport report =
        graze::mpi::sweep_configurations<double>(MPI_COMM_WORLD, settings, make_arm(), room, std::cout);
    if (rank == 0) {
      std::ifstream in(argv[2], std::ios::binary);
      std::size_t free = 0;
      for (graze::mpi::NearestOfChain n; in.read(reinterpret_cast<char*>(&n), sizeof n);) free += n.distance > 0;
      std::printf("%zu of %llu poses are free\n", free, static_cast<unsigned long long>(report.lines));
    }
  } catch (const graze::mpi::CommonError& e) {
    if (rank == 0) std::fprintf(stderr, "%s\n", e.what());
    MPI_Finalize();
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "rank %d: %s\n", rank, e.what());
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  MPI_Finalize();
}
