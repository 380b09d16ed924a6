// The text of numbers where a standard library has no floating-point `std::to_chars`, against one that has it.
#include "io/shortest_number.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

namespace graze::io {
namespace {

template <class T>
std::string own(T value) {
  char text[40];
  return {text, write_shortest(value, text)};
}

template <class T>
std::string standard(T value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class T, class Bits>
void random_numbers_agree() {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    // Any bits, numbers near one, whole numbers, and short decimals.
    const Bits bits = static_cast<Bits>(random());
    T any;
    std::memcpy(&any, &bits, sizeof any);
    const T near_one = static_cast<T>(static_cast<double>(random()) * 0x1p-60);
    const T whole = static_cast<T>(random() >> (random() % 64));
    const T decimal = static_cast<T>(random() % 2000) / T(100);
    const T any_size =
        static_cast<T>(std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 110) - 100));
    const T denormal = static_cast<T>(static_cast<double>(random() % 4096)) * std::numeric_limits<T>::denorm_min();
    for (const T value : {any, -near_one, near_one, whole, decimal, any_size, denormal}) {
      int exponent = 0;
      // At a power of two the neighbours are unevenly far, and one digit more is possible.
      if (!std::isfinite(value) || std::abs(std::frexp(value, &exponent)) == T(0.5)) continue;
      ASSERT_EQ(own(value), standard(value));
    }
  }
}

TEST(ShortestNumber, RandomDoublesAreWrittenAsByTheStandardLibrary) { random_numbers_agree<double, std::uint64_t>(); }

TEST(ShortestNumber, RandomFloatsAreWrittenAsByTheStandardLibrary) { random_numbers_agree<float, std::uint32_t>(); }

template <class T>
void powers_and_their_neighbours_agree() {
  for (int exponent = -34; exponent < std::numeric_limits<T>::digits; ++exponent) {
    const T power = std::ldexp(T(1), exponent);
    for (const T value : {power, std::nextafter(power, T(0)), std::nextafter(power, 2 * power), -power})
      EXPECT_EQ(own(value), standard(value));
  }
}

TEST(ShortestNumber, PowersOfTwoAreWrittenAsByTheStandardLibraryWhere128BitsHoldThem) {
  powers_and_their_neighbours_agree<double>();
  powers_and_their_neighbours_agree<float>();
}

TEST(ShortestNumber, OfTwoDecimalsThatAreAsNearTheEvenOneIsWritten) {
  EXPECT_EQ(own(1125899906842624.25), "1125899906842624.2");
  EXPECT_EQ(own(1125899906842624.75), "1125899906842624.8");
}

TEST(ShortestNumber, FixedOrScientificIsTheShorterOne) {
  EXPECT_EQ(own(0.0), "0");
  EXPECT_EQ(own(1.0), "1");
  EXPECT_EQ(own(0.1), "0.1");
  EXPECT_EQ(own(-2.5), "-2.5");
  EXPECT_EQ(own(1e5), "1e+05");
  EXPECT_EQ(own(10000.0), "10000");
  EXPECT_EQ(own(0.001), "0.001");
  EXPECT_EQ(own(0.00001), "1e-05");
  EXPECT_EQ(own(-1.5e-10), "-1.5e-10");
  EXPECT_EQ(own(0.000123456), "0.000123456");
  EXPECT_EQ(own(1200000.0), "1200000");
  EXPECT_EQ(own(12345678901234567000.0), standard(12345678901234567000.0));
  EXPECT_EQ(own(1.7976931348623157e308), "1.7976931348623157e+308");
  EXPECT_EQ(own(0.1f), "0.1");
}

}  // namespace
}  // namespace graze::io
