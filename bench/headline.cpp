// The pairs that programs ask about most, 100,000 different ones of each kind, in single precision, with other
// libraries on the same pairs: how fast, and how right.
//
//   bench_headline [--pairs N] [--repetitions N] [--only REGEX] [--libraries REGEX] [--seconds S] [--chart FILE.svg]
//                  [--short FILE.md]
//
// About half of the pairs overlap or hit. So many do not fit in a cache: what a library reads and writes for a pair is
// part of its time. All get the same pairs and make of them, untimed, the objects that their users hold: each its own,
// but for hulls and triangles, of which there are `different` that the pairs share at poses of their own. A library
// that takes longer than S seconds (0.3) over all pairs is asked about the first ones only.
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "chart.hpp"
#include "judges.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

constexpr std::size_t different = 256;

struct Options {
  std::size_t pairs = 100'000;
  TimingOptions timing{.repetitions = 9, .most_seconds = 0.3};
  std::string only = ".*", libraries = ".*", chart, brief;
};

/// Pairs of a kind and what is asked about them.
struct Set {
  std::string name;
  std::function<std::vector<Pair>(std::size_t)> make;
  std::vector<Query> asked;
};

Set random_set(const char* name, Kind a, Kind b, std::vector<Query> asked) {
  return {name, [a, b](std::size_t count) { return make_pairs(a, b, count, 1, make_touching(), different); }, asked};
}

std::vector<Set> all_sets() {
  constexpr Query overlap = Query::overlap, distance = Query::distance, contacts = Query::contacts;
  const auto rays_at = [](Kind kind) {
    return [kind](std::size_t count) { return make_rays(kind, count, different); };
  };
  const auto ways_of = [](Kind kind) {
    return [kind](std::size_t count) { return make_ways(kind, count, different); };
  };
  return {random_set("sphere-sphere", Kind::sphere, Kind::sphere, {contacts}),
          random_set("sphere-box", Kind::sphere, Kind::box, {contacts}),
          random_set("capsule-capsule", Kind::capsule, Kind::capsule, {contacts}),
          random_set("box-box", Kind::box, Kind::box, {overlap, distance, contacts}),
          {"box-box stacked", make_stacked, {contacts}},
          random_set("box-triangle", Kind::box, Kind::triangle, {contacts}),
          random_set("cylinder-cylinder", Kind::cylinder, Kind::cylinder, {contacts}),
          random_set("hull-hull", Kind::hull, Kind::hull, {overlap, distance, contacts}),
          {"ray-box", rays_at(Kind::box), {Query::raycast}},
          {"ray-hull", rays_at(Kind::hull), {Query::raycast}},
          {"box-box", ways_of(Kind::box), {Query::cast}},
          {"hull-hull", ways_of(Kind::hull), {Query::cast}}};
}

struct Row {
  std::string name;
  Query query{};
  double meeting = 0;  ///< share of the pairs that overlap or hit
  std::vector<Cell> cells;
  std::vector<std::size_t> held, touched;  ///< bytes a pair
};

std::string row_name(const Set& set, Query query) {
  return query == Query::raycast ? set.name : set.name + " " + query_names[static_cast<int>(query)];
}

Judge judge_of(const Reference& reference, Query query) {
  if (query == Query::raycast) return ray_judge(reference);
  if (query == Query::cast) return cast_judge(reference);
  return distance_judge(reference, query);
}

std::size_t heap() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Which of the rows of a set are wanted.
std::vector<Query> wanted(const Set& set, const std::regex& only) {
  std::vector<Query> queries;
  for (const Query query : set.asked)
    if (std::regex_search(row_name(set, query), only)) queries.push_back(query);
  return queries;
}

