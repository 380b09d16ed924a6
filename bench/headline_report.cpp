#include "headline_report.hpp"

#include <algorithm>
#include <cmath>

#include "chart.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

bool is_graze(std::size_t c) { return peers()[c]->name().starts_with("graze"); }
std::size_t column_of(const char* name) {
  std::size_t c = 0;
  while (c < peers().size() && peers()[c]->name() != name) ++c;
  return c;
}

double wrong_share(const Cell& cell) {
  return cell.asked ? static_cast<double>(cell.wrong) / static_cast<double>(cell.asked) : 0;
}

/// The other library that is fastest, of those that are wrong in at most a tenth of their answers; where there is none,
/// the one that is wrong least often; or none.
std::size_t fastest_other(const HeadlineRow& row) {
  constexpr double acceptable = 0.1;
  std::size_t best = peers().size();
  const auto rank = [&](std::size_t c) {
    const double wrong = wrong_share(row.cells[c]);
    return std::pair(wrong <= acceptable ? 0 : wrong, row.cells[c].nanoseconds);
  };
  for (std::size_t c = 0; c < peers().size(); ++c)
    if (!is_graze(c) && row.cells[c].state == Cell::State::measured && (best == peers().size() || rank(c) < rank(best)))
      best = c;
  return best;
}

/// The columns that answer anything, the other libraries first.
std::vector<std::size_t> columns_of(const std::vector<HeadlineRow>& rows) {
  std::vector<std::size_t> columns;
  for (const bool ours : {false, true})
    for (std::size_t c = 0; c < peers().size(); ++c)
      if (is_graze(c) == ours && std::any_of(rows.begin(), rows.end(), [&](const HeadlineRow& row) {
            return row.cells[c].state != Cell::State::absent;
          }))
        columns.push_back(c);
  return columns;
}

std::string times_table(const std::vector<HeadlineRow>& rows, const std::vector<std::size_t>& columns) {
  std::vector<std::string> head{"ns a pair"};
  for (const std::size_t c : columns) head.push_back(peers()[c]->name());
  std::vector<std::size_t> ours;
  for (const std::size_t c : columns)
    if (peers()[c]->name() == "graze float" || peers()[c]->name() == "graze float batch") {
      ours.push_back(c);
      head.push_back(ours.size() == 1 ? "fastest other / Graze" : "/ batch");
    }
  Table table(head);
  for (const HeadlineRow& row : rows) {
    std::vector<std::string> line{row.name};
    for (const std::size_t c : columns) {
      const Cell& cell = row.cells[c];
      std::string text = cell.state == Cell::State::absent ? "-" : nanoseconds(cell.nanoseconds);
      if (cell.state == Cell::State::silent) text = "silent";
      if (cell.state == Cell::State::measured && wrong_share(cell) >= 0.005)
        text += " (" + percent(cell.wrong, cell.asked) + " wrong)";
      line.push_back(text);
    }
    const std::size_t other = fastest_other(row);
    for (const std::size_t c : ours) {
      const bool both = other < peers().size() && row.cells[c].state == Cell::State::measured;
      line.push_back(both ? printed("%.2f", row.cells[other].nanoseconds / row.cells[c].nanoseconds) : "-");
    }
    table.add(line);
  }
  return table.text();
}

std::string answers_table(const std::vector<HeadlineRow>& rows, const std::vector<std::size_t>& columns) {
  Table table(
      {"pairs", "library", "ns a pair", "+-", "wrong", "no answer", "median error", "worst error", "points", "timed"},
      2);
  for (const HeadlineRow& row : rows)
    for (const std::size_t c : columns) {
      const Cell& cell = row.cells[c];
      if (cell.state == Cell::State::absent) continue;
      const bool exact = cell.errors.empty() || peers()[c]->name() == "graze double";
      const bool timed = cell.state == Cell::State::measured;
      table.add({row.name, peers()[c]->name(), timed ? nanoseconds(cell.nanoseconds) : "silent",
                 timed ? printed("%.0f", 100 * cell.spread) + " %" : "-", percent(cell.wrong, cell.asked),
                 percent(cell.failed, cell.asked), exact ? "-" : error(quantile(cell.errors, 0.5)),
                 exact ? "-" : error(quantile(cell.errors, 1)),
                 row.query == Query::contacts && cell.overlapping
                     ? printed("%.2f", static_cast<double>(cell.points) / static_cast<double>(cell.overlapping))
                     : "-",
                 std::to_string(cell.timed)});
    }
  return table.text();
}

constexpr const char* memory_note =
    R"(What each library holds of a pair: by how much the heap grew, over the number of pairs, when it made its objects.
What Graze touches: the bytes that it reads and writes to answer, by `sizeof` (hulls' own data apart, which pairs share;
contacts with four points). `meet`: how many of the pairs overlap or hit.

)";

