#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "api/inputs.h"
#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/bytes.h"
#include "relievo/files.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::cli {

/// Returns all files that a build will write, including those that accompany others (.mtl with
/// .obj).
std::vector<std::filesystem::path> planned_outputs(const BuildArguments& build);

/// Checks that `paths` are different files in existing folders, and that none is one of `inputs`.
/// Empty paths are outputs that are not wanted. Errors: `usage`, `file`.
Status check_outputs(const std::vector<std::filesystem::path>& paths,
                     const std::vector<std::filesystem::path>& inputs);

/// Returns the file name of a level of detail: wolf.glb, wolf-lod1.glb, wolf-lod2.glb, ...
std::string level_name(const std::string& name, int level);

/// Makes a folder, and those above it. Errors: `file`.
Status make_folder(const std::filesystem::path& folder);

/// The files that a command makes.
struct Outputs {
  std::vector<OutputFile> files;
  Status status = Done{};  ///< the first error, after which no more files are made

  /// Adds the file `name` with the bytes that `make` returns, if it has a name.
  template <class Make>
  void add(const std::filesystem::path& name, Make make) {
    if (name.empty() || !status) return;
    Result<Bytes> bytes = make();
    if (bytes)
      files.push_back({name, std::move(*bytes)});
    else
      status = bytes.error();
  }
};

/// The drawing that a scene file refers to.
struct SceneDrawing {
  std::string file;  ///< its path; empty if it has no file of its own
  Bytes bytes;       ///< empty if there is no drawing
};

/// Returns the picture of a scene and its file: the one that the scene was read with, or a new one.
Result<SceneDrawing> drawing_of(const InputFile& file, const SceneInput& input);

/// Returns the file extension for the format of a picture, without the dot.
std::string picture_kind(ByteView bytes);

/// Adds the scene file and, if the drawing is not in its folder or below, a copy of the drawing
/// beside it. The copy is numbered if its name is taken. Errors: as write_scene.
void add_scene(Outputs& outputs, const std::string& output, Scene scene,
               const SceneDrawing& drawing);

/// Writes all files, or none if the work has been stopped. Errors: that of `outputs`; as
/// write_files; `interrupted`.
Status save(const Outputs& outputs, const std::vector<std::filesystem::path>& inputs,
            Interruption& interruption);

}  // namespace relievo::cli
