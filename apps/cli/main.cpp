// The program: one command a file.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <system_error>

#include "command_line.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace {

using namespace graze::cli;

constexpr int cannot_work = 2;

/// Parses the command line and runs its command; returns the exit code.
int run(int argc, char** argv) {
  CLI::App app{"Graze: do these things touch, where, how deep, how far apart"};
  app.name("graze");
  app.set_version_flag("--version", "graze " GRAZE_VERSION);
  app.require_subcommand(1);
  app.footer("graze COMMAND --help explains a command, with an example.");

  const std::pair<const char*, Run> commands[] = {
      {"capture", add_capture(app)}, {"cast", add_cast(app)},         {"collide", add_collide(app)},
      {"explain", add_explain(app)}, {"info", add_info(app)},         {"query", add_query(app)},
      {"replay", add_replay(app)},   {"simulate", add_simulate(app)}, {"view", add_view(app)},
  };
  for (CLI::App* command : app.get_subcommands({}))
    command->add_flag("-q,--quiet", quiet(), "Neither notes nor progress, only the answer and errors");
  refuse_empty_values(app);
  if (argc < 2) {
    fmt::print("{}", app.help());
    return 0;
  }
  if (const std::string error = unknown_command(app, argc, argv); !error.empty()) {
    fmt::print(stderr, "graze: {}\n", error);
    return cannot_work;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // The command line is input like any other: 2 where it cannot be read, 0 for --help and --version.
    return app.exit(e) == 0 ? 0 : cannot_work;
  }
  for (const auto& [name, act] : commands)
    if (app.got_subcommand(name)) return act();
  return cannot_work;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    flush_output();
    return code;
  } catch (const std::system_error& e) {
    // Printing what no buffer holds fails by itself, and its error names no file.
    std::fprintf(stderr, "graze: %s\n",
                 (std::ferror(stdout) ? std::system_error(e.code(), unwritten_output) : e).what());
    return cannot_work;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "graze: %s\n", e.what());
    return cannot_work;
  }
}