void measure(const Set& set, const std::vector<Query>& asked, const Options& options, std::vector<Row>& rows) {
  const std::vector<Pair> pairs = set.make(options.pairs);
  const Reference reference(pairs);
  std::vector<char> prepared;
  std::vector<std::size_t> held;
  for (const auto& peer : peers()) {
    peer->prepare({});  // empties it of the last set
    const std::size_t before = heap();
    prepared.push_back(peer->prepare(pairs));
    held.push_back((heap() - before) / pairs.size());
  }
  for (const Query query : asked) {
    Row row{row_name(set, query), query, 0, std::vector<Cell>(peers().size()), held, {}};
    const Judge judge = judge_of(reference, query);
    Answer none;
    for (std::size_t i = 0; i < pairs.size(); ++i) row.meeting += judge(i, none).meets;
    row.meeting /= static_cast<double>(pairs.size());
    for (std::size_t c = 0; c < peers().size(); ++c) {
      Peer& peer = *peers()[c];
      row.touched.push_back(peer.touched(query));
      if (prepared[c] && peer.has(query))
        row.cells[c] = judged(peer, query, pairs.size(), judge, 10 * options.timing.most_seconds);
    }
    time(query, pairs.size(), options.timing, row.cells);
    rows.push_back(std::move(row));
  }
  for (const auto& peer : peers()) peer->prepare({});
}

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
std::size_t fastest_other(const Row& row) {
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
std::vector<std::size_t> columns_of(const std::vector<Row>& rows) {
  std::vector<std::size_t> columns;
  for (const bool ours : {false, true})
    for (std::size_t c = 0; c < peers().size(); ++c)
      if (is_graze(c) == ours && std::any_of(rows.begin(), rows.end(),
                                             [&](const Row& row) { return row.cells[c].state != Cell::State::absent; }))
        columns.push_back(c);
  return columns;
}

std::string times_table(const std::vector<Row>& rows, const std::vector<std::size_t>& columns) {
  std::vector<std::string> head{"ns a pair"};
  for (const std::size_t c : columns) head.push_back(peers()[c]->name());
  head.push_back("fastest other / Graze");
  Table table(head);
  const std::size_t ours = column_of("graze float");
  for (const Row& row : rows) {
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
    const bool both = ours < peers().size() && other < peers().size() && row.cells[ours].nanoseconds > 0;
    line.push_back(both ? printed("%.2f", row.cells[other].nanoseconds / row.cells[ours].nanoseconds) : "-");
    table.add(line);
  }
  return table.text();
}

std::string answers_table(const std::vector<Row>& rows, const std::vector<std::size_t>& columns) {
  Table table({"pairs", "library", "ns a pair", "+-", "wrong", "no answer", "median error", "worst error", "points",
               "timed", "bytes held"},
              2);
  for (const Row& row : rows)
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
                 std::to_string(cell.timed), std::to_string(row.held[c])});
    }
  return table.text();
}

std::string touched_note(const std::vector<Row>& rows, const std::vector<std::size_t>& columns) {
  std::vector<std::string> head{"bytes a pair"};
  std::vector<std::size_t> known;
  for (const std::size_t c : columns)
    if (std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.touched[c] > 0; })) {
      known.push_back(c);
      head.push_back(peers()[c]->name());
    }
  head.push_back("meet");
  Table table(head);
  for (const Row& row : rows) {
    std::vector<std::string> line{row.name};
    for (const std::size_t c : known)
      line.push_back(row.touched[c] > 0 && row.cells[c].state == Cell::State::measured ? std::to_string(row.touched[c])
                                                                                       : "-");
    line.push_back(printed("%.0f", 100 * row.meeting) + " %");
    table.add(line);
  }
  return "Bytes that Graze reads and writes for a pair, by `sizeof` (hulls' own data apart; contacts with four "
         "points);\n"
         "and how many of the pairs overlap or hit:\n\n" +
         table.text();
}

