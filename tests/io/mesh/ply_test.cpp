#include <gtest/gtest.h>

#include "io/mesh/ply_encode.h"
#include "io/support/byte_reader.h"
#include "io/support/temporary_folder.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

constexpr const char* end_of_header = "end_header\n";

std::string header_of(const Bytes& ply) {
  const std::string text = to_text(ply);
  return text.substr(0, text.find(end_of_header) + std::string(end_of_header).size());
}

TEST(Ply, HeaderDescribesTheBody) {
  const Model model = split_hemisphere(10);
  const Drawing drawing = quarters();
  const std::string header = header_of(*encode_ply(model, &drawing, {.size_mm = 100}, "wolf.png"));
  EXPECT_EQ(header.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0U);
  EXPECT_NE(header.find("\ncomment TextureFile wolf.png\n"), std::string::npos);
  EXPECT_NE(header.find("element vertex " + std::to_string(model.positions.size()) +
                        "\nproperty float x\nproperty float y\nproperty float z\n"
                        "property float nx\nproperty float ny\nproperty float nz\n"
                        "property float s\nproperty float t\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\n"),
            std::string::npos);
  EXPECT_EQ(header_of(*encode_ply(model, nullptr)).find("red"), std::string::npos);
}

TEST(Ply, BodyMatchesTheModelAndTheDrawing) {
  const Model model = split_hemisphere(10);
  const Drawing drawing = quarters();
  const Bytes ply = *encode_ply(model, &drawing, {.size_mm = 20});
  ByteReader reader(ply);
  reader.take_text(header_of(ply).size());
  for (size_t v = 0; v < model.positions.size(); ++v) {
    ASSERT_NEAR(reader.take<float>(), model.positions[v].x - 12.5, 1e-5);
    ASSERT_NEAR(reader.take<float>(), model.positions[v].y - 12.5, 1e-5);
    ASSERT_NEAR(reader.take<float>(), model.positions[v].z, 1e-5);
    ASSERT_NEAR(reader.take<float>(), model.normals[v].x, 1e-6);
    ASSERT_NEAR(reader.take<float>(), model.normals[v].y, 1e-6);
    ASSERT_NEAR(reader.take<float>(), model.normals[v].z, 1e-6);
    ASSERT_NEAR(reader.take<float>(), model.uvs[v].x, 1e-6);
    ASSERT_NEAR(reader.take<float>(), 1 - model.uvs[v].y, 1e-6);
    const int x = static_cast<int>(8 * model.uvs[v].x);
    const int y = static_cast<int>(8 * model.uvs[v].y);
    for (int c = 0; c < 3; ++c) ASSERT_EQ(reader.take<uint8_t>(), drawing.rgba.at(x, y, c));
  }
  for (const std::array<int, 3>& triangle : model.triangles) {
    ASSERT_EQ(reader.take<uint8_t>(), 3);
    for (const int v : triangle) ASSERT_EQ(reader.take<int32_t>(), v);
  }
  EXPECT_TRUE(reader.at_end());
}

TEST(Ply, ATextureNameCannotForgeTheHeader) {
  const Result<Bytes> refused =
      encode_ply(hemisphere(5), nullptr, {.size_mm = 100}, "a\nelement face 9");
  EXPECT_EQ(refused.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace relievo
