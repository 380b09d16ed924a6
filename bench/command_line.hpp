// What a benchmark can be told on its command line.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace graze::bench {

/// Options with what they are by default, which `--help` tells. Each is given once, as `--name VALUE`.
class CommandLine {
 public:
  /// `about`: what the program measures, a sentence.
  explicit CommandLine(const std::string& about);
  ~CommandLine();

  /// A whole number, at least 1.
  CommandLine& number(const char* name, std::size_t& value, const char* what);
  /// A positive number.
  CommandLine& real(const char* name, double& value, const char* what);
  /// A regular expression (ECMAScript).
  CommandLine& expression(const char* name, std::string& value, const char* what);
  CommandLine& file(const char* name, std::string& value, const char* what);
  CommandLine& flag(const char* name, bool& value, const char* what);

  /// Reads them. Ends the program for `--help`, and with a word of what is wrong for what is none of these.
  void read(int argc, char** argv);

 private:
  struct Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace graze::bench