/// The rows that both answer, and by how much the fastest other takes longer.
std::string in_short(const std::vector<Row>& rows) {
  const std::size_t one = column_of("graze float"), batch = column_of("graze batch");
  std::string text;
  for (const std::size_t ours : {one, batch}) {
    if (ours == peers().size()) continue;
    double log_sum = 0, least = never, most = 0;
    std::size_t count = 0;
    std::string least_name, most_name;
    for (const Row& row : rows) {
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

std::string report(const std::vector<Row>& rows, const Options& options) {
  std::string text = in_short(rows) + "\n";
  const std::vector<std::size_t> columns = columns_of(rows);
  text += times_table(rows, columns);
  text += "`-`: the library has no such shape or query. `silent`: it takes the pair and finds none that overlap. Wrong "
          "answers\nare named from 0.5 % on; the table below has all. `fastest other`: of those with at most 10 % of "
          "wrong answers,\n"
          "or else the one with the fewest.\n\n" +
          answers_table(rows, columns);
  text +=
      "`+-`: half of the repetitions lie within that of the median. `wrong`: overlaps, hits and misses that are not "
      "so,\n"
      "hits of rays that are off by more than 1e-3 of the size (the larger radius about a shape's origin), casts that\n"
      "stop more than 1e-2 of it apart or deep; pairs within 1e-4 of touching (casts: 1e-2) are not judged. Errors "
      "are\n"
      "relative to the size: of the distance, of the depth of the deepest contact, of where a ray hits, of the gap "
      "where "
      "a\ncast stops. What is right is what Graze says in double precision, which its tests hold against an "
      "independent\n"
      "reference. `points`: of a pair in contact. `timed`: pairs in a repetition, where " +
      std::to_string(options.pairs) +
      " would have taken too long.\n`bytes held`: by which the heap grew for a pair when the library made its "
      "objects.\n\n";
  return text + touched_note(rows, columns);
}

std::string short_name(std::string processor) { return processor.substr(0, processor.find(',')); }

std::string drawn(const std::vector<Row>& rows, const Options& options) {
  const std::size_t one = column_of("graze float"), batch = column_of("graze batch");
  std::vector<ChartRow> bars;
  for (const Row& row : rows) {
    const std::size_t other = fastest_other(row);
    if (other == peers().size() || one == peers().size() || row.cells[one].state != Cell::State::measured) continue;
    bars.push_back({row.name, peers()[other]->name(), row.cells[other].nanoseconds, wrong_share(row.cells[other]),
                    row.cells[one].nanoseconds, batch < peers().size() ? row.cells[batch].nanoseconds : 0});
  }
  const Conditions all = conditions();
  return chart("Time for a pair: shorter is faster",
               std::to_string(options.pairs) + " pairs a row, one thread, " + short_name(all[1].second) + ", " +
                   all[0].second + ". Graze in float; Bullet in float, ODE and FCL in double, as packaged.",
               bars);
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) std::fprintf(stderr, "bench_headline: cannot write %s\n", path.c_str());
  return static_cast<bool>(file);
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i], value = argv[i + 1];
    const auto number = [&] { return std::max<std::size_t>(1, std::strtoull(value.c_str(), nullptr, 10)); };
    if (option == "--pairs") options.pairs = number();
    if (option == "--repetitions") options.timing.repetitions = number();
    if (option == "--seconds") options.timing.most_seconds = std::strtod(value.c_str(), nullptr);
    if (option == "--only") options.only = value;
    if (option == "--libraries") options.libraries = value;
    if (option == "--chart") options.chart = value;
    if (option == "--short") options.brief = value;
  }
  return options;
}

int run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  choose_peers(options.libraries);
  const std::regex only(options.only);
  std::vector<Row> rows;
  const std::vector<Set> sets = all_sets();
  const Quiet quiet;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::vector<Query> asked = wanted(sets[s], only);
    progress(s, sets.size(), sets[s].name);
    if (!asked.empty()) measure(sets[s], asked, options, rows);
  }
  progress(sets.size(), sets.size(), "");
  std::fputs(report(rows, options).c_str(), stdout);
  if (!options.chart.empty() && !write(options.chart, drawn(rows, options))) return 1;
  if (!options.brief.empty() && !write(options.brief, in_short(rows))) return 1;
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
