#include "io/scribbles/write_scribbles.h"

#include <nlohmann/json.hpp>

#include "io/scribbles/scribbles_json.h"

namespace relievo {
std::string write_scribbles(const understanding::Scribbles& scribbles) {
  std::string text = "{\n  \"format\": \"relievo-scribbles\",\n  \"version\": 1,\n  \"parts\": ";
  text += nlohmann::json(scribbles.parts).dump() + ",\n  \"strokes\": [";
  for (size_t k = 0; k < scribbles.strokes.size(); ++k)
    text += (k > 0 ? ",\n    " : "\n    ") + stroke_json(scribbles.strokes[k], scribbles).dump();
  return text + "\n  ]\n}\n";
}

}  // namespace relievo
