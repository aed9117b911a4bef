#include "io/layered/layer_names.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

TEST(LayerNames, PrefixesSayWhatALayerIs) {
  const auto role = [](const std::string& name, LayerRole of_group = LayerRole::proposed) {
    return read_layer_name(name, of_group).role;
  };
  EXPECT_EQ(role("leg"), LayerRole::proposed);
  EXPECT_EQ(role("part:leg"), LayerRole::part);
  EXPECT_EQ(role("texture: spots"), LayerRole::texture);
  EXPECT_EQ(role("leg", LayerRole::texture), LayerRole::texture);
  EXPECT_EQ(role("part:leg", LayerRole::texture), LayerRole::texture);
  EXPECT_EQ(role("leg", LayerRole::part), LayerRole::proposed);
  EXPECT_EQ(read_layer_name("part: leg", LayerRole::proposed).plain, "leg");
  EXPECT_EQ(read_layer_name("part: leg", LayerRole::texture).plain, "part: leg");
  EXPECT_TRUE(read_layer_name("part:leg", LayerRole::proposed).merged);
}

TEST(LayerNames, TagsOfRigsAreNoNames) {
  const auto plain = [](const std::string& name) {
    return read_layer_name(name, LayerRole::proposed).plain;
  };
  EXPECT_EQ(plain("head [slot]"), "head");
  EXPECT_EQ(plain("[slot:brow] head [skin:cat]"), "head");
  EXPECT_EQ(plain("[slot:brow]"), "brow");
  EXPECT_EQ(plain("arm[BONE][scale:0.5]"), "arm");
  EXPECT_EQ(plain("Hai:r [x]"), "Hai:r [x]");
  EXPECT_EQ(plain("[note] arm [trim:false]"), "[note] arm");
  EXPECT_EQ(plain("arm [slot"), "arm [slot");
  EXPECT_TRUE(read_layer_name("[ignore] sketch", LayerRole::proposed).ignored);
  EXPECT_TRUE(read_layer_name("head [Merge]", LayerRole::proposed).merged);
  EXPECT_FALSE(read_layer_name("head", LayerRole::proposed).merged);
  EXPECT_EQ(read_layer_name("gloss [overlay]", LayerRole::proposed).role, LayerRole::texture);
  EXPECT_EQ(read_layer_name("part:head [slot]", LayerRole::proposed).plain, "head");
}

TEST(LayerNames, BlendingIsFoundByNameAndByKey) {
  EXPECT_EQ(named_blending("svg:multiply")->mode, BlendMode::multiply);
  EXPECT_EQ(named_blending("multiply")->mode, BlendMode::multiply);
  EXPECT_EQ(named_blending("svg:src-atop")->cover, CoverMode::atop);
  EXPECT_EQ(named_blending("svg:dst-out")->cover, CoverMode::below_out);
  EXPECT_TRUE(named_blending("svg:src-over")->is_plain());
  EXPECT_FALSE(named_blending("krita:behind"));
  EXPECT_EQ(keyed_mode({'m', 'u', 'l', ' '}), BlendMode::multiply);
  EXPECT_EQ(keyed_mode({'d', 'i', 'v', ' '}), BlendMode::color_dodge);
  EXPECT_EQ(keyed_mode({'p', 'a', 's', 's'}), BlendMode::normal);
  EXPECT_FALSE(keyed_mode({'d', 'i', 's', 's'}));
}

}  // namespace
}  // namespace relievo
