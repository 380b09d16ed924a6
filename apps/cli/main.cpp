// The program: one command a file.
#include <cstdio>
#include <exception>

#include "commands.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Graze: do these things touch, where, how deep, how far apart"};
  app.name("graze");
  app.set_version_flag("--version", "graze " GRAZE_VERSION);
  app.require_subcommand(1);
  app.footer("graze COMMAND --help explains a command, with an example.");

  const std::pair<const char*, graze::cli::Run> commands[] = {
      {"cast", graze::cli::add_cast(app)},       {"collide", graze::cli::add_collide(app)},
      {"explain", graze::cli::add_explain(app)}, {"info", graze::cli::add_info(app)},
      {"query", graze::cli::add_query(app)},
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // The command line is input like any other: 2 for what cannot be read, 0 for --help and --version.
    return app.exit(e) == 0 ? 0 : 2;
  }
  try {
    for (const auto& [name, run] : commands)
      if (app.got_subcommand(name)) return run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "graze: %s\n", e.what());
    return 2;
  }
  return 2;
}
