// The list of special pairs, and the page that shows which of them have lanes.
#include "narrow/pair_list.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "graze/typed_query.hpp"
#include "narrow/batch/lane_pairs.hpp"

namespace graze {
namespace {

template <class P>
using KindA = typename P::template A<double>;
template <class P>
using KindB = typename P::template B<double>;

TEST(PairList, NamesEachPairOnceAndInTheOrderOfShapes) {
  std::set<std::pair<std::size_t, std::size_t>> seen;
  PairList::each([&]<class P>() {
    const std::size_t a = detail::kind_of<KindA<P>, double>(), b = detail::kind_of<KindB<P>, double>();
    EXPECT_LE(a, b) << KindA<P>::name << ", " << KindB<P>::name;
    EXPECT_TRUE(seen.emplace(a, b).second) << KindA<P>::name << ", " << KindB<P>::name << " stands twice";
  });
  EXPECT_EQ(seen.size(), PairList::count);
}

TEST(PairList, LanesAreFoundBothWaysRound) {
  PairList::each([]<class P>() {
    const std::size_t a = detail::kind_of<KindA<P>, double>(), b = detail::kind_of<KindB<P>, double>();
    EXPECT_EQ(lane_table<double>(a, b).exist(), HasLanes<P>) << KindA<P>::name << ", " << KindB<P>::name;
    if (!HasLanes<P>) return;
    EXPECT_FALSE(lane_table<double>(a, b).turned);
    EXPECT_EQ(lane_table<double>(b, a).pair, lane_table<double>(a, b).pair);
    EXPECT_EQ(lane_table<double>(b, a).turned, a != b);
  });
}

/// Whether the list has a pair of two kinds in this order.
template <class A, class B>
bool is_listed() {
  bool found = false;
  PairList::each([&]<class P>() { found |= std::is_same_v<KindA<P>, A> && std::is_same_v<KindB<P>, B>; });
  return found;
}

/// Calls `f` with each two kinds as its template arguments, both ways round.
template <template <class> class... Kinds>
struct EachTwoKinds {
  template <class F>
  static void call(const F& f) {
    (with<Kinds>(f), ...);
  }

 private:
  template <template <class> class A, class F>
  static void with(const F& f) {
    (f.template operator()<A, Kinds>(), ...);
  }
};

TEST(PairList, HoldsEveryTypedPairInTheOrderOfShapes) {
  std::size_t typed = 0;
  EachTwoKinds<Sphere, Capsule, Box, Rectangle, LineSegment, Triangle>::call(
      [&]<template <class> class A, template <class> class B>() {
        if (detail::most_points<A, B> == 0) return;
        ++typed;
        EXPECT_TRUE((is_listed<A<double>, B<double>>())) << A<double>::name << ", " << B<double>::name;
        EXPECT_EQ((most_contacts<A, B>), (most_contacts<B, A>)) << A<double>::name << ", " << B<double>::name;
      });
  EXPECT_EQ(typed, 8u);
}

/// The table of docs/across-lanes.md: what is answered across lanes (=) and what one by one (1).
std::string table_of_lanes() {
  struct Kind {
    std::size_t number;
    const char* name;
  };
  std::vector<Kind> kinds;
  const auto add = [&]<class C>() {
    if (has_lanes<C, double>()) kinds.push_back({detail::kind_of<C, double>(), C::name});
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (add.template operator()<std::variant_alternative_t<I, ShapeList<double>>>(), ...);
  }
  (std::make_index_sequence<Shape<double>::count>());
  std::string table = "| |";
  for (const Kind& k : kinds) table += std::string(" ") + k.name + " |";
  table += "\n|---|";
  for (std::size_t i = 0; i < kinds.size(); ++i) table += "---|";
  table += "\n";
  for (const Kind& a : kinds) {
    table += std::string("| ") + a.name + " |";
    for (const Kind& b : kinds) {
      const LanePair pair = lane_table<double>(a.number, b.number).pair;
      const auto cell = [&](const char* query, const LanePairSet& with) {
        return std::string(query) + (with(pair) ? "=" : "1");
      };
      table += a.number > b.number ? " |"
                                   : " " + cell("o", with_overlap_rows) + " " + cell("d", with_distance_rows) + " " +
                                         cell("c", with_contact_lanes) + " |";
    }
    table += "\n";
  }
  return table;
}

/// With GRAZE_WRITE_PAGES set the page is written anew instead.
TEST(PairList, ThePageShowsIt) {
  const std::string path = std::string(GRAZE_SOURCE_DIR) + "/docs/across-lanes.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::string page = text.str();
  const std::string begin = "<!-- pairs: written by PairList.ThePageShowsIt -->\n", end = "<!-- end of pairs -->\n";
  const std::size_t from = page.find(begin), to = page.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t first = from + begin.size();
  if (std::getenv("GRAZE_WRITE_PAGES")) {
    std::ofstream(path) << page.replace(first, to - first, "\n" + table_of_lanes() + "\n");
    return;
  }
  EXPECT_EQ(page.substr(first, to - first), "\n" + table_of_lanes() + "\n")
      << "run it with GRAZE_WRITE_PAGES=1 to write the table anew";
}

}  // namespace
}  // namespace graze
