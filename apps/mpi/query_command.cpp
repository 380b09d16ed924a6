// graze-mpi query: the query protocol on a file, by all ranks.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <numeric>

#include "cli/checked.hpp"
#include "graze/io/protocol.hpp"
#include "graze/mpi/sweep.hpp"
#include "mpi/commands.hpp"

namespace graze::cli {

namespace {

struct QueryArguments {
  std::string file, out, journal, precision = "double";
  bool report = false;
};

/// Prints the report on standard error, since answers may go to standard output. Only rank 0 has the shares of the
/// work.
void print_report(const mpi::SweepReport& report) {
  if (report.by_rank.empty()) return;
  fmt::print(stderr, "lines {}, errors {}, chunks {}, of which the journal had {}\n", report.lines, report.errors,
             report.chunks, report.remembered);
  for (std::size_t rank = 0; rank < report.by_rank.size(); ++rank)
    fmt::print(stderr, "rank {}: chunks {}, answering for {:.3f} s\n", rank, report.by_rank[rank], report.busy[rank]);
  const double most = *std::max_element(report.busy.begin(), report.busy.end());
  const double sum = std::accumulate(report.busy.begin(), report.busy.end(), 0.0);
  if (sum > 0)
    fmt::print(stderr, "balance (largest over mean): {:.3f}\n", most / sum * static_cast<double>(report.busy.size()));
}

int run_query(const QueryArguments& options) {
  const io::Precision precision = precision_of(options.precision);
  mpi::SweepSettings settings;
  settings.questions = options.file;
  settings.out = options.out;
  settings.journal = options.journal;
  settings.kind = "graze " GRAZE_VERSION " query, precision " + options.precision;
  const auto answer = [&](std::string_view line, std::size_t number, std::string& out) {
    const io::AnswerLine answered = io::answer_line(line, precision, number);
    out.append(answered.text).push_back('\n');
    return answered.error;
  };
  const mpi::SweepReport report = mpi::sweep_lines(MPI_COMM_WORLD, settings, answer, std::cout);
  if (options.report) print_report(report);
  return report.errors == 0 ? 0 : 1;
}

}  // namespace

Run add_query(CLI::App& app) {
  auto options = std::make_shared<QueryArguments>();
  CLI::App* command = app.add_subcommand("query", "Answer questions in JSON, one a line, in their order");
  command->add_option("FILE", options->file, "Questions, one JSON object a line: a file that every rank can read")
      ->required();
  command->add_option("--out", options->out, "Write the answers there, all ranks at once (default: standard output)");
  command->add_option("--journal", options->journal,
                      "Keep what is done in this directory until all is, so that a sweep that was killed goes on where "
                      "it was (default with --out FILE: FILE.journal; else none)");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_flag("--report", options->report, "Say on standard error how the work was shared");
  command->footer(
      "The answers are byte for byte those of graze query, whatever the number of ranks. Exit code: 0 when every line\n"
      "was answered, 1 when an answer was an error, 2 when a file cannot be read or written or the ranks differ.\n\n"
      "Example:\n  mpirun -n 8 graze-mpi query questions.jsonl --out answers.jsonl");
  return [options] { return run_query(*options); };
}

}  // namespace graze::cli
