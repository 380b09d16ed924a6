#include "table.hpp"

#include <algorithm>
#include <cstdio>

namespace graze::bench {

std::string printed(const char* format, double v) {
  char text[64];
  std::snprintf(text, sizeof text, format, v);
  return text;
}

std::string nanoseconds(double v) { return printed(v < 9.95 ? "%.1f" : "%.0f", v); }

std::string percent(std::size_t part, std::size_t whole) {
  if (part == 0) return "0";
  const double v = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return printed(v < 0.00995 ? "%.3f" : v < 0.995 ? "%.2f" : v < 9.95 ? "%.1f" : "%.0f", v) + " %";
}

std::string error(double v) { return v == 0 ? "0" : printed("%.0e", v); }

std::string Table::text() const {
  std::vector<std::size_t> widths(lines_[0].size(), 3);
  for (const auto& line : lines_)
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  std::string text;
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string padding(widths[c] - lines_[l][c].size(), ' ');
      text += c == 0 ? "| " : " ";
      text += c < words_ ? lines_[l][c] + padding : padding + lines_[l][c];
      text += " |";
    }
    text += "\n";
    if (l > 0) continue;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string line(widths[c] + 1, '-');
      text += c == 0 ? "|" : "";
      text += line + (c < words_ ? "-|" : ":|");
    }
    text += "\n";
  }
  return text + "\n";
}

}  // namespace graze::bench
