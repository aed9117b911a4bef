/// Vector drawings that paint something else than the shapes that can be read of them.

#include "cli/cli_test.h"

namespace relievo {
namespace {

const std::string head = "<svg xmlns='http://www.w3.org/2000/svg' width='400' height='400'>";

/// A disc with a ring around it at a place; its paint is a marker's, which no reader makes a shape
/// of.
std::string marker(double x, double y, double radius) {
  const std::string r = std::to_string(radius);
  return "<marker id='m' markerUnits='userSpaceOnUse' overflow='visible' markerWidth='400' "
         "markerHeight='400'><circle r='" +
         r + "' fill='#c74' stroke='#320' stroke-width='6'/></marker><path fill='none' d='M" +
         std::to_string(x) + " " + std::to_string(y) + "h1' marker-start='url(#m)'/>";
}

const std::string square = "<rect x='60' y='60' width='180' height='180' fill='#4a7'/>";

struct VectorPaint : CliTest {
  /// What the program says of a drawing with this content.
  std::string words_on(const std::string& content) {
    write("painted.svg", head + content + "</svg>");
    const Outcome outcome = relievo({"check", "painted.svg"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  }
};

TEST_F(VectorPaint, MakesPartsWhereNoShapeDoes) {
  EXPECT_NE(words_on(marker(200, 200, 90)).find("no shape of the drawing makes a part"),
            std::string::npos);
  write("empty.svg", head + "</svg>");
  expect_failure({"check", "empty.svg"}, 3, "shows nothing opaque");
}

TEST_F(VectorPaint, IsNamedWhereItIsInNoPart) {
  const std::string beside = marker(320, 320, 25);
  EXPECT_NE(words_on(square + beside).find("7 % of the drawing is in no part"), std::string::npos);
  EXPECT_EQ(words_on(square + marker(320, 320, 8)).find("in no part"), std::string::npos)
      << "nobody sees so little";
  EXPECT_EQ(words_on("<g data-relievo='part'>" + square + "</g>" + beside).find("in no part"),
            std::string::npos)
      << "the file says what its parts are";
  const std::string words = words_on("<rect width='400' height='400' fill='#def'/>" + square +
                                     "<circle cx='150' cy='150' r='40' fill='#fff'/>");
  EXPECT_NE(words.find("background"), std::string::npos);
  EXPECT_EQ(words.find("in no part"), std::string::npos) << "a background is named as such";
}

}  // namespace
}  // namespace relievo
