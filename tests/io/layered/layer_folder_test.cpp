#include <gtest/gtest.h>

#include "io/image/png.h"
#include "io/layered/layer_files.h"
#include "io/layered/layer_support.h"
#include "io/layered/read_layer_folder.h"
#include "io/support/temporary_folder.h"
#include "relievo/files.h"

namespace relievo {
namespace {

using Names = std::vector<std::string>;

class LayerFolder : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }

  void write(const std::string& name, const Image8& image) const {
    write(name, to_text(*encode_png(image)));
  }

  Result<understanding::LayeredDrawing> read_folder(const ImageLimits& limits = {}) {
    return read_layer_folder(folder_.path(), files_, limits);
  }

  Error error() {
    const auto drawing = read_folder();
    EXPECT_FALSE(drawing);
    return drawing.ok() ? Error() : drawing.error();
  }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> files_;
};

TEST_F(LayerFolder, TheTableSaysOrderPlaceAndName) {
  write("a.png", disc(60, 60, {30, 30}, 28, blue));
  write("b.png", disc(200, 160, {100, 80}, 70, red));
  write("layers.tsv",
        "order_back_to_front\tfile\tname\tx\ty\n2\ta.png\thead\t150\t-10\n1\tb.png\tbody\t0\t0\n");
  auto drawing = read_folder();
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  EXPECT_EQ(part_names(*drawing), (Names{"body", "head"}));
  EXPECT_EQ(drawing->scene.width, 210);
  EXPECT_EQ(drawing->scene.height, 160);
  EXPECT_EQ(files_.size(), 3u);
}

TEST_F(LayerFolder, WithoutATableNamesGiveTheOrder) {
  write("10-head.png", disc(200, 200, {150, 100}, 40, blue));
  write("2-body.PNG", disc(200, 200, {100, 100}, 70, red));
  write("notes.txt", "not a layer");
  auto drawing = read_folder();
  ASSERT_TRUE(drawing) << to_string(drawing.error());
  EXPECT_EQ(part_names(*drawing), (Names{"2-body", "10-head"}));
}

/// Exporters trim pictures and keep their places to themselves.
TEST_F(LayerFolder, PicturesOfSeveralSizesWithoutPlacesGiveAWarning) {
  const auto says_table = [&] {
    const auto drawing = read_folder();
    EXPECT_TRUE(drawing);
    return std::any_of(drawing->warnings.begin(), drawing->warnings.end(), [](const auto& text) {
      return text.find("layers.tsv") != std::string::npos;
    });
  };
  write("1.png", disc(200, 160, {100, 80}, 70, red));
  EXPECT_FALSE(says_table());
  write("2.png", disc(60, 60, {30, 30}, 28, blue));
  EXPECT_TRUE(says_table());
  write("layers.tsv", "file\tx\ty\n1.png\t0\t0\n2.png\t150\t0\n");
  EXPECT_FALSE(says_table());
  std::filesystem::remove(folder_.path() / "layers.tsv");
  write("2.png", disc(200, 160, {100, 30}, 28, blue));
  EXPECT_FALSE(says_table());
}

TEST_F(LayerFolder, PixelsOfAllLayersTogetherAreLimited) {
  for (const char* name : {"1.png", "2.png", "3.png"})
    write(name, disc(60, 60, {30, 30}, 28, blue));
  ImageLimits limits;
  limits.max_total = 3 * 3600;
  EXPECT_TRUE(read_folder(limits));
  limits.max_total -= 1;
  const auto drawing = read_folder(limits);
  ASSERT_FALSE(drawing);
  EXPECT_EQ(drawing.error().code, ErrorCode::limit);
  EXPECT_NE(drawing.error().where.find("3.png"), std::string::npos);
}

TEST_F(LayerFolder, ErrorsNameTheFileOrTheLine) {
  EXPECT_NE(error().message.find("layers.tsv"), std::string::npos);
  write("layers.tsv", "file\nmissing.png\n");
  EXPECT_EQ(error().code, ErrorCode::file);
  EXPECT_NE(error().where.find("missing.png"), std::string::npos);
  write("missing.png", "no picture");
  EXPECT_EQ(error().code, ErrorCode::bad_input);
  EXPECT_NE(error().where.find("missing.png"), std::string::npos);
  write("layers.tsv", "file\n../missing.png\n");
  EXPECT_NE(error().where.find("line 2"), std::string::npos);
}

TEST_F(LayerFolder, LinksDoNotLeadOutOfIt) {
  const TemporaryFolder other;
  std::ofstream(other.path() / "secret.png") << "secret";
  std::filesystem::create_symlink(other.path() / "secret.png", folder_.path() / "a.png");
  EXPECT_NE(error().message.find("leads out"), std::string::npos) << error().message;
}

TEST_F(LayerFolder, ACanvasOverTheLimitIsRefusedFromTheHeaders) {
  write("a.png", disc(60, 60, {30, 30}, 28, blue));
  write("layers.tsv", "file\tx\na.png\t90000\n");
  EXPECT_EQ(error().code, ErrorCode::limit);
}

TEST(LayerTable, RefusesWhatItCannotRead) {
  const auto where = [](const std::string& text) {
    const auto rows = read_layer_table(text);
    EXPECT_FALSE(rows) << text;
    return rows.ok() ? "" : to_string(rows.error());
  };
  EXPECT_NE(where("").find("file"), std::string::npos);
  EXPECT_NE(where("file\tfile\na.png\tb.png").find("twice"), std::string::npos);
  EXPECT_NE(where("file\tx\na.png\tone").find("line 2: x"), std::string::npos);
  EXPECT_NE(where("file\topacity\na.png\t2").find("line 2: opacity"), std::string::npos);
  EXPECT_NE(where("file\tx\na.png\tnan").find("line 2: x"), std::string::npos);
  EXPECT_NE(where("file\tblend\na.png\tsoft").find("line 2: blend"), std::string::npos);
  EXPECT_NE(where("file\tlean\na.png\t0.5").find("line 2: lean"), std::string::npos);
  EXPECT_NE(where("file\tlean\na.png\t0.5 3").find("line 2: lean"), std::string::npos);
  EXPECT_NE(where("file\tlean\na.png\t0.5 0 0").find("line 2: lean"), std::string::npos);
  EXPECT_NE(where("file\trole\na.png\tlimb").find("role"), std::string::npos);
  EXPECT_NE(where("file\n\n\n").find("no layer"), std::string::npos);
  EXPECT_NE(where("file\nC:\\a.png\n").find("line 2"), std::string::npos);
}

TEST(LayerTable, RowsSayRolesBlendingAndAmounts) {
  const auto rows = read_layer_table(
      "file\trole\tc\tlean\tblend\r\na.png\t\t\t\tscreen\r\nb.png\tpart\t2\t0.5 -0.25\r\n");
  ASSERT_TRUE(rows);
  EXPECT_EQ((*rows)[0].layer.role, LayerRole::proposed);
  EXPECT_EQ((*rows)[0].layer.blending.mode, BlendMode::screen);
  EXPECT_TRUE((*rows)[1].layer.blending.is_plain());
  EXPECT_EQ((*rows)[1].layer.role, LayerRole::part);
  EXPECT_EQ((*rows)[1].layer.c, 2);
  EXPECT_FALSE((*rows)[0].layer.c);
  EXPECT_EQ((*rows)[1].layer.lean, (Point2{0.5, -0.25}));
  EXPECT_FALSE((*rows)[0].layer.lean);
}

}  // namespace
}  // namespace relievo
