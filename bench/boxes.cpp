// The same batches of pairs of boxes as another language asks, in turns with it: the part in C++ of bench/python.py.
//
//   bench_boxes --rows FILE
//
// FILE: doubles as the machine has them, 20 a pair: edge lengths (3), translation (3) and unit quaternion x y z w (4)
// of the first box, and then of the second. Each line of the standard input names a query, "overlap", "distance" or
// "contacts", and a number: it is asked of all pairs so many times, each time into the same arrays. The answer is a
// line of JSON: the seconds of each time, of the processor's, and a sum over the last answer, to be compared.
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "graze/batch.hpp"
#include "measure.hpp"

namespace graze::bench {

namespace {

/// The `i`-th boxes of both sides are a pair.
class Boxes {
 public:
  explicit Boxes(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<double, 20> row;
    while (in.read(reinterpret_cast<char*>(row.data()), sizeof(row))) {
      add(row.data(), a_, poses_a_);
      add(row.data() + 10, b_, poses_b_);
    }
  }

  Batch<double> batch() const { return {Bodies<double>(a_, poses_a_), Bodies<double>(b_, poses_b_)}; }

 private:
  static void add(const double* r, std::vector<Box<double>>& boxes, std::vector<Posed>& poses) {
    boxes.emplace_back(Vec3d{r[0], r[1], r[2]});
    poses.push_back({{r[3], r[4], r[5]}, {r[6], r[7], r[8], r[9]}});
  }

  std::vector<Box<double>> a_, b_;
  std::vector<Posed> poses_a_, poses_b_;
};

/// The answers of a query, kept from one time to the next.
class Asked {
 public:
  explicit Asked(const Batch<double>& batch) : batch_(batch) {}

  /// Throws for a query that is none of the three.
  void ask(const std::string& query) {
    if (query == "overlap")
      overlap(batch_, touch_);
    else if (query == "distance")
      distance(batch_, distances_);
    else if (query == "contacts")
      contacts(batch_, 0.0, found_);
    else
      throw InvalidValue("query", "overlap, distance or contacts", query);
  }
  double sum(const std::string& query) const {
    double sum = 0;
    if (query == "overlap")
      for (const std::uint8_t touch : touch_) sum += touch;
    else if (query == "distance")
      for (const auto& d : distances_) sum += d.distance;
    else
      for (const auto& p : found_.points) sum += p.distance;
    return sum;
  }

 private:
  Batch<double> batch_;
  std::vector<std::uint8_t> touch_;
  std::vector<Distance<double>> distances_;
  BatchContacts<double> found_;
};

int run(int argc, char** argv) {
  std::string file;
  CommandLine("Batches of pairs of boxes, asked in turns with another language: the part in C++ of bench/python.py.")
      .file("--rows", file, "20 doubles a pair: sizes, translations and quaternions of both boxes")
      .read(argc, argv);
  const Boxes boxes(file);
  Asked asked(boxes.batch());
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string query;
    std::size_t times = 0;
    words >> query >> times;
    std::printf("{\"seconds\": [");
    for (std::size_t i = 0; i < times; ++i) {
      const double start = processor_seconds();
      asked.ask(query);
      std::printf("%s%.9f", i == 0 ? "" : ", ", processor_seconds() - start);
    }
    std::printf("], \"sum\": %.17g}\n", asked.sum(query));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
