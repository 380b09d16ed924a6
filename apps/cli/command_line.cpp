#include "command_line.hpp"

#include <algorithm>

namespace graze::cli {

namespace {

/// Refuses an empty text with these words.
CLI::Validator refusing_empty(const char* words) {
  return {[words](const std::string& text) { return text.empty() ? words : std::string(); }, ""};
}

}  // namespace

void refuse_empty_values(CLI::App& app) {
  static const CLI::Validator number = refusing_empty("expected a number, got nothing"),
                              name = refusing_empty("expected a name, got nothing");
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options([](const CLI::Option* o) { return o->get_type_size() > 0; })) {
      const std::string type = option->get_type_name();
      option->check(type == "FLOAT" || type == "INT" || type == "UINT" ? number : name);
    }
}

std::string unknown_command(CLI::App& app, int argc, char** argv) {
  const auto word = std::find_if(argv + 1, argv + argc, [](const char* argument) { return argument[0] != '-'; });
  if (word == argv + argc) return {};
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->check_name(*word)) return {};
    std::vector<std::string> own = command->get_aliases();
    own.insert(own.begin(), command->get_name());
    for (const std::string& name : own) names += (names.empty() ? "" : ", ") + name;
  }
  return *word + (": no such command; there are " + names + " (" + app.get_name() + " --help)");
}

}  // namespace graze::cli
