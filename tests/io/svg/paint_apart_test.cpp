#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <new>

#include "io/svg/render_svg.h"

namespace relievo {
namespace {

Result<Image8> painted(const std::function<Status(Image8&)>& paint, double seconds = 20) {
  PaintLimits limits;
  limits.seconds = seconds;
  return paint_apart(3, 2, limits, paint);
}

TEST(PaintApart, GivesThePixels) {
  const auto image = painted([](Image8& pixels) -> Status {
    pixels.at(2, 1, 3) = 200;
    return Done{};
  });
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->at(2, 1, 3), 200);
  EXPECT_EQ(image->at(0, 0, 0), 0);
}

TEST(PaintApart, PassesErrorsOn) {
  const auto image = painted([](Image8&) -> Status {
    return Error{ErrorCode::bad_input, "a reason", "a place"};
  });
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(to_string(image.error()), "a place: a reason");
  EXPECT_EQ(image.error().code, ErrorCode::bad_input);
}

TEST(PaintApart, SurvivesACrash) {
  const auto image = painted([](Image8&) -> Status { std::abort(); });
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::bad_input);
}

TEST(PaintApart, EndsWhatTakesTooLong) {
  const auto image = painted(
      [](Image8&) -> Status {
        for (;;) pause();
      },
      0.05);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::limit);
}

TEST(PaintApart, TooLittleMemoryIsALimit) {
  const auto image = painted([](Image8&) -> Status { throw std::bad_alloc(); });
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::limit);
}

#ifndef __SANITIZE_ADDRESS__
TEST(PaintApart, BoundsMemoryAndFiles) {
  const auto image = painted([](Image8& pixels) -> Status {
    void* block = std::malloc(size_t{1} << 31);
    pixels.at(0, 0, 0) = block == nullptr ? 1 : 0;
    std::free(block);
    pixels.at(0, 0, 1) = open("/dev/null", O_RDONLY) < 0 ? 1 : 0;
    return Done{};
  });
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->at(0, 0, 0), 1);
  EXPECT_EQ(image->at(0, 0, 1), 1);
}
#endif

}  // namespace
}  // namespace relievo
