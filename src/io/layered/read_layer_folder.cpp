#include "io/layered/read_layer_folder.h"

#include <string>
#include <utility>

#include "io/files/paths.h"
#include "io/layered/layer_files.h"
#include "kernel/base/text_rules.h"
#include "relievo/files.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

bool is_png_name(const fs::path& path) { return lower_case(path.extension().string()) == ".png"; }

Result<std::vector<LayerFile>> layers_by_name(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (is_png_name(entry.path())) names.push_back(entry.path().filename().string());
  if (code) return Error{ErrorCode::file, "cannot be read: " + code.message(), folder.string()};
  if (names.empty())
    return Error{ErrorCode::bad_input,
                 "holds no layers: it needs PNG files, and may list them in layers.tsv",
                 folder.string()};
  auto layers = layers_of_names(std::move(names));
  return layers ? layers : in_file(layers.error(), folder.string());
}

Result<std::vector<LayerFile>> layers_in(const fs::path& folder, std::vector<fs::path>& files) {
  const fs::path table = folder / "layers.tsv";
  std::error_code code;
  if (!fs::exists(table, code)) return layers_by_name(folder);
  const auto bytes = read_file(table);
  if (!bytes) return bytes.error();
  auto layers = read_layer_table({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!layers) return in_file(layers.error(), table.string());
  files.push_back(table);
  return layers;
}

}  // namespace

Result<understanding::LayeredDrawing> read_layer_folder(const fs::path& folder,
                                                        std::vector<fs::path>& files,
                                                        const ImageLimits& limits) {
  auto layers = layers_in(folder, files);
  if (!layers) return layers.error();
  uint64_t room = max_packed_bytes;
  for (LayerFile& layer : *layers) {
    const fs::path path = folder / layer.file;
    if (!path_below(path, folder))
      return Error{ErrorCode::bad_input, "leads out of the folder", path.string()};
    auto bytes = read_file(path, room);
    if (!bytes) return bytes.error();
    room -= bytes->size();
    layer.file = path.string();
    layer.png = std::move(*bytes);
    files.push_back(path);
  }
  auto drawing = unpack_layers(*layers, {}, {}, limits);
  if (!drawing) return in_file(drawing.error(), folder.string());
  return drawing;
}

}  // namespace relievo
