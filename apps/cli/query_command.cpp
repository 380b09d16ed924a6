// graze query: the query protocol on files and pipes.
#include <unistd.h>

#include <iostream>
#include <optional>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/protocol.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

namespace {

/// Answers all questions; returns the exit code.
int answer_all(std::istream& in, const std::string& name, io::Precision precision) {
  // Answers on the same terminal would be mixed up with the line of progress, and are progress enough.
  std::optional<Progress> progress;
  if (isatty(STDOUT_FILENO) == 0) progress.emplace("answering");
  const std::size_t errors = io::answer_stream(in, std::cout, precision);
  if (in.bad()) throw InvalidValue(name, "", "cannot be read to its end");
  return errors == 0 ? 0 : 1;
}

}  // namespace

Run add_query(CLI::App& app) {
  struct Options {
    std::string file, precision = "double";
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("query", "Answer questions in JSON, one a line")->alias("response");
  command->add_option("FILE", options->file, "Questions, one JSON object a line (default: standard input)");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->footer(
      "Queries: overlap, distance, contacts, raycast, cast, closest, response. Exit code: 0 when every line was\n"
      "answered, 1 when an answer was an error, 2 when a file cannot be read or standard output cannot be written.\n"
      "graze response is another name of this command, for the questions that docs/resolution.md explains.\n\n"
      "Example:\n"
      "  echo '{\"query\": \"closest\", \"a\": {\"shape\": {\"type\": \"box\"}}, \"point\": [2, 0, 0]}' | graze query");
  return [options] {
    const io::Precision precision = precision_of(options->precision);
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    if (options->file.empty() || options->file == "-") return answer_all(std::cin, "standard input", precision);
    std::ifstream file = io::open_file(options->file);
    return answer_all(file, options->file, precision);
  };
}

}  // namespace graze::cli
