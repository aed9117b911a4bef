#include <utility>

#include "face/inputs.h"
#include "io/files/in_file.h"
#include "io/image/decode_image.h"
#include "relief/drawing/segment_drawing.h"
#include "relief/pipeline/understand_drawing.h"
#include "relievo/read.h"

namespace relievo {

Result<DrawnScene> read_drawing(const std::filesystem::path& path) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto input = load_scene(*file, true);
  if (!input) return input.error();
  return DrawnScene{std::move(input->scene), std::move(input->drawing), std::move(input->files),
                    std::move(input->warnings), input->proposed};
}

Result<DrawnScene> understand_picture(const std::filesystem::path& path,
                                      const RunContext& context) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto pixels = decode_image(file->bytes);
  if (!pixels) return in_file(pixels.error(), file->name);
  Drawing drawing{std::move(*pixels)};
  auto found = segment_drawing(drawing, {}, {}, context);
  if (!found) return in_file(found.error(), file->name);
  const Relabelling labels = relabel(*found, {});
  auto understood = understand_drawing(drawing.rgba, labels.record, {}, {}, context);
  if (!understood) return in_file(understood.error(), file->name);
  std::vector<std::string> warnings = std::move(found->notes);
  const std::vector<std::string>& more = understood->proposal.warnings;
  warnings.insert(warnings.end(), more.begin(), more.end());
  return DrawnScene{
      std::move(understood->scene), std::move(drawing), {path}, std::move(warnings), true};
}

}  // namespace relievo
