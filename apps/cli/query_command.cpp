// graze query: the query protocol on files and pipes.
#include <cstdio>
#include <fstream>
#include <iostream>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/io/protocol.hpp"

namespace graze::cli {

Run add_query(CLI::App& app) {
  struct Options {
    std::string file, precision = "double";
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("query", "Answer questions in JSON, one a line");
  command->add_option("FILE", options->file, "Questions, one JSON object a line (default: standard input)");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->footer(
      "Queries: overlap, distance, contacts, cast, closest. Exit code: 0 when every line was answered, 1 when an\n"
      "answer was an error, 2 when the file cannot be read.\n\n"
      "Example:\n"
      "  echo '{\"query\": \"closest\", \"a\": {\"shape\": {\"type\": \"box\"}}, \"point\": [2, 0, 0]}' | graze query");
  return [options] {
    const io::Precision precision = precision_of(options->precision);
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    if (options->file.empty() || options->file == "-")
      return io::answer_stream(std::cin, std::cout, precision) == 0 ? 0 : 1;
    std::ifstream file(options->file, std::ios::binary);
    // A directory opens and then cannot be read, which looks like an empty file unless one asks.
    if (!file || (file.peek(), file.bad())) {
      std::fprintf(stderr, "graze: %s: cannot be read\n", options->file.c_str());
      return 2;
    }
    file.clear();
    return io::answer_stream(file, std::cout, precision) == 0 ? 0 : 1;
  };
}

}  // namespace graze::cli
