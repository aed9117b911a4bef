#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/image/decode_image.h"
#include "io/mesh/glb_decode.h"
#include "io/mesh/glb_encode.h"
#include "io/support/byte_reader.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

/// A GLB file taken apart without any of our code.
struct ParsedGlb {
  Json json;
  Bytes binary;

  explicit ParsedGlb(const Bytes& bytes) {
    ByteReader reader(bytes);
    EXPECT_EQ(reader.take_text(4), "glTF");
    EXPECT_EQ(reader.take<uint32_t>(), 2U);
    EXPECT_EQ(reader.take<uint32_t>(), bytes.size());
    const uint32_t json_size = reader.take<uint32_t>();
    EXPECT_EQ(json_size % 4, 0U);
    EXPECT_EQ(reader.take_text(4), "JSON");
    json = Json::parse(reader.take_text(json_size));
    const uint32_t binary_size = reader.take<uint32_t>();
    EXPECT_EQ(reader.take_text(4), std::string("BIN\0", 4));
    const std::string text = reader.take_text(binary_size);
    binary.assign(text.begin(), text.end());
    EXPECT_TRUE(reader.at_end());
  }

  Json view(size_t index) const { return json.at("bufferViews").at(index); }

  template <class Number>
  std::vector<double> numbers(size_t accessor_index, size_t components) const {
    const Json accessor = json.at("accessors").at(accessor_index);
    ByteReader reader(binary);
    reader.seek(view(accessor.at("bufferView")).at("byteOffset").get<size_t>() +
                accessor.at("byteOffset").get<size_t>());
    std::vector<double> values(accessor.at("count").get<size_t>() * components);
    for (double& value : values) value = static_cast<double>(reader.take<Number>());
    return values;
  }

  Json primitive(size_t mesh) const { return json.at("meshes").at(mesh).at("primitives").at(0); }
};

TEST(Glb, PartsAreNodesWithTheirNamesAndValues) {
  const ParsedGlb glb(*encode_glb(split_hemisphere(10), nullptr, {}, "ball"));
  ASSERT_EQ(glb.json["nodes"].size(), 3U);
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json::array({2}));
  EXPECT_EQ(glb.json["nodes"][2], Json({{"name", "ball"}, {"children", {0, 1}}}));
  EXPECT_EQ(glb.json["nodes"][0]["name"], "left half");
  EXPECT_EQ(glb.json["nodes"][1]["extras"], Json({{"part", "right half"},
                                                  {"order", 1},
                                                  {"c", 2.0},
                                                  {"d", 0.5},
                                                  {"flat", 0.25},
                                                  {"lean", {0.5, -0.125}}}));
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["asset"]["generator"].get<std::string>().rfind("relievo ", 0), 0U);
  EXPECT_EQ(glb.json["materials"][0]["doubleSided"], true);
  EXPECT_FALSE(glb.json.contains("images"));
}

TEST(Glb, PartAloneHasTheNameOfTheFile) {
  const Bytes bytes = *encode_glb(hemisphere(10), nullptr, {}, "ball");
  const ParsedGlb glb(bytes);
  ASSERT_EQ(glb.json["nodes"].size(), 1U);
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], Json::array({0}));
  EXPECT_EQ(glb.json["nodes"][0]["name"], "ball");
  EXPECT_EQ(decode_glb(bytes)->model.parts[0].id, hemisphere(10).parts[0].id);
}

TEST(Glb, InkIsAnUnlitMeshOfItsOwnThatHidesBackFaces) {
  Model model = hemisphere(10);
  model.ink = ink_rectangle({2, 3}, {9, 8}, 11, true);
  const Drawing drawing = quarters();
  const Bytes bytes = *encode_glb(model, &drawing, {}, "ball");
  const ParsedGlb glb(bytes);
  ASSERT_EQ(glb.json["nodes"].size(), 3U);
  EXPECT_EQ(glb.json["nodes"][1]["name"], "ink");
  EXPECT_EQ(glb.json["nodes"][2]["children"], Json::array({0, 1}));
  const Json material = glb.json["materials"][glb.primitive(1)["material"].get<size_t>()];
  EXPECT_EQ(material["name"], "ink");
  EXPECT_FALSE(material.contains("doubleSided"));
  EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  EXPECT_EQ(glb.json["extensionsUsed"], Json::array({"KHR_materials_unlit"}));
  const Model read = decode_glb(bytes)->model;
  EXPECT_EQ(read.parts.size(), 1U);
  EXPECT_EQ(read.triangles.size(), model.triangles.size());
  EXPECT_EQ(read.ink.triangles, model.ink.triangles);
  ASSERT_EQ(read.ink.positions.size(), 4U);
  for (size_t v = 0; v < 4; ++v) {
    EXPECT_LT(norm(read.ink.positions[v] - model.ink.positions[v]), 1e-5);
    EXPECT_LT(distance(read.ink.uvs[v], model.ink.uvs[v]), 1e-6);
  }
}

