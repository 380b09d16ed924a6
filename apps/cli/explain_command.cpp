// graze explain: one question of the protocol, with all steps of its answer.
#include <fmt/format.h>

#include <cstdint>
#include <iostream>
#include <optional>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/explain.hpp"
#include "graze/io/file.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

namespace {

struct ExplainArguments {
  std::string file, precision = "double", svg;
  std::optional<std::string> line;
  bool json = false;
  std::vector<double> direction{1, 0.6, 1.4};
};

bool reads_standard_input(const ExplainArguments& options) { return options.file.empty() || options.file == "-"; }
std::string source_of(const ExplainArguments& options) {
  return reads_standard_input(options) ? "standard input" : options.file;
}

/// A question and the number of its line in the file, counted from 1 as in the errors of `query`.
struct QuestionLine {
  std::string text;
  std::size_t number = 0;
};

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r\n\v\f") == std::string::npos; }

/// The question on the line that is asked for, else the first one.
QuestionLine question_line(const ExplainArguments& options) {
  const std::size_t wanted = options.line ? checked_count("--line", *options.line) : 0;
  std::ifstream file;
  const bool standard = reads_standard_input(options);
  const std::string name = source_of(options);
  if (!standard) file = io::open_file(options.file);
  std::istream& in = standard ? std::cin : file;
  QuestionLine line;
  while (std::getline(in, line.text)) {
    ++line.number;
    const bool blank = is_blank(line.text);
    if (wanted == 0 ? !blank : line.number == wanted) {
      if (blank) throw InvalidValue(name, fmt::format("a question as line {}", wanted), "a blank line");
      return line;
    }
  }
  if (in.bad()) throw InvalidValue(name, "", "cannot be read to its end");
  const std::string expected = wanted == 0 ? "a question" : fmt::format("a question as line {}", wanted);
  throw InvalidValue(name, expected, counted(line.number, "line"));
}

/// The explanation, of which an error names the file and the line.
io::Explanation explained(const ExplainArguments& options, const QuestionLine& question, io::Precision precision) {
  try {
    return io::explain(question.text, precision);
  } catch (const InvalidValue& e) {
    throw InvalidValue(fmt::format("{}, line {}", source_of(options), question.number), "", e.what());
  }
}

int run_explain(const ExplainArguments& options) {
  const Vec3d direction = checked_direction(options.direction);
  check_ending("--svg", options.svg, ".svg");
  check_output("--svg", options.svg, {&options.file, 1});
  const QuestionLine question = question_line(options);
  const io::Precision precision = precision_of(options.precision);
  std::optional<Progress> progress("explaining");
  const io::Explanation explanation = explained(options, question, precision);
  if (!options.svg.empty()) io::write_file(options.svg, io::draw_explanation(explanation, direction));
  progress.reset();
  if (options.json)
    print(Json::parse(io::explained_line(question.text, precision).text));
  else
    fmt::print("{}", io::explanation_text(explanation));
  return 0;
}

}  // namespace

Run add_explain(CLI::App& app) {
  auto options = std::make_shared<ExplainArguments>();
  CLI::App* command = app.add_subcommand("explain", "Show how a question is answered, as a table and as a picture");
  command->add_option("FILE", options->file, "Questions, one JSON object a line (default: standard input)");
  command->add_option("--line", options->line,
                      "The line of the file with the question, counted from 1 (default: the first question)");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print the answer with its trace as JSON, as the protocol has it");
  command->add_option("--svg", options->svg, "Draw the shapes, the axes and the contacts, or the blow (.svg)");
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
