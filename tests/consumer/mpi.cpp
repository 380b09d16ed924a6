// Two boxes in a world of as many ranks as there are.
#include <graze/graze.hpp>
#include <graze/mpi/world.hpp>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, failed = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  {
    graze::mpi::World<double> world(MPI_COMM_WORLD);
    const graze::Shaped box = graze::Box<double>({1, 1, 1});
    if (rank == 0) {
      world.add(1, {box});
      world.add(2, {box, {{0, 0.5, 0}, {}}});
    }
    world.update();
    const graze::mpi::Gathered<double> found = world.gather();
    if (rank == 0) failed = found.pairs.size() == 1 && found.events.size() == 1 && found.pairs[0].b == 2 ? 0 : 1;
  }
  MPI_Finalize();
  return failed;
}
