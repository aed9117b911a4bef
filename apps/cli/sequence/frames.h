#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/sequence/sprite_sheet.h"
#include "face/inputs.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// One picture of a sequence.
struct Frame {
  std::string name;   ///< of its outputs: that of its file, or that of a sprite
  bool flat = false;  ///< what its parts are called says nothing
  bool empty = false;
  /// Reads and understands it; as load_scene. Precondition: not empty.
  std::function<Result<SceneInput>(const RunContext&)> load;
};

struct Frames {
  std::vector<Frame> frames;
  std::optional<SpriteSheet> sheet;          ///< where they are the sprites of one
  ImageSize sheet_size;                      ///< of its picture
  std::vector<std::filesystem::path> files;  ///< that were read for them
};

/// The frames that are asked for: files, or the sprites of one sheet, whose list (.json) or grid is
/// given. Errors: `usage` where two have one name, `bad_input` for sheets that are not sound or
/// sprites that lie beside the picture, `file`.
Result<Frames> collect_frames(const SequenceArguments& sequence);

}  // namespace relievo::cli
