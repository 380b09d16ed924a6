// Tables that read the same on a terminal and in Markdown.
#pragma once

#include <string>
#include <vector>

namespace graze::bench {

std::string printed(const char* format, double v);
/// With as many digits as are worth reading.
std::string nanoseconds(double v);
std::string percent(std::size_t part, std::size_t whole);
std::string error(double v);

/// A table of Markdown, its columns padded so that it can be read as it stands.
class Table {
 public:
  /// The first `words` columns stand left, the others right.
  explicit Table(std::vector<std::string> head, std::size_t words = 1) : words_(words), lines_{std::move(head)} {}
  void add(std::vector<std::string> line) { lines_.push_back(std::move(line)); }

  std::string text() const;

 private:
  std::size_t words_;
  std::vector<std::vector<std::string>> lines_;
};

}  // namespace graze::bench