TEST(Glb, InkThatIsNotFiniteIsRefused) {
  Model model = hemisphere(10);
  model.ink = ink_rectangle({2, 3}, {9, 8}, NAN, true);
  EXPECT_EQ(encode_glb(model, nullptr).error().code, ErrorCode::bad_input);
}

TEST(Glb, GroundedModelStandsOnTheGround) {
  for (const bool grounded : {false, true}) {
    const ParsedGlb glb(
        *encode_glb(hemisphere(10), nullptr, {.size_mm = 50, .grounded = grounded}));
    const size_t positions = glb.primitive(0)["attributes"]["POSITION"];
    const Json accessor = glb.json["accessors"][positions];
    EXPECT_NEAR(accessor["min"][1].get<double>(), grounded ? 0 : -0.025, 1e-8);
    EXPECT_NEAR(accessor["max"][1].get<double>(), grounded ? 0.05 : 0.025, 1e-8);
    EXPECT_NEAR(accessor["min"][0].get<double>(), -0.025, 1e-8);
  }
}

TEST(Glb, VerticesAreCentredMetresAndMatchTheModel) {
  const Model model = split_hemisphere(10);
  const ParsedGlb glb(*encode_glb(model, nullptr, {.size_mm = 50}));
  const double scale = 0.05 / 20;
  for (size_t part = 0; part < 2; ++part) {
    const Json attributes = glb.primitive(part)["attributes"];
    const auto positions = glb.numbers<float>(attributes["POSITION"], 3);
    const auto normals = glb.numbers<float>(attributes["NORMAL"], 3);
    const auto uvs = glb.numbers<float>(attributes["TEXCOORD_0"], 2);
    const auto indices = glb.numbers<uint16_t>(glb.primitive(part)["indices"], 1);
    const ModelPart& source = model.parts[part];
    ASSERT_EQ(indices.size(), 3 * static_cast<size_t>(source.triangle_count));
    for (size_t i = 0; i < indices.size(); ++i) {
      const int v = model.triangles[source.first_triangle + i / 3][i % 3];
      const auto at = static_cast<size_t>(indices[i]);
      ASSERT_NEAR(positions[3 * at], scale * (model.positions[v].x - 12.5), 1e-8);
      ASSERT_NEAR(positions[3 * at + 1], scale * (model.positions[v].y - 12.5), 1e-8);
      ASSERT_NEAR(positions[3 * at + 2], scale * model.positions[v].z, 1e-8);
      ASSERT_NEAR(normals[3 * at + 2], model.normals[v].z, 1e-6);
      ASSERT_NEAR(uvs[2 * at], model.uvs[v].x, 1e-6);
      ASSERT_NEAR(uvs[2 * at + 1], model.uvs[v].y, 1e-6);
    }
  }
}

TEST(Glb, BoundsAreThoseOfTheStoredFloats) {
  const ParsedGlb glb(*encode_glb(split_hemisphere(7), nullptr));
  for (size_t part = 0; part < 2; ++part) {
    const size_t accessor = glb.primitive(part)["attributes"]["POSITION"];
    const auto positions = glb.numbers<float>(accessor, 3);
    for (size_t k = 0; k < 3; ++k) {
      double low = positions[k];
      double high = positions[k];
      for (size_t i = k; i < positions.size(); i += 3) {
        low = std::min(low, positions[i]);
        high = std::max(high, positions[i]);
      }
      EXPECT_EQ(glb.json["accessors"][accessor]["min"][k].get<double>(), low);
      EXPECT_EQ(glb.json["accessors"][accessor]["max"][k].get<double>(), high);
    }
  }
}

TEST(Glb, TextureIsEmbeddedUprightAndOpaque) {
  const Drawing drawing = quarters();
  const Model model = split_hemisphere(10);
  const ParsedGlb glb(*encode_glb(model, &drawing));
  const Json view = glb.view(glb.json["images"][0]["bufferView"]);
  const size_t offset = view["byteOffset"];
  const size_t length = view["byteLength"];
  const Result<Image8> image = decode_image(ByteView(glb.binary).subspan(offset, length));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->pixels, drawing.rgba.pixels);
  EXPECT_EQ(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  // The vertex at the top left of the model must find the red, top-left quarter.
  const Json attributes = glb.primitive(0)["attributes"];
  const auto positions = glb.numbers<float>(attributes["POSITION"], 3);
  const auto uvs = glb.numbers<float>(attributes["TEXCOORD_0"], 2);
  size_t top_left = 0;
  for (size_t v = 0; v < positions.size() / 3; ++v)
    if (positions[3 * v + 1] - positions[3 * v] >
        positions[3 * top_left + 1] - positions[3 * top_left])
      top_left = v;
  EXPECT_EQ(image->at(static_cast<int>(8 * uvs[2 * top_left]),
                      static_cast<int>(8 * uvs[2 * top_left + 1]), 1),
            0);
}

