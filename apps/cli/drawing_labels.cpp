#include "apps/cli/drawing_labels.h"

#include <utility>

#include "io/files/read_file.h"
#include "io/image/decode_image.h"
#include "io/image/png_decode.h"
#include "io/scribbles/read_scribbles.h"
#include "io/scribbles/scribble_image.h"
#include "relief/drawing/segment_drawing.h"

namespace relievo::cli {
namespace {

Result<Scribbles> load_scribbles(const std::string& name, const Image8& drawing) {
  const auto bytes = read_file(name);
  if (!bytes) return bytes.error();
  const auto strokes = [&]() -> Result<Scribbles> {
    if (!is_png(*bytes))
      return read_scribbles({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    const auto picture = decode_png(*bytes);
    if (!picture) return picture.error();
    return scribbles_from_image(*picture, drawing.width, drawing.height);
  }();
  if (strokes) return strokes;
  Error error = strokes.error();
  error.where = error.where.empty() ? name : name + ": " + error.where;
  return error;
}

}  // namespace

Result<std::vector<std::string>> label_drawing(const std::string& scribbles, SegmentInput& input) {
  if (!scribbles.empty()) {
    auto strokes = load_scribbles(scribbles, input.pixels);
    if (!strokes) return strokes.error();
    input.scribbles = std::move(*strokes);
  }
  auto segmentation = segment_drawing({input.pixels}, input.scribbles);
  if (!segmentation) return segmentation.error();
  for (size_t k = 0; k < segmentation->parts.size(); ++k) {
    const SegmentedPart& part = segmentation->parts[k];
    if (part.proposed) continue;
    PartCorrection& correction = input.corrections.parts[static_cast<PartLabel>(k + 1)];
    if (!correction.id) correction.id = part.id;
  }
  input.labels = std::move(segmentation->labels);
  return std::move(segmentation->notes);
}

}  // namespace relievo::cli
