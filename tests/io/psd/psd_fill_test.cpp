#include "io/psd/psd_fill.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>

namespace relievo {
namespace {

void put_number(Bytes& bytes, uint64_t value, int count) {
  for (int k = count - 1; k >= 0; --k) bytes.push_back(static_cast<uint8_t>(value >> (8 * k)));
}

void put_record(Bytes& bytes, int kind, const std::vector<int>& words) {
  Bytes record;
  put_number(record, kind, 2);
  for (const int word : words) put_number(record, static_cast<uint16_t>(word), 2);
  record.resize(26);
  bytes.insert(bytes.end(), record.begin(), record.end());
}

/// A corner without curves, in fractions of the canvas.
void put_knot(Bytes& bytes, double x, double y) {
  Bytes record;
  put_number(record, 2, 2);
  for (int k = 0; k < 3; ++k)
    for (const double value : {y, x})
      put_number(record, static_cast<uint32_t>(std::lround(value * (1 << 24))), 4);
  bytes.insert(bytes.end(), record.begin(), record.end());
}

Bytes mask_start(int flags = 0) {
  Bytes bytes;
  put_number(bytes, 3, 4);
  put_number(bytes, flags, 4);
  put_record(bytes, 6, {});
  put_record(bytes, 8, {0});
  return bytes;
}

void put_square(Bytes& bytes, double from, double to, int operation) {
  put_record(bytes, 0, {4, operation});
  put_knot(bytes, from, from);
  put_knot(bytes, to, from);
  put_knot(bytes, to, to);
  put_knot(bytes, from, to);
}

double area_of(const Region& region) {
  double sum = 0;
  for (const Ring& ring : region)
    for (size_t k = 0; k < ring.size(); ++k) {
      const Point2 p = ring[k];
      const Point2 q = ring[(k + 1) % ring.size()];
      sum += (p.x * q.y - q.x * p.y) / 2;
    }
  return sum;
}

TEST(VectorMask, CombinesItsPaths) {
  const auto area = [](int operation, int flags = 0) {
    Bytes bytes = mask_start(flags);
    put_square(bytes, 0.1, 0.5, 1);
    put_square(bytes, 0.3, 0.7, operation);
    const auto region = vector_mask(bytes, 100, 200);
    return region ? area_of(*region) : -1;
  };
  // Squares of 40 x 80 px with 20 x 40 px in common.
  EXPECT_NEAR(area(1), 5600, 1);
  EXPECT_NEAR(area(2), 2400, 1);
  EXPECT_NEAR(area(3), 800, 1);
  EXPECT_NEAR(area(0), 4800, 1);
  EXPECT_NEAR(area(-1), 4800, 1);
  EXPECT_NEAR(area(1, 1), 20000 - 5600, 1);  // inverted
  EXPECT_EQ(area(1, 4), -1);                 // disabled
  EXPECT_TRUE(vector_mask(mask_start(), 100, 200)->empty());
  EXPECT_FALSE(vector_mask(Bytes(5), 100, 200));
}

TEST(VectorMask, PathsThatBeginByTakingAwayLeaveTheRest) {
  Bytes bytes = mask_start();
  put_square(bytes, 0.1, 0.5, 2);
  EXPECT_NEAR(area_of(*vector_mask(bytes, 100, 100)), 10000 - 1600, 1);
}

TEST(VectorMask, CoverageIsThatOfThePixels) {
  const Region region = {{{1.25, 1}, {4.5, 1}, {4.5, 3.5}, {1.25, 3.5}}};
  const std::vector<uint8_t> values = coverage(region, {1, 0, 6, 5});
  EXPECT_EQ(values[0], 0);
  EXPECT_NEAR(values[5], 0.75 * 255, 1);
  EXPECT_EQ(values[6], 255);
  EXPECT_NEAR(values[8], 0.5 * 255, 1);
  EXPECT_NEAR(values[16], 0.5 * 255, 1);
  EXPECT_EQ(values[21], 0);
}

TEST(SolidFill, HasItsColourInRgbAlone) {
  Bytes block = bytes_of("....Rd  doub");
  put_number(block, std::bit_cast<uint64_t>(217.0), 8);
  for (const char* key : {"....Grn doub", "....Bl  doub"}) {
    const Bytes text = bytes_of(key);
    block.insert(block.end(), text.begin(), text.end());
    put_number(block, std::bit_cast<uint64_t>(82.4), 8);
  }
  const auto color = fill_color(block);
  ASSERT_TRUE(color);
  EXPECT_EQ(*color, (std::array<uint8_t, 3>{217, 82, 82}));
  block.resize(block.size() - 3);
  EXPECT_FALSE(fill_color(block));
  EXPECT_FALSE(fill_color(bytes_of("....Cyn doub")));
}

}  // namespace
}  // namespace relievo
