// Graze asked about all pairs at once, in single precision. `rows` has a line for each kind of pair and query that can
// be asked so: a function that answers all of the pairs.
#include <algorithm>
#include <optional>

#include "graze_shape.hpp"
#include "peer.hpp"

namespace graze::bench {

namespace {

/// Pairs as a program holds them that asks about many at once, and their answers.
struct Batch {
  std::vector<Shape<float>> shapes_a, shapes_b;
  std::vector<Posef> poses_a, poses_b;

  std::vector<std::uint8_t> overlaps;
  std::vector<float> distances;
  std::vector<Contacts> contacts;
};

/// Answers the first `count` pairs.
using Ask = void (*)(Batch& batch, std::size_t count);

struct Row {
  Kind a, b;
  Query query;
  Ask ask;
};

const std::vector<Row> rows = {};

class GrazeBatch {
 public:
  static constexpr const char* name = "graze batch";
  static constexpr bool single_precision = true;
  static std::string version() { return "this tree"; }

  bool prepare(std::span<const Pair> pairs) {
    a_ = pairs[0].a.kind;
    b_ = pairs[0].b.kind;
    if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return row.a == a_ && row.b == b_; }))
      return false;
    OncePerCorners<std::optional<Shape<float>>> shared;
    const auto shape = [&](const Body& body) {
      return *shared.of(body, [](const Body& b) { return std::optional(graze_shape<float>(b)); });
    };
    for (const Pair& pair : pairs) {
      batch_.shapes_a.push_back(shape(pair.a));
      batch_.shapes_b.push_back(shape(pair.b));
      batch_.poses_a.push_back(cast<float>(pair.a.pose));
      batch_.poses_b.push_back(cast<float>(pair.b.pose));
    }
    batch_.overlaps.resize(pairs.size());
    batch_.distances.resize(pairs.size());
    batch_.contacts.resize(pairs.size());
    return true;
  }
  bool has(Query query) const { return row(query) != nullptr; }

  double run(Query query, std::size_t count) {
    if (const Row* asked = row(query)) asked->ask(batch_, count);
    return 0;
  }
  bool overlap(std::size_t i) { return batch_.overlaps[i] != 0; }
  double distance(std::size_t i) { return static_cast<double>(batch_.distances[i]); }
  Contacts contacts(std::size_t i) { return batch_.contacts[i]; }

 private:
  const Row* row(Query query) const {
    for (const Row& row : rows)
      if (row.a == a_ && row.b == b_ && row.query == query) return &row;
    return nullptr;
  }

  Kind a_{}, b_{};
  Batch batch_;
};

/// Only when it has anything to answer.
const auto registered = rows.empty() ? nullptr : std::make_unique<const Registered<GrazeBatch>>();

}  // namespace

}  // namespace graze::bench
