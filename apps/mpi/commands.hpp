// The commands of graze-mpi, one file each. Each adds itself to the command line and returns what runs it.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace graze::cli {

/// The work of the command that was chosen, on every rank; returns the exit code.
using Run = std::function<int()>;

Run add_collide(CLI::App& app);
Run add_query(CLI::App& app);

}  // namespace graze::cli
