// The program for many machines: one process a rank, started by mpirun.
//
// Guarantee: no rank waits for one that has failed. An error that all ranks share is reported once, and they end in
// order; an error of one rank alone is reported with its number and ends all.
#include <fmt/format.h>
#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "cli/command_line.hpp"
#include "cli/output.hpp"
#include "graze/mpi/sweep.hpp"
#include "mpi/commands.hpp"
#include "mpi/exchange.hpp"

namespace {

using namespace graze::cli;

constexpr int cannot_work = 2;

/// MPI from here to the end of the program.
class Mpi {
 public:
  Mpi(int& argc, char**& argv) {
    int given = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  }
  ~Mpi() { MPI_Finalize(); }
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;

  int rank = 0;
};

int run(int argc, char** argv, int rank) {
  CLI::App app{"Graze on many machines: start it by mpirun"};
  app.name("graze-mpi");
  app.set_version_flag("--version", "graze-mpi " GRAZE_VERSION);
  app.require_subcommand(1);
  app.footer("Examples:\n  mpirun -n 8 graze-mpi collide city.gltf --svg owners.svg\n  mpirun -n 8 graze-mpi query "
             "questions.jsonl --out answers.jsonl");
  const std::pair<const char*, Run> commands[] = {{"collide", add_collide(app)}, {"query", add_query(app)}};
  refuse_empty_values(app);
  // Ranks would wait for each other if only some of them could go on.
  const auto agree_on_command_line = [](const std::string& said) {
    graze::mpi::agree_on(MPI_COMM_WORLD, "the command line", said);
  };
  if (const std::string error = unknown_command(app, argc, argv); !error.empty()) {
    agree_on_command_line(error);
    if (rank == 0) fmt::print(stderr, "graze-mpi: {}\n", error);
    return cannot_work;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    agree_on_command_line(e.what());
    // All ranks have the same command line: one of them reports the error in it, or prints the help.
    graze::mpi::Together together(MPI_COMM_WORLD);
    together.alone([&] {
      if (rank == 0) app.exit(e);
      flush_output();
    });
    together.meet();
    return e.get_exit_code() == 0 ? 0 : cannot_work;
  }
  agree_on_command_line("one that can be used");
  for (const auto& [name, act] : commands)
    if (app.got_subcommand(name)) {
      graze::mpi::agree_on(MPI_COMM_WORLD, "the program", std::string("graze-mpi " GRAZE_VERSION " ") + name);
      return act();
    }
  return cannot_work;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that has become too long is an error of the write, with the file's name in it.
  std::signal(SIGXFSZ, SIG_IGN);
  Mpi mpi(argc, argv);
  try {
    return run(argc, argv, mpi.rank);
  } catch (const graze::mpi::CommonError& e) {
    if (mpi.rank == 0) fmt::print(stderr, "graze-mpi: {}\n", e.what());
    return cannot_work;
  } catch (const std::exception& e) {
    fmt::print(stderr, "graze-mpi: rank {}: {}\n", mpi.rank, e.what());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, cannot_work);
    return cannot_work;
  }
}
