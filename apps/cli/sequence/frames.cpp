#include "apps/cli/sequence/frames.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "api/inputs.h"
#include "api/read_picture.h"
#include "io/files/paths.h"
#include "io/image/decode_image.h"
#include "io/layered/layer_files.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// Checks whether a file lists the sprites of a sheet. Scene files have no "frames".
bool lists_sprites(const InputFile& file) {
  return !file.folder && sniff(file.bytes) == InputKind::json &&
         text_of(file.bytes).find("\"frames\"") != std::string_view::npos;
}

bool is_blank(const Image8& sheet, const Sprite& sprite) {
  bool blank = true;
  for_each_pixel(sprite, [&](int, int, int x, int y) { blank &= sheet.at(x, y, 3) == 0; });
  return blank;
}

Frame sprite_frame(const std::shared_ptr<const Image8>& sheet, const Sprite& sprite,
                   const std::string& file) {
  Frame frame;
  frame.name = sprite.name;
  frame.flat = true;
  frame.empty = is_blank(*sheet, sprite);
  frame.load = [sheet, sprite, file](const RunContext& context) {
    const std::string name = file + ": " + sprite.name;
    auto input = understand_flat({cut_sprite(*sheet, sprite)}, name, true, context);
    return input ? std::move(input) : Result<SceneInput>(in_file(input.error(), name));
  };
  return frame;
}

/// Returns the frames of a sheet whose picture is `file`.
Result<Frames> frames_on(SpriteSheet sheet, const std::string& file, Image8 picture) {
  const ImageSize needed = extent(sheet);
  if (needed.width > picture.width || needed.height > picture.height)
    return Error{ErrorCode::bad_input,
                 "has " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                     " px, but its sprites reach to " + std::to_string(needed.width) + " x " +
                     std::to_string(needed.height),
                 file};
  Frames found;
  found.sheet_size = {picture.width, picture.height};
  const auto shared = std::make_shared<const Image8>(std::move(picture));
  for (const Sprite& sprite : sheet.sprites)
    found.frames.push_back(sprite_frame(shared, sprite, file));
  sheet.picture = fs::path(file).filename().string();
  found.sheet = std::move(sheet);
  found.files.emplace_back(file);
  return found;
}

Result<Image8> read_picture_file(const InputFile& file) {
  if (file.folder || sniff(file.bytes) != InputKind::image)
    return Error{ErrorCode::bad_input, "must be a picture: that of a sprite sheet", file.name};
  auto picture = decode_image(file.bytes);
  if (!picture) return in_file(picture.error(), file.name);
  return picture;
}

Result<Frames> frames_of_list(const InputFile& list) {
  auto sheet = read_sprite_sheet(text_of(list.bytes));
  if (!sheet) return in_file(sheet.error(), list.name);
  std::stable_sort(sheet->sprites.begin(), sheet->sprites.end(),
                   [](const Sprite& a, const Sprite& b) { return comes_before(a.name, b.name); });
  const fs::path folder = fs::path(list.name).parent_path();
  const auto inside = path_below(folder / sheet->picture, folder.empty() ? "." : folder);
  if (sheet->picture.empty() || !inside)
    return Error{ErrorCode::bad_input,
                 "must name the picture of the sheet, in the folder of this file",
                 list.name + ": meta.image"};
  const auto file = read_input((folder / sheet->picture).string());
  if (!file) return file.error();
  auto picture = read_picture_file(*file);
  if (!picture) return picture.error();
  auto found = frames_on(std::move(*sheet), file->name, std::move(*picture));
  if (found) found->files.emplace_back(list.name);
  return found;
}

Result<Frames> frames_of_grid(const InputFile& file, ImageSize cells) {
  auto picture = read_picture_file(file);
  if (!picture) return picture.error();
  if (picture->width % cells.width != 0 || picture->height % cells.height != 0)
    return Error{ErrorCode::bad_input,
                 std::to_string(picture->width) + " x " + std::to_string(picture->height) +
                     " px cannot be cut into " + std::to_string(cells.width) + " x " +
                     std::to_string(cells.height) + " equal sprites",
                 file.name};
  const ImageSize cell = {picture->width / cells.width, picture->height / cells.height};
  return frames_on(grid_sheet(cell, cells.width, cells.width * cells.height), file.name,
                   std::move(*picture));
}

Frame file_frame(const InputFile& file, bool connect) {
  Frame frame;
  frame.name = fs::path(file.name).stem().string();
  frame.flat = !file.folder && sniff(file.bytes) == InputKind::image;
  frame.load = [name = file.name, connect](const RunContext& context) -> Result<SceneInput> {
    const auto again = read_input(name);
    if (!again) return again.error();
    return load_scene(*again, connect, context);
  };
  return frame;
}

}  // namespace

Result<Frames> collect_frames(const SequenceArguments& sequence) {
  Frames found;
  std::set<std::string> names;
  for (const std::string& name : sequence.inputs) {
    const auto file = read_input(name);
    if (!file) return file.error();
    const bool list = lists_sprites(*file);
    if ((list || sequence.grid) && sequence.inputs.size() > 1)
      return Error{ErrorCode::usage,
                   "must be the only input, since a sprite sheet is a whole sequence", name};
    if (list) return frames_of_list(*file);
    if (sequence.grid) return frames_of_grid(*file, *sequence.grid);
    found.frames.push_back(file_frame(*file, sequence.common.connect));
    found.files.emplace_back(name);
    if (!names.insert(found.frames.back().name).second)
      return Error{ErrorCode::usage, "has the same name as another frame", name};
  }
  return found;
}

}  // namespace relievo::cli
