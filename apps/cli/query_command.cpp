// graze query: the query protocol on files and pipes.
#include <unistd.h>

#include <iostream>
#include <streambuf>
#include <string>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/protocol.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

namespace {

/// Answers on the terminal that shows the line of progress: passed on in whole lines, that line wiped off before them.
class AnswersOnTerminal : public std::streambuf {
 public:
  AnswersOnTerminal(Progress& progress, std::ostream& out) : progress_(progress), out_(out) {}

 private:
  static constexpr std::size_t most_held = 1 << 14;

  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    held_.append(bytes, static_cast<std::size_t>(count));
    if (held_.size() > most_held && held_.back() == '\n') return pass_on() ? count : 0;
    return count;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    return traits_type::eq_int_type(c, traits_type::eof()) || xsputn(&byte, 1) == 1 ? traits_type::not_eof(c)
                                                                                    : traits_type::eof();
  }
  int sync() override { return pass_on() ? 0 : -1; }

  bool pass_on() {
    if (!held_.empty()) progress_.without([this] { out_ << held_ << std::flush; });
    held_.clear();
    return static_cast<bool>(out_);
  }

  Progress& progress_;
  std::ostream& out_;
  std::string held_;
};

std::size_t answer_with_progress(std::istream& in, io::Precision precision) {
  // Who types the questions is not to be interrupted, and waits for nothing.
  if (&in == &std::cin && isatty(STDIN_FILENO) != 0) return io::answer_stream(in, std::cout, precision);
  Progress progress("answering");
  if (isatty(STDOUT_FILENO) == 0) return io::answer_stream(in, std::cout, precision);
  AnswersOnTerminal lines(progress, std::cout);
  std::ostream out(&lines);
  return io::answer_stream(in, out, precision);
}

/// Answers all questions; returns the exit code.
int answer_all(std::istream& in, const std::string& name, io::Precision precision) {
  const std::size_t errors = answer_with_progress(in, precision);
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
