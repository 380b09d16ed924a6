// Command lines, where the parser passes over what nobody meant or says too little of it.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace graze::cli {

/// Refuses an empty text for any option of the program's commands. The parser would take it for zero, the command for
/// an option that was not given, and it is what a variable of the shell has that was never set.
void refuse_empty_values(CLI::App& app);

/// The error of a first word that names no command: "walk: no such command; there are ...". Empty for one that does.
std::string unknown_command(CLI::App& app, int argc, char** argv);

}  // namespace graze::cli
