#include "io/files/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace relievo {
namespace {

/// Every bit pattern is as likely as any other: all magnitudes, few short numbers.
double number_of_bits(uint64_t& state) {
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  double number = 0;
  std::memcpy(&number, &state, sizeof number);
  return std::isfinite(number) && std::fabs(number) < 1e15 ? number : std::fmod(number, 1e6);
}

TEST(NumberText, SearchFindsWhatTheLibraryGives) {
  uint64_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    const double number = number_of_bits(state);
    if (!std::isfinite(number)) continue;
    EXPECT_EQ(searched_text(number), shortest_text(number));
    const float coarse = static_cast<float>(number);
    EXPECT_EQ(searched_text(coarse), shortest_text(coarse));
  }
}

TEST(NumberText, ShortNumbersStayShort) {
  EXPECT_EQ(searched_text(0.0), "0");
  EXPECT_EQ(searched_text(-0.1), "-0.1");
  EXPECT_EQ(searched_text(1000.0), "1000");
  EXPECT_EQ(searched_text(1e9), "1e+09");
  EXPECT_EQ(searched_text(0.0001), "1e-04");
  for (const double number : {0.5, 12.25, 1e-3, 100000.0, 123456.0, 2.5e-5})
    EXPECT_EQ(searched_text(number), shortest_text(number));
}

}  // namespace
}  // namespace relievo
