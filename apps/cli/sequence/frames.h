#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/inputs.h"
#include "apps/cli/arguments.h"
#include "apps/cli/sequence/sprite_sheet.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// Longest side of maps by default, px.
constexpr int usual_map_side = 1024;

/// A frame of a sequence.
struct Frame {
  std::string name;    ///< of its outputs: that of its file or sprite
  bool flat = false;   ///< its parts have no names of their own
  bool empty = false;  ///< nothing is drawn
  ImageSize canvas{};  ///< of a picture of an animation, px
  /// Loads the scene; see load_scene. Precondition: not empty.
  std::function<Result<SceneInput>(const RunContext&)> load;
};

struct Frames {
  std::vector<Frame> frames;
  std::optional<SpriteSheet> sheet;          ///< if they are its sprites
  ImageSize sheet_size;                      ///< of the picture
  int longest = 0;                           ///< side of the maps of an animation by default, px
  std::vector<std::filesystem::path> files;  ///< inputs, never overwritten
};

/// Returns the frames: files, the pictures of one animation, or the sprites of a sheet with a list
/// (.json) or a grid. Errors:
/// `usage` if two frames have the same name, `bad_input` for invalid sheets and sprites outside the
/// picture, `file`.
Result<Frames> collect_frames(const SequenceArguments& sequence);

}  // namespace relievo::cli
