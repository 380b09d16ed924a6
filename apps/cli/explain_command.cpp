// graze explain: one question of the protocol, with everything that was done to answer it.
#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/explain.hpp"

namespace graze::cli {

namespace {

struct ExplainArguments {
  std::string file, precision = "double", svg;
  std::size_t line = 1;
  std::vector<double> direction{1, 0.6, 1.4};
};

/// The line that is asked for, counted from 1 among those that are not blank.
std::string question_line(const ExplainArguments& options) {
  std::ifstream file;
  const bool standard = options.file.empty() || options.file == "-";
  const std::string name = standard ? "standard input" : options.file;
  if (!standard) file.open(options.file, std::ios::binary);
  std::istream& in = standard ? std::cin : file;
  if (!in) throw InvalidValue(name, "a file that can be read", "an error");
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r\n\v\f") != std::string::npos && ++count == options.line) return line;
  throw InvalidValue(name, fmt::format("a question as line {}", options.line), fmt::format("{} lines", count));
}

int run_explain(const ExplainArguments& options) {
  const Vec3d direction = checked_direction(options.direction);
  const io::Explanation explanation = io::explain(question_line(options), precision_of(options.precision));
  fmt::print("{}", io::explanation_text(explanation));
  if (options.svg.empty()) return 0;
  std::ofstream out(options.svg, std::ios::binary);
  out << io::draw_explanation(explanation, direction);
  out.close();
  if (!out) throw InvalidValue(options.svg, "a file that can be written", "an error");
  return 0;
}

}  // namespace

Run add_explain(CLI::App& app) {
  auto options = std::make_shared<ExplainArguments>();
  CLI::App* command = app.add_subcommand("explain", "Show how a question is answered, as a table and as a picture");
  command->add_option("FILE", options->file, "Questions, one JSON object a line (default: standard input)");
  command->add_option("--line", options->line, "Which question of the file, counted from 1")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--svg", options->svg, "Draw the shapes, the axes and the contacts (.svg)");
  command->add_option("--direction", options->direction, "Where the picture is seen from, about: x,y,z")
      ->delimiter(',')
      ->expected(3)
      ->capture_default_str();
  command->footer("Exit code: 0, or 2 when the question or a file is at fault.\n\n"
                  "Example:\n"
                  "  echo '{\"query\": \"contacts\", \"a\": {\"shape\": {\"type\": \"box\"}}, \"b\": {\"shape\": "
                  "{\"type\": \"box\"},\n"
                  "         \"translation\": [0.2, 0.9, 0], \"rotation\": [0, 0.2, 0, 1]}}' | tr -d '\\n' | graze "
                  "explain --svg why.svg");
  return [options] { return run_explain(*options); };
}

}  // namespace graze::cli
