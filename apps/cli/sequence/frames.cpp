#include "apps/cli/sequence/frames.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "api/inputs.h"
#include "api/read_picture.h"
#include "io/files/paths.h"
#include "io/image/animation.h"
#include "io/image/decode_image.h"
#include "io/layered/layer_files.h"
#include "relievo/files.h"
#include "relievo/pixel_art.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

bool is_blank(const Image8& sheet, const Sprite& sprite) {
  bool blank = true;
  for_each_pixel(sprite, [&](int, int, int x, int y) { blank &= sheet.at(x, y, 3) == 0; });
  return blank;
}

/// Checks whether nothing is drawn: all pixels are transparent, or of one colour.
bool is_blank(const Image8& picture) {
  bool clear = true;
  bool even = true;
  for (size_t i = 0; i < picture.pixels.size(); i += 4) {
    clear &= picture.pixels[i + 3] == 0;
    even &= std::equal(picture.pixels.begin(), picture.pixels.begin() + 4, &picture.pixels[i]);
  }
  return clear || even;
}

Frame sprite_frame(const std::shared_ptr<const Image8>& sheet, const Sprite& sprite,
                   const std::string& file) {
  Frame frame;
  frame.name = sprite.name;
  frame.flat = true;
  frame.empty = is_blank(*sheet, sprite);
  frame.load = [sheet, sprite, file](const RunContext& context) {
    const std::string name = file + ": " + sprite.name;
    auto input = understand_fitted(fitted(cut_sprite(*sheet, sprite)), name, true, context);
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

/// Returns the picture of a sheet: the file that its list names, else one of that name beside the
/// list, else the one of the list's own name. Programs write paths of the machine that they ran on.
Result<InputFile> picture_of_list(const InputFile& list, const std::string& named) {
  const fs::path folder = fs::path(list.name).parent_path();
  const std::string last = named.substr(named.find_last_of("/\\") + 1);
  std::vector<fs::path> candidates;
  if (!named.empty()) candidates = {folder / named, folder / last};
  candidates.push_back(folder / fs::path(list.name).stem().concat(".png"));
  for (const fs::path& candidate : candidates) {
    std::error_code code;
    if (path_below(candidate, folder.empty() ? "." : folder) &&
        fs::is_regular_file(candidate, code))
      return read_input(candidate.string());
  }
  return Error{ErrorCode::bad_input,
               "must name the picture of the sheet, in the folder of this file; there is no " +
                   (last.empty() ? "" : last + ", and no ") + candidates.back().filename().string(),
               list.name + ": meta.image"};
}

Result<Frames> frames_of_list(const InputFile& list) {
  auto sheet = read_sprite_sheet(text_of(list.bytes));
  if (!sheet) return in_file(sheet.error(), list.name);
  std::stable_sort(sheet->sprites.begin(), sheet->sprites.end(),
                   [](const Sprite& a, const Sprite& b) { return comes_before(a.name, b.name); });
  const auto file = picture_of_list(list, sheet->picture);
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

/// Returns the frames of an animation, named after its file and numbered from 0.
Result<Frames> frames_of_animation(const InputFile& file, const SequenceArguments& sequence) {
  auto pictures = decode_frames(file.bytes);
  if (!pictures) return in_file(pictures.error(), file.name);
  Frames found;
  found.files.emplace_back(file.name);
  const size_t digits = std::to_string(pictures->size() - 1).size();
  for (Image8& picture : *pictures) {
    const std::string number = std::to_string(found.frames.size());
    Frame frame;
    frame.name = fs::path(file.name).stem().string() + "-" +
                 std::string(digits - number.size(), '0') + number;
    frame.flat = true;
    frame.empty = is_blank(picture);
    frame.canvas = {picture.width, picture.height};
    if (!frame.empty && found.longest == 0)
      found.longest =
          map_side({picture, own_pixels(picture, sequence.common.pixel_art)}, usual_map_side);
    const auto shared = std::make_shared<const Image8>(std::move(picture));
    frame.load = [shared, connect = sequence.common.connect,
                  name = file.name + ": " + frame.name](const RunContext& context) {
      auto input = understand_fitted(fitted(*shared), name, connect, context);
      return input ? std::move(input) : Result<SceneInput>(in_file(input.error(), name));
    };
    found.frames.push_back(std::move(frame));
  }
  if (found.longest == 0) found.longest = usual_map_side;
  return found;
}

/// Returns the frames of a file that is a whole sequence; none where it is one frame.
Result<Frames> whole_sequence(const InputFile& file, const SequenceArguments& sequence) {
  if (!file.folder && sniff(file.bytes) == InputKind::sprites) return frames_of_list(file);
  if (sequence.grid) return frames_of_grid(file, *sequence.grid);
  if (!file.folder && frame_count(file.bytes) > 1) return frames_of_animation(file, sequence);
  return Frames{};
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
    auto whole = whole_sequence(*file, sequence);
    if (!whole) return whole;
    if (!whole->frames.empty() && sequence.inputs.size() == 1) return whole;
    if (!whole->frames.empty())
      return Error{ErrorCode::usage,
                   "must be the only input, since it is a whole sequence of frames", name};
    found.frames.push_back(file_frame(*file, sequence.common.connect));
    found.files.emplace_back(name);
    if (!names.insert(found.frames.back().name).second)
      return Error{ErrorCode::usage, "has the same name as another frame", name};
  }
  return found;
}

}  // namespace relievo::cli