constexpr const char* times_note =
    R"(`-`: the library has no such shape or query. `silent`: it takes the pairs and finds none that overlap. Wrong answers
are named from 0.5 % on; the next table has all. `fastest other`: of those with at most 10 % of wrong answers, or else
the one with the fewest.

)";

constexpr const char* answers_note =
    R"(`+-`: half of the repetitions lie within that of the median. `wrong`: overlaps, hits and misses that are not so, hits of
rays that are off by more than 1e-3 of the size (the larger radius about a shape's origin), casts that stop more than
1e-2 of it apart or deep; pairs within 1e-4 of touching (casts: 1e-2) are not judged. Errors are relative to the size:
of the distance, of the depth of the deepest contact, of where a ray hits, of the gap where a cast stops. What is right
is what Graze says in double precision, which its tests hold against an independent reference. `points`: of a pair in
contact. `timed`: pairs in a repetition; fewer where all would have taken too long.
)";

std::string short_name(std::string processor) { return processor.substr(0, processor.find(',')); }

}  // namespace

std::string headline_short(const std::vector<HeadlineRow>& rows) {
  const std::size_t one = column_of("graze float"), batch = column_of("graze float batch");
  std::string text;
  for (const std::size_t ours : {one, batch}) {
    if (ours == peers().size()) continue;
    double log_sum = 0, least = never, most = 0;
    std::size_t count = 0;
    std::string least_name, most_name;
    for (const HeadlineRow& row : rows) {
      const std::size_t other = fastest_other(row);
      if (other == peers().size() || row.cells[ours].state != Cell::State::measured) continue;
      const double ratio = row.cells[other].nanoseconds / row.cells[ours].nanoseconds;
      log_sum += std::log(ratio);
      ++count;
      const std::string name = row.name + ", " + peers()[other]->name();
      if (ratio < least) least = ratio, least_name = name;
      if (ratio > most) most = ratio, most_name = name;
    }
    if (count == 0) continue;
    text += std::string(ours == one ? "A pair at a time" : "All pairs at once") + ", the fastest other library takes " +
            printed("**%.1f**", std::exp(log_sum / static_cast<double>(count))) +
            " times as long as Graze (geometric mean of the " + std::to_string(count) +
            " rows that both answer;\nfrom " + printed("%.1f", least) + ", " + least_name + ", to " +
            printed("%.1f", most) + ", " + most_name + ").\n";
  }
  return text;
}

std::string headline_report(const std::vector<HeadlineRow>& rows) {
  const std::vector<std::size_t> columns = columns_of(rows);
  return headline_short(rows) + "\n" + times_table(rows, columns) + times_note + answers_table(rows, columns) +
         answers_note;
}

std::string headline_memory(const std::vector<HeadlineRow>& rows) {
  const std::vector<std::size_t> columns = columns_of(rows);
  std::vector<std::string> head{"bytes a pair"};
  for (const std::size_t c : columns) head.push_back(peers()[c]->name());
  for (const std::size_t c : columns)
    if (is_graze(c)) head.push_back(peers()[c]->name() + " touches");
  head.push_back("meet");
  Table table(head);
  for (const HeadlineRow& row : rows) {
    std::vector<std::string> line{row.name};
    const auto bytes = [&](std::size_t c, std::size_t count) {
      return row.cells[c].state == Cell::State::measured && count > 0 ? std::to_string(count) : "-";
    };
    for (const std::size_t c : columns) line.push_back(bytes(c, row.held[c]));
    for (const std::size_t c : columns)
      if (is_graze(c)) line.push_back(bytes(c, row.touched[c]));
    line.push_back(printed("%.0f", 100 * row.meeting) + " %");
    table.add(line);
  }
  return memory_note + table.text();
}

std::string headline_chart(const std::vector<HeadlineRow>& rows, std::size_t pairs) {
  const std::size_t one = column_of("graze float"), batch = column_of("graze float batch");
  std::vector<ChartRow> bars;
  for (const HeadlineRow& row : rows) {
    const std::size_t other = fastest_other(row);
    if (other == peers().size() || one == peers().size() || row.cells[one].state != Cell::State::measured) continue;
    bars.push_back({row.name, peers()[other]->name(), row.cells[other].nanoseconds, wrong_share(row.cells[other]),
                    row.cells[one].nanoseconds, batch < peers().size() ? row.cells[batch].nanoseconds : 0});
  }
  const Conditions all = conditions();
  return chart("Time for a pair: shorter is faster",
               std::to_string(pairs) + " pairs a row, one thread, " + short_name(all[1].second) + ", " + all[0].second +
                   ". Graze in float; Bullet in float, ODE and FCL in double, as packaged.",
               bars);
}

}  // namespace graze::bench
