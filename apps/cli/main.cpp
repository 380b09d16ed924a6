// The program: one command a file.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <system_error>

#include "commands.hpp"
#include "output.hpp"

namespace {

using namespace graze::cli;

constexpr int cannot_work = 2;

/// The first word of the command line that is no option, if it names no command.
const char* unknown_command(CLI::App& app, int argc, char** argv) {
  const auto word = std::find_if(argv + 1, argv + argc, [](const char* argument) { return argument[0] != '-'; });
  const auto commands = app.get_subcommands({});
  const auto named = [&](const CLI::App* command) { return command->check_name(*word); };
  return word == argv + argc || std::any_of(commands.begin(), commands.end(), named) ? nullptr : *word;
}

std::string names_of_commands(CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

/// Refuses an empty text for any option of a command. The parser would take it for zero, the command for an option that
/// was not given, and it is what a variable of the shell has that was never set.
void refuse_empty_values(CLI::App& command) {
  const auto refusing = [](const char* what) {
    return CLI::Validator([what](const std::string& text) { return text.empty() ? what : std::string(); }, "");
  };
  static const CLI::Validator number = refusing("expected a number, got nothing"),
                              name = refusing("expected a name, got nothing");
  for (CLI::Option* option : command.get_options([](const CLI::Option* o) { return o->get_type_size() > 0; })) {
    const std::string type = option->get_type_name();
    option->check(type == "FLOAT" || type == "INT" || type == "UINT" ? number : name);
  }
}

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
  for (CLI::App* command : app.get_subcommands({})) {
    command->add_flag("-q,--quiet", quiet(), "Neither notes nor progress, only the answer and errors");
    refuse_empty_values(*command);
  }
  if (argc < 2) {
    fmt::print("{}", app.help());
    return 0;
  }
  if (const char* word = unknown_command(app, argc, argv)) {
    fmt::print(stderr, "graze: {}: no such command; there are {} (graze --help)\n", word, names_of_commands(app));
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
