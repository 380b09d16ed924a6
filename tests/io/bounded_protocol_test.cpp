// The query protocol: contacts that are not proven within the tolerance say how far off they may be, of composites too.
#include <gtest/gtest.h>

#include <cmath>

#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

Json contacts_of(const Json& a, const Json& b, Precision precision) {
  return ask(Json{{"query", "contacts"}, {"a", a}, {"b", b}}.dump(), precision);
}

TEST(BoundedProtocol, ContactsOfCompositesAsOfTheirPieces) {
  const Json cone = {{"type", "cylinder"}, {"cylinder", {{"height", 1}, {"radiusBottom", 0.5}, {"radiusTop", 0}}}},
             speck = {{"type", "capsule"},
                      {"capsule", {{"height", 1e-3}, {"radiusBottom", 5e-4}, {"radiusTop", 2e-4}}}};
  int bounded = 0, proven = 0;
  for (const Precision precision : {Precision::double_precision, Precision::single_precision})
    for (int i = 0; i < 200; ++i) {
      const Json turned = {std::sin(i), std::cos(2 * i), std::sin(3 * i), std::cos(5 * i)};
      const Json b = {{"shape", speck}, {"translation", {0, 1e-9 * i, 0}}, {"rotation", turned}};
      const Json alone = contacts_of({{"shape", cone}}, b, precision);
      const Json child = {{"type", "compound"}, {"compound", {{"children", {{{"shape", cone}}}}}}};
      const Json whole = contacts_of({{"shape", child}}, b, precision);
      ASSERT_EQ(alone.contains("bounded"), whole.contains("bounded")) << alone << "\n" << whole;
      (alone.contains("bounded") ? bounded : proven) += 1;
      if (!alone.contains("bounded")) continue;
      EXPECT_EQ(alone["bounded"], whole["bounded"]);
      EXPECT_GT(alone["bounded"], 0);
    }
  EXPECT_GE(bounded, 1);
  EXPECT_GE(proven, 1);
}

}  // namespace
}  // namespace graze::io
