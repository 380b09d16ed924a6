// The commands of the program, one file each. Each adds itself to the command line and returns what runs it.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace graze::cli {

/// The work of a command that was chosen; returns the exit code.
using Run = std::function<int()>;

Run add_capture(CLI::App& app);
Run add_cast(CLI::App& app);
Run add_collide(CLI::App& app);
Run add_explain(CLI::App& app);
Run add_info(CLI::App& app);
Run add_query(CLI::App& app);
Run add_replay(CLI::App& app);
Run add_simulate(CLI::App& app);
Run add_view(CLI::App& app);

}  // namespace graze::cli
