#include "apps/cli/outputs.h"

#include <set>

#include "io/mesh/obj_encode.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& path, const std::string& extension) {
  const std::string name = obj_file_name(path.stem().string()) + extension;
  return path.parent_path() / name;
}

/// Returns a path that is the same for all spellings of a file's path. The file need not exist.
fs::path identity(const fs::path& path) {
  std::error_code code;
  // A relative path to a file that does not exist yet would stay relative.
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, code), code);
  return code ? fs::absolute(path, code).lexically_normal() : canonical;
}

}  // namespace

std::vector<fs::path> planned_outputs(const BuildArguments& build) {
  std::vector<fs::path> paths;
  for (const std::string& model : build.models)
    for (int level = 0; level < build.levels; ++level) {
      const fs::path path = level_name(model, level);
      paths.push_back(path);
      if (path.extension() != ".obj") continue;
      paths.push_back(beside(path, ".mtl"));
      paths.push_back(beside(path, ".png"));
    }
  for (const std::string* name :
       {&build.normal_map, &build.depth_map, &build.part_map, &build.occlusion_map,
        &build.carve_map, &build.preview, &build.overlay, &build.convergence, &build.report})
    if (!name->empty()) paths.emplace_back(*name);
  return paths;
}

std::string level_name(const std::string& name, int level) {
  if (level == 0) return name;
  const fs::path path = name;
  const std::string stem = path.stem().string() + "-lod" + std::to_string(level);
  return (path.parent_path() / (stem + path.extension().string())).string();
}

Status check_outputs(const std::vector<fs::path>& paths, const std::vector<fs::path>& inputs) {
  std::set<fs::path> taken;
  for (const fs::path& path : paths) {
    std::error_code code;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    if (!fs::is_directory(folder, code))
      return Error{ErrorCode::file, "cannot be written: its folder does not exist", path.string()};
    if (fs::is_directory(path, code))
      return Error{ErrorCode::file, "cannot be written: it is a folder", path.string()};
    if (!taken.insert(identity(path)).second)
      return Error{ErrorCode::usage, "is the name of two outputs; choose another name for one",
                   path.string()};
    for (const fs::path& input : inputs)
      if (fs::equivalent(path, input, code))
        return Error{ErrorCode::usage, "is an input and is never overwritten", path.string()};
  }
  return Done{};
}

Status make_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return Error{ErrorCode::file, "cannot be created: " + code.message(), folder.string()};
  return Done{};
}

Status save(const Outputs& outputs, const std::vector<fs::path>& inputs,
            Interruption& interruption) {
  if (!outputs.status) return outputs.status;
  const auto writing = interruption.hold_off();
  if (*interruption.flag()) return interrupted_error();
  Status status = write_files(outputs.files, inputs);
  if (status) interruption.finish();
  return status;
}

}  // namespace relievo::cli
