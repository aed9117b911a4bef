#include <gtest/gtest.h>

#include "relievo/render.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

Image8 picture(const Model& model, Shading shading) {
  RenderOptions options;
  options.width = 100;
  options.height = 100;
  options.window = RenderWindow{{50, 50}, 100};
  options.shading = shading;
  const Drawing drawing = quarters();
  Result<Image8> image = render_model(model, &drawing, options);
  EXPECT_TRUE(image.ok()) << to_string(image.error());
  return *image;
}

class RenderInk : public ::testing::Test {
 protected:
  RenderInk() { add_plane(page_, "page", 0); }

  /// Returns the page with a red rectangle of ink before it.
  Model inked(bool facing) const {
    Model model = page_;
    model.ink = ink_rectangle({60, 10}, {90, 40}, 30, facing);
    return model;
  }

  Model page_ = empty_model(100, 100);
};

TEST_F(RenderInk, HasItsOwnColourWhateverTheLight) {
  const Image8 image = picture(inked(true), Shading::textured);
  for (const int y : {65, 75, 85}) {
    EXPECT_EQ(image.at(75, y, 0), 255);
    EXPECT_EQ(image.at(75, y, 1), 0);
  }
}

TEST_F(RenderInk, IsNotSeenFromBehindAndCastsNoShadow) {
  EXPECT_TRUE(picture(inked(false), Shading::textured).pixels ==
              picture(page_, Shading::textured).pixels);
}

TEST_F(RenderInk, IsLeftOutOfClay) {
  EXPECT_TRUE(picture(inked(true), Shading::clay).pixels == picture(page_, Shading::clay).pixels);
}

}  // namespace
}  // namespace relievo
