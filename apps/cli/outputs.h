#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/files.h"
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

/// Writes all files or none, unless the work was stopped before. Errors: as write_files, and
/// `interrupted`.
Status save(const std::vector<OutputFile>& files, const std::vector<std::filesystem::path>& inputs,
            Interruption& interruption);

}  // namespace relievo::cli
