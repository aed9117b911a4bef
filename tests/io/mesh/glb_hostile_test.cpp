#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "io/files/byte_writer.h"
#include "io/mesh/glb_decode.h"
#include "io/mesh/glb_encode.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

Bytes sample() {
  const Drawing drawing = quarters();
  return *encode_glb(hemisphere(5, 3), &drawing);
}

const GlbLimits small_limits = {10'000, 10'000, 1 << 20, {1 << 20, 1 << 12}};

/// The sample with its JSON edited; the binary chunk stays.
template <class Edit>
Bytes edited(Edit edit) {
  const Bytes bytes = sample();
  const size_t size = bytes[12] | bytes[13] << 8 | bytes[14] << 16;
  Json json = Json::parse(bytes.begin() + 20, bytes.begin() + 20 + size);
  edit(json);
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  Bytes result(bytes.begin(), bytes.begin() + 8);
  append_u32(result, static_cast<uint32_t>(bytes.size() - size + text.size()));
  append_u32(result, static_cast<uint32_t>(text.size()));
  append_text(result, "JSON" + text);
  result.insert(result.end(), bytes.begin() + 20 + size, bytes.end());
  return result;
}

TEST(HostileGlb, TheUneditedSampleIsSound) {
  EXPECT_TRUE(decode_glb(sample(), small_limits).ok());
  EXPECT_TRUE(decode_glb(edited([](Json&) {}), small_limits).ok());
}

TEST(HostileGlb, TruncationAtEveryByteIsRefused) {
  const Bytes glb = sample();
  for (size_t size = 0; size < glb.size(); ++size) {
    const Result<relief::DrawnModel> refused = decode_glb(ByteView(glb).first(size), small_limits);
    ASSERT_FALSE(refused.ok()) << size;
    ASSERT_EQ(refused.error().code, ErrorCode::bad_input);
  }
}

TEST(HostileGlb, FlippedBitsGiveAModelOrAnError) {
  const Bytes glb = sample();
  int refused = 0;
  for (size_t bit = 0; bit < 8 * glb.size(); ++bit) {
    Bytes damaged = glb;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
    refused += decode_glb(damaged, small_limits).ok() ? 0 : 1;
  }
  EXPECT_GT(refused, 1000);
}

TEST(HostileGlb, RandomDamageGivesAModelOrAnError) {
  const Bytes glb = sample();
  std::mt19937 random(20181204);
  for (int run = 0; run < 5000; ++run) {
    Bytes damaged = glb;
    for (uint32_t i = 0, count = 1 + random() % 8; i < count; ++i)
      damaged[random() % damaged.size()] = static_cast<uint8_t>(random());
    const Result<relief::DrawnModel> result = decode_glb(damaged, small_limits);
    ASSERT_TRUE(result.ok() || !result.error().message.empty());
  }
}

TEST(HostileGlb, VerticesFarFromTheCanvasAreRefused) {
  for (const double far : {2e9, -2e9, 1e19, 1e300}) {
    const Bytes glb = edited([&](Json& j) { j["scenes"][0]["extras"]["origin"][2] = far; });
    const Result<relief::DrawnModel> refused = decode_glb(glb, small_limits);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
  }
}

TEST(HostileGlb, LyingDescriptionsAreRefused) {
  const std::vector<void (*)(Json&)> lies = {
      [](Json& j) { j["accessors"][0]["count"] = 4'000'000'000U; },
      [](Json& j) { j["accessors"][0]["count"] = 1e300; },
      [](Json& j) { j["accessors"][0]["count"] = -1; },
      [](Json& j) { j["accessors"][0]["count"] = 0; },
      [](Json& j) { j["accessors"][0]["byteOffset"] = 4'294'967'295U; },
      [](Json& j) { j["accessors"][0]["bufferView"] = 99; },
      [](Json& j) { j["accessors"][0]["type"] = "VEC2"; },
      [](Json& j) { j["accessors"][0]["type"] = 3; },
      [](Json& j) { j["accessors"][0]["componentType"] = 5120; },
      [](Json& j) { j["accessors"][0]["sparse"] = Json::object(); },
      [](Json& j) { j["accessors"] = Json::object(); },
      [](Json& j) { j.erase("accessors"); },
      [](Json& j) { j["bufferViews"][0]["byteLength"] = 4'294'967'295U; },
      [](Json& j) { j["bufferViews"][0]["byteOffset"] = 4'294'967'295U; },
      [](Json& j) { j["bufferViews"][0]["byteStride"] = 1; },
      [](Json& j) { j["bufferViews"][0]["byteStride"] = 4'294'967'295U; },
      [](Json& j) { j["bufferViews"][0]["buffer"] = 1; },
      [](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 1; },
      [](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = 0; },
      [](Json& j) { j["meshes"][0]["primitives"][0]["attributes"] = 7; },
      [](Json& j) { j["meshes"][0]["primitives"] = nullptr; },
      [](Json& j) { j["nodes"] = "none"; },
      [](Json& j) { j["nodes"][0]["mesh"] = 1; },
      [](Json& j) {
        j["nodes"][0]["scale"] = {1, 2, 3};
      },
      [](Json& j) { j["scenes"][0]["extras"]["scale"] = 0; },
      [](Json& j) { j["scenes"][0]["extras"]["scale"] = 1e-320; },
      [](Json& j) {
        j["scenes"][0]["extras"]["origin"] = {1, 2};
      },
      [](Json& j) {
        j["scenes"][0]["extras"]["canvas"] = {-1, 5};
      },
      [](Json& j) { j["textures"][0]["source"] = 5; },
      [](Json& j) {
        j["images"][0] = {{"uri", "file:///etc/passwd"}};
      },
      [](Json& j) { j["images"][0]["bufferView"] = 0; },
      [](Json& j) { j = Json::array(); },
  };
  for (size_t i = 0; i < lies.size(); ++i) {
    const Result<relief::DrawnModel> refused = decode_glb(edited(lies[i]), small_limits);
    ASSERT_FALSE(refused.ok()) << "lie " << i;
    EXPECT_EQ(refused.error().code, ErrorCode::bad_input) << "lie " << i;
  }
}

TEST(HostileGlb, MeshesUsedOverAndOverHitTheLimit) {
  const Bytes glb = edited([](Json& j) {
    const Json node = j["nodes"][0];
    for (int i = 0; i < 1000; ++i) j["nodes"].push_back(node);
  });
  EXPECT_EQ(decode_glb(glb, small_limits).error().code, ErrorCode::limit);
}

TEST(HostileGlb, DeepNestingIsRefused) {
  const Bytes glb = edited([](Json& j) {
    Json deep = 1;
    for (int i = 0; i < 200; ++i) deep = Json::array({deep});
    j["extras"] = deep;
  });
  EXPECT_EQ(decode_glb(glb, small_limits).error().code, ErrorCode::bad_input);
}

TEST(HostileGlb, WithoutExtrasTheBoundingBoxIsTheCanvas) {
  const Bytes glb = edited([](Json& j) { j["scenes"][0].erase("extras"); });
  const Result<relief::DrawnModel> read = decode_glb(glb, small_limits);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_NEAR(read->model.width, 1000, 1e-3);
  for (const Point3 p : read->model.positions) {
    ASSERT_GE(p.x, -1e-3);
    ASSERT_LE(p.x, 1000 + 1e-3);
  }
}

}  // namespace
}  // namespace relievo
