#include <utility>

#include "face/inputs.h"
#include "face/read_picture.h"
#include "io/files/paths.h"
#include "relievo/read.h"

namespace relievo {
namespace {

DrawnScene drawn(SceneInput input) {
  return {std::move(input.scene), std::move(input.drawing), std::move(input.files),
          std::move(input.warnings), input.proposed};
}

}  // namespace

Result<DrawnScene> read_drawing(const std::filesystem::path& path, const RunContext& context) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto input = load_scene(*file, true, context);
  if (!input) return input.error();
  return drawn(std::move(*input));
}

Result<DrawnScene> understand_picture(const std::filesystem::path& path,
                                      const RunContext& context) {
  const auto file = read_input(path.string());
  if (!file) return file.error();
  auto input = read_picture(*file, true, context);
  if (!input) return in_file(input.error(), file->name);
  input->files = {path};
  return drawn(std::move(*input));
}

}  // namespace relievo
