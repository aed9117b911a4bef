#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "io/mesh/encode_models.h"
#include "relievo/files.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo::cli {

/// All files that a build will write, those that go with others included (.mtl beside .obj).
std::vector<std::filesystem::path> planned_outputs(const BuildArguments& build);

/// Whether `paths` can be written: different files in folders that are there, none of them one
/// of `inputs`. Errors: `usage`, `file`.
Status check_outputs(const std::vector<std::filesystem::path>& paths,
                     const std::vector<std::filesystem::path>& inputs);

/// wolf.glb, and of its coarser levels wolf-lod1.glb, wolf-lod2.glb, ...
std::string level_name(const std::string& name, int level);

struct FileOptions {
  double mm = 100;    ///< longest side of the model
  int filaments = 4;  ///< of .3mf
  Slicer slicer = Slicer::prusa;
  bool standing = false;  ///< whether it stands on the bed of a printer, not lies
};

/// The files of a model in the format that the name's extension says. Precondition: a known one.
Result<std::vector<OutputFile>> encode_model(const Model& model, const Drawing& drawing,
                                             const std::string& name, const FileOptions& file);

/// Writes all files or none, unless the work was stopped before. Errors: as write_files, and
/// `interrupted`.
Status save(const std::vector<OutputFile>& files, const std::vector<std::filesystem::path>& inputs,
            Interruption& interruption);

}  // namespace relievo::cli