TEST(Glb, PixelArtIsNotSmoothed) {
  Drawing drawing = quarters();
  const Model model = split_hemisphere(10);
  const auto filters = [&] {
    const ParsedGlb glb(*encode_glb(model, &drawing));
    const Json sampler = glb.json["samplers"][0];
    return std::pair(sampler["magFilter"].get<int>(), sampler["minFilter"].get<int>());
  };
  EXPECT_EQ(filters(), std::pair(9729, 9987));  // linear, between mipmaps too
  EXPECT_EQ(decode_glb(*encode_glb(model, &drawing))->drawing.pixel_art, 0);
  drawing.pixel_art = 4;
  EXPECT_EQ(filters(), std::pair(9728, 9728));  // nearest
  EXPECT_EQ(decode_glb(*encode_glb(model, &drawing))->drawing.pixel_art, 1);
}

TEST(Glb, PartsWithoutFacesAreLeftOut) {
  Model model = hemisphere(5, 4);
  model.parts.insert(model.parts.begin(), ModelPart{"hidden", 4, 1, 0, {}, 0, 0});
  const ParsedGlb glb(*encode_glb(model, nullptr));
  ASSERT_EQ(glb.json["nodes"].size(), 1U);
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["order"], 1);
}

TEST(Glb, ManyVerticesTakeWideIndices) {
  const ParsedGlb glb(*encode_glb(hemisphere(5, 190), nullptr));
  const size_t accessor = glb.primitive(0)["indices"];
  EXPECT_EQ(glb.json["accessors"][accessor]["componentType"], 5125);
  const auto indices = glb.numbers<uint32_t>(accessor, 1);
  EXPECT_GT(*std::max_element(indices.begin(), indices.end()), 65535);
}

TEST(Glb, SameModelGivesSameBytes) {
  const Drawing drawing = quarters();
  EXPECT_EQ(*encode_glb(split_hemisphere(3), &drawing), *encode_glb(split_hemisphere(3), &drawing));
}

TEST(Glb, ReadsWhatItWrites) {
  const Drawing drawing = quarters();
  const Model model = split_hemisphere(10);
  const Result<relief::DrawnModel> read = decode_glb(*encode_glb(model, &drawing, {.size_mm = 80}));
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->drawing.rgba.pixels, drawing.rgba.pixels);
  EXPECT_EQ(read->model.width, model.width);
  EXPECT_EQ(read->model.height, model.height);
  ASSERT_EQ(read->model.triangles.size(), model.triangles.size());
  for (size_t t = 0; t < model.triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      const int a = model.triangles[t][k];
      const int b = read->model.triangles[t][k];
      ASSERT_LT(norm(model.positions[a] - read->model.positions[b]), 1e-5);
      ASSERT_LT(norm(model.normals[a] - read->model.normals[b]), 1e-6);
      ASSERT_LT(distance(model.uvs[a], read->model.uvs[b]), 1e-6);
    }
  ASSERT_EQ(read->model.parts.size(), 2U);
  EXPECT_EQ(read->model.parts[1].id, "right half");
  EXPECT_EQ(read->model.parts[1].d, 0.5);
  EXPECT_EQ(read->model.parts[1].flat, 0.25);
  EXPECT_EQ(read->model.parts[1].lean, (Point2{0.5, -0.125}));
  EXPECT_EQ(read->model.parts[1].first_triangle, model.parts[1].first_triangle);
}

TEST(Glb, RefusesModelsThatAreNone) {
  EXPECT_EQ(encode_glb(empty_model(5, 5), nullptr).error().code, ErrorCode::bad_input);
  EXPECT_EQ(encode_glb(hemisphere(5), nullptr, {.size_mm = 0}).error().code, ErrorCode::usage);
  EXPECT_EQ(encode_glb(hemisphere(5), nullptr, {.size_mm = NAN}).error().code, ErrorCode::usage);
  Model broken = hemisphere(5);
  broken.positions[7].z = NAN;
  const Result<Bytes> refused = encode_glb(broken, nullptr);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_input);
  EXPECT_EQ(refused.error().where, "vertex 7");
}

}  // namespace
}  // namespace relievo
