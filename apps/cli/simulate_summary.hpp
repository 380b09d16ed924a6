// The summary of a scene that was played, printed.
#pragma once

#include "graze/io/simulate.hpp"

namespace graze::cli {

/// The facts of a summary: a scene's name and notes, the names of its colliders and bodies, steps a second, and the
/// time that it took to compute.
struct SummaryOf {
  const std::string& source;
  const std::vector<std::string>& notices;
  std::vector<std::string> colliders, bodies;
  double rate, seconds;
};

void print_as_json(const SummaryOf& of, const io::SimulateSummary& summary);
void print_as_text(const SummaryOf& of, const io::SimulateSummary& summary);

}  // namespace graze::cli
