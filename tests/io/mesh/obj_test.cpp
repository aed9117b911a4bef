#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <set>
#include <sstream>
#include <utility>

#include "io/image/decode_image.h"
#include "io/mesh/obj_encode.h"
#include "io/support/temporary_folder.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

struct ObjFace {
  std::string object;
  std::string material;
  std::array<int, 3> vertices;
};

/// An OBJ file read by the words of its lines.
struct ParsedObj {
  std::vector<std::vector<double>> v, vt, vn;
  std::vector<ObjFace> faces;
  std::string library;

  explicit ParsedObj(const Bytes& bytes) {
    std::istringstream text(to_text(bytes));
    text.imbue(std::locale::classic());
    std::string line, object, material;
    while (std::getline(text, line)) {
      std::istringstream words(line);
      words.imbue(std::locale::classic());
      std::string keyword;
      words >> keyword;
      if (keyword == "o") words >> object;
      if (keyword == "usemtl") words >> material;
      if (keyword == "mtllib") words >> library;
      if (keyword == "v") v.push_back(numbers(words));
      if (keyword == "vt") vt.push_back(numbers(words));
      if (keyword == "vn") vn.push_back(numbers(words));
      if (keyword == "f") faces.push_back({object, material, face(words)});
    }
  }

  static std::vector<double> numbers(std::istream& words) {
    std::vector<double> result;
    for (double value; words >> value;) result.push_back(value);
    return result;
  }

  static std::array<int, 3> face(std::istream& words) {
    std::array<int, 3> result{};
    for (int& vertex : result) {
      int vt = 0, vn = 0;
      char slash = 0;
      words >> vertex >> slash >> vt >> slash >> vn;
      EXPECT_TRUE(vt == vn && vertex >= 1 && vertex <= vt);
    }
    return result;
  }
};

TEST(Obj, GeometryMatchesTheModel) {
  const Model model = split_hemisphere(10);
  const ParsedObj obj(encode_obj(model, nullptr, {.size_mm = 40}, "m")->obj);
  ASSERT_EQ(obj.v.size(), model.positions.size());
  for (size_t i = 0; i < obj.v.size(); ++i) {
    ASSERT_NEAR(obj.v[i][0], 2 * (model.positions[i].x - 12.5), 1e-5);
    ASSERT_NEAR(obj.v[i][1], 2 * (model.positions[i].y - 12.5), 1e-5);
    ASSERT_NEAR(obj.v[i][2], 2 * model.positions[i].z, 1e-5);
    ASSERT_NEAR(obj.vt[i][0], model.uvs[i].x, 1e-6);
    ASSERT_NEAR(obj.vt[i][1], 1 - model.uvs[i].y, 1e-6);
    ASSERT_NEAR(obj.vn[i][0], model.normals[i].x, 1e-6);
  }
  ASSERT_EQ(obj.faces.size(), model.triangles.size());
  for (size_t t = 0; t < obj.faces.size(); ++t)
    for (size_t k = 0; k < 3; ++k) ASSERT_EQ(obj.faces[t].vertices[k], model.triangles[t][k] + 1);
}

TEST(Obj, PositionsAreSharedWhereAttributesDiffer) {
  // The two halves again, with vertices of their own along the seam.
  Model model = split_hemisphere(10);
  const size_t places = model.positions.size();
  std::vector<int> copy(places, -1);
  const ModelPart& right = model.parts[1];
  for (int t = right.first_triangle; t < right.first_triangle + right.triangle_count; ++t)
    for (int& v : model.triangles[t]) {
      if (copy[v] < 0) {
        copy[v] = static_cast<int>(model.positions.size());
        model.positions.push_back(model.positions[v]);
        model.normals.push_back({0, 0, 1});
        model.uvs.push_back(model.uvs[v]);
      }
      v = copy[v];
    }
  const ParsedObj obj(encode_obj(model, nullptr, {.size_mm = 40}, "m")->obj);
  EXPECT_EQ(obj.v.size(), places);
  EXPECT_EQ(obj.vn.size(), model.normals.size());
  std::set<std::pair<int, int>> edges;
  for (const ObjFace& face : obj.faces)
    for (size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(edges.emplace(face.vertices[k], face.vertices[(k + 1) % 3]).second);
  // Only the rim of the hemisphere is open.
  const auto open = std::count_if(edges.begin(), edges.end(), [&edges](const auto& edge) {
    return edges.count({edge.second, edge.first}) == 0;
  });
  EXPECT_EQ(open, 48);
}

TEST(Obj, PartsAreObjectsWithTheMaterial) {
  const Model model = split_hemisphere(10);
  const ParsedObj obj(encode_obj(model, nullptr, {.size_mm = 100}, "m")->obj);
  EXPECT_EQ(obj.faces.front().object, "left_half");
  EXPECT_EQ(obj.faces[model.parts[1].first_triangle - 1].object, "left_half");
  EXPECT_EQ(obj.faces[model.parts[1].first_triangle].object, "right_half");
  EXPECT_EQ(obj.faces.back().material, "drawing");
}

TEST(Obj, FilesReferToEachOtherByHarmlessNames) {
  const Drawing drawing = quarters();
  const Result<ObjFiles> files =
      encode_obj(hemisphere(5), &drawing, {.size_mm = 100}, "my wolf\n#1");
  ASSERT_TRUE(files.ok());
  EXPECT_EQ(ParsedObj(files->obj).library, "my_wolf__1.mtl");
  EXPECT_NE(to_text(files->mtl).find("\nmap_Kd my_wolf__1.png\n"), std::string::npos);
  EXPECT_NE(to_text(files->mtl).find("newmtl drawing\n"), std::string::npos);
  EXPECT_EQ(decode_image(files->png)->pixels, drawing.rgba.pixels);
}

TEST(Obj, WithoutDrawingThereIsNoTexture) {
  const Result<ObjFiles> files = encode_obj(hemisphere(5), nullptr);
  ASSERT_TRUE(files.ok());
  EXPECT_TRUE(files->png.empty());
  EXPECT_EQ(to_text(files->mtl).find("map_Kd"), std::string::npos);
}

TEST(Obj, TopOfTheDrawingIsTopOfTheTexture) {
  const Model model = hemisphere(10);
  const ParsedObj obj(encode_obj(model, nullptr)->obj);
  for (size_t i = 0; i < obj.v.size(); ++i)
    ASSERT_EQ(obj.v[i][1] > 1e-6, obj.vt[i][1] > 0.5 + 1e-7) << i;
}

TEST(Obj, NumbersDoNotFollowTheLocale) {
  const Bytes before = encode_obj(hemisphere(5), nullptr)->obj;
  const std::string saved = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) std::setlocale(LC_ALL, "C.UTF-8");
  const Bytes after = encode_obj(hemisphere(5), nullptr)->obj;
  std::setlocale(LC_ALL, saved.c_str());
  EXPECT_EQ(before, after);
  EXPECT_EQ(to_text(before).find(','), to_text(before).find(", millimetres"));
}

}  // namespace
}  // namespace relievo
