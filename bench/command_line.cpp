#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <limits>
#include <regex>

namespace graze::bench {

struct CommandLine::Reader {
  CLI::App app;
};

namespace {

std::string wrong_expression(const std::string& text) {
  try {
    std::regex{text};
    return {};
  } catch (const std::regex_error&) {
    return "not a regular expression: " + text;
  }
}

}  // namespace

CommandLine::CommandLine(const std::string& about) : reader_(std::make_unique<Reader>()) {
  reader_->app.description(about);
}
CommandLine::~CommandLine() = default;

CommandLine& CommandLine::number(const char* name, std::size_t& value, const char* what) {
  reader_->app.add_option(name, value, what)
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, std::numeric_limits<std::size_t>::max(), "N"));
  return *this;
}
CommandLine& CommandLine::real(const char* name, double& value, const char* what) {
  reader_->app.add_option(name, value, what)->capture_default_str()->check(CLI::PositiveNumber);
  return *this;
}
CommandLine& CommandLine::expression(const char* name, std::string& value, const char* what) {
  reader_->app.add_option(name, value, what)->capture_default_str()->check(wrong_expression, "REGEX");
  return *this;
}
CommandLine& CommandLine::file(const char* name, std::string& value, const char* what) {
  reader_->app.add_option(name, value, what)->type_name("FILE");
  return *this;
}
CommandLine& CommandLine::flag(const char* name, bool& value, const char* what) {
  reader_->app.add_flag(name, value, what);
  return *this;
}

void CommandLine::read(int argc, char** argv) {
  try {
    reader_->app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    std::exit(reader_->app.exit(e));
  }
}

}  // namespace graze::bench
