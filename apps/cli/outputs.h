#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "apps/cli/interruption.h"
#include "relievo/files.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Returns all files that a build will write, including those that accompany others (.mtl with
/// .obj).
std::vector<std::filesystem::path> planned_outputs(const BuildArguments& build);

/// Checks that `paths` are different files in existing folders, and that none is one of `inputs`.
/// Errors: `usage`, `file`.
Status check_outputs(const std::vector<std::filesystem::path>& paths,
                     const std::vector<std::filesystem::path>& inputs);

/// Returns the file name of a level of detail: wolf.glb, wolf-lod1.glb, wolf-lod2.glb, ...
std::string level_name(const std::string& name, int level);

/// Makes a folder, and those above it. Errors: `file`.
Status make_folder(const std::filesystem::path& folder);

/// Adds a file with the given content. Errors: those of `content`.
Status add_file(std::vector<OutputFile>& files, const std::filesystem::path& path,
                Result<Bytes> content);

/// Writes all files, or none if the work has been stopped. Errors: as write_files, `interrupted`.
Status save(const std::vector<OutputFile>& files, const std::vector<std::filesystem::path>& inputs,
            Interruption& interruption);

}  // namespace relievo::cli
