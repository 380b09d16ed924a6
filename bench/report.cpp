#include "report.hpp"

#include <algorithm>
#include <cmath>

#include "table.hpp"

namespace graze::bench {

namespace {

std::string pair_name(const Row& row) {
  return std::string(kind_names[static_cast<std::size_t>(row.a)]) + ", " + kind_names[static_cast<std::size_t>(row.b)];
}

/// The text of a cell that was measured, by `of`; a word for the others.
template <class Of>
std::string cell_text(const Cell& cell, Of of) {
  switch (cell.state) {
  case Cell::State::absent: return "-";
  case Cell::State::silent: return "silent";
  case Cell::State::measured: break;
  }
  return of(cell);
}

std::string correctness(const Cell& cell, Query query, bool reference) {
  std::string text = percent(cell.wrong, cell.asked);
  if (query == Query::overlap || reference) return text;
  return text + ", " + error(quantile(cell.errors, 0.5)) + ", " + error(quantile(cell.errors, 1));
}

template <class Text>
std::string table_of(const std::vector<Column>& columns, const std::vector<Row>& rows, Query query, Text text) {
  std::vector<std::string> head{std::string(query_names[static_cast<int>(query)])};
  for (const Column& column : columns) head.push_back(column.name);
  Table table(head);
  for (const Row& row : rows) {
    if (row.query != query) continue;
    std::vector<std::string> line{pair_name(row)};
    for (std::size_t c = 0; c < columns.size(); ++c) line.push_back(text(row.cells[c], columns[c]));
    table.add(line);
  }
  return table.text();
}

/// The Graze that a library is compared with: the one of its precision.
std::size_t rival(const std::vector<Column>& columns, const Column& column) {
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].name.starts_with("graze") && columns[c].single_precision == column.single_precision) return c;
  return columns.size();
}

std::string summary_table(const std::vector<Column>& columns, const std::vector<Row>& rows) {
  Table table({"query", "library", "pairs of shapes", "silent", "time by Graze's", "slowest", "wrong", "no answer",
               "median error", "worst error", "points"},
              2);
  for (const Query query : queries)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::size_t other = rival(columns, columns[c]);
      std::size_t all = 0, answered = 0, silent = 0, compared = 0, asked = 0, wrong = 0, failed = 0, points = 0,
                  touching = 0;
      double log_ratio = 0, slowest = 0;
      std::vector<double> errors;
      for (const Row& row : rows) {
        if (row.query != query) continue;
        const Cell& cell = row.cells[c];
        ++all;
        silent += cell.state == Cell::State::silent;
        if (cell.state != Cell::State::measured) continue;
        ++answered;
        asked += cell.asked, wrong += cell.wrong, failed += cell.failed;
        points += cell.points, touching += cell.overlapping;
        slowest = std::max(slowest, cell.nanoseconds);
        errors.insert(errors.end(), cell.errors.begin(), cell.errors.end());
        if (other < columns.size() && other != c && row.cells[other].state == Cell::State::measured) {
          log_ratio += std::log(cell.nanoseconds / row.cells[other].nanoseconds);
          ++compared;
        }
      }
      if (answered + silent == 0) continue;
      const bool exact = columns[c].reference || errors.empty();
      table.add({query_names[static_cast<int>(query)], columns[c].name,
                 std::to_string(answered) + " of " + std::to_string(all), std::to_string(silent),
                 compared ? printed("x %.2f", std::exp(log_ratio / static_cast<double>(compared))) : "-",
                 nanoseconds(slowest) + " ns", percent(wrong, asked), percent(failed, asked),
                 exact ? "-" : error(quantile(errors, 0.5)), exact ? "-" : error(quantile(errors, 1)),
                 query == Query::contacts && touching
                     ? printed("%.1f", static_cast<double>(points) / static_cast<double>(touching))
                     : "-"});
    }
  return table.text();
}

std::string flicker_table(const std::vector<Flicker>& flickers) {
  Table table({"resting box", "library", "kind changes", "number changes", "points"}, 2);
  for (const Flicker& f : flickers)
    table.add({f.scene, f.library, percent(f.kind_changes, f.frames), percent(f.count_changes, f.frames),
               printed("%.2f", static_cast<double>(f.points) / static_cast<double>(f.frames))});
  return table.text();
}

}  // namespace

std::string summary(const std::vector<Column>& columns, const std::vector<Row>& rows,
                    const std::vector<Flicker>& flickers) {
  std::string text =
      "The same pairs for all, each library with shapes it built beforehand, one library after the other in every\n"
      "repetition. Half of the pairs overlap, by up to a quarter of the pair's size (the larger radius about a "
      "shape's\n"
      "origin); the others are as far apart. What is right is what Graze says in double precision, which its tests "
      "hold\n"
      "against an independent reference; pairs within 1e-4 of the size of touching are not judged. Errors are "
      "relative\n"
      "to the size: of the signed distance, and of the depth of the deepest contact where the pair overlaps.\n\n"
      "`time by Graze's`: the geometric mean over all pairs of shapes that both answer, against the Graze of the same\n"
      "precision; above 1 Graze is faster. `slowest`: its slowest pair of shapes. `silent`: pairs of shapes that it\n"
      "takes and of which it finds none that overlap. `points`: of a pair in contact.\n\n";
  text += summary_table(columns, rows);
  if (flickers.empty()) return text;
  text += "A box of 1 m at rest on another, tilted up to 5 mrad, about 1 mm deep, its pose drawn anew in each frame. "
          "Shares\n"
          "of successive frames in which the kind of the contact changes (normal of a face or not) and the number of "
          "points;\n"
          "Graze with its `contact_margin`.\n\n";
  return text + flicker_table(flickers);
}

std::string report(const Conditions& conditions, const std::vector<Column>& columns, const std::vector<Row>& rows,
                   const std::vector<Flicker>& flickers) {
  std::string text = "# Graze beside other libraries\n\n";
  for (const auto& [what, how] : conditions) text += "- " + what + ": " + how + "\n";
  std::vector<double> spreads;
  for (const Row& row : rows)
    for (const Cell& cell : row.cells)
      if (cell.state == Cell::State::measured) spreads.push_back(cell.spread);
  text += "- noise: half of a cell's repetitions lie within " + printed("%.0f", 100 * quantile(spreads, 0.5)) +
          " % of its median (in the worst tenth of the cells, " + printed("%.0f", 100 * quantile(spreads, 0.9)) +
          " %)\n\n## In short\n\n";
  text += summary(columns, rows, flickers);
  text += "`-`: the library has no such shape or query. `silent`: it takes the pair and finds none that overlap.\n\n";
  for (const Query query : queries) {
    if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return row.query == query; })) continue;
    text += "## " + std::string(query_names[static_cast<int>(query)]) + "\n\nNanoseconds per pair:\n\n";
    text += table_of(columns, rows, query, [](const Cell& cell, const Column&) {
      return cell_text(cell, [](const Cell& c) { return nanoseconds(c.nanoseconds); });
    });
    text += query == Query::overlap ? "Wrong answers:\n\n" : "Wrong answers, median error, worst error:\n\n";
    text += table_of(columns, rows, query, [&](const Cell& cell, const Column& column) {
      return cell_text(cell, [&](const Cell& c) { return correctness(c, query, column.reference); });
    });
  }
  return text;
}

}  // namespace graze::bench
