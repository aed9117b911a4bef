#include "bindings/wasm/import_layers.h"

#include <string>
#include <utility>
#include <vector>

#include "bindings/wasm/js_values.h"
#include "io/files/in_file.h"
#include "io/image/png_encode.h"
#include "io/layered/layer_names.h"
#include "io/layered/layer_table.h"
#include "io/layered/packed_layers.h"
#include "io/layered/read_ora.h"
#include "io/scene/write_scene.h"
#include "relief/pipeline/connect_scene.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

/// More pixels are too much for the memory of a page.
const ImageLimits page_limits = {4096 * 4096, 32'767};
const char* const table_name = "layers.tsv";

std::vector<ArchiveEntry> to_entries(const val& files) {
  std::vector<ArchiveEntry> entries;
  const int count = files["length"].as<int>();
  for (int i = 0; i < count; ++i)
    entries.push_back({files[i]["name"].as<std::string>(), to_bytes(files[i]["bytes"])});
  return entries;
}

Result<std::vector<LayerRow>> rows_of(const std::vector<ArchiveEntry>& entries) {
  if (const ArchiveEntry* table = find_entry(entries, table_name)) {
    auto rows =
        read_layer_table({reinterpret_cast<const char*>(table->bytes.data()), table->bytes.size()});
    return rows ? rows : in_file(rows.error(), table_name);
  }
  std::vector<std::string> names;
  for (const ArchiveEntry& entry : entries) names.push_back(entry.name);
  return rows_of_names(std::move(names));
}

Result<OraDrawing> read_pictures(const std::vector<ArchiveEntry>& entries) {
  auto rows = rows_of(entries);
  if (!rows) return rows.error();
  std::vector<PackedLayer> layers;
  for (LayerRow& row : *rows) {
    const ArchiveEntry* picture = find_entry(entries, row.file);
    if (picture == nullptr)
      return Error{ErrorCode::file, "is in the table of layers, but was not opened with it",
                   row.file};
    layers.push_back({std::move(row.layer), row.file, picture->bytes});
  }
  auto content = unpack_layers(layers, {}, page_limits);
  if (!content) return content.error();
  return OraDrawing{std::move(*content), {}};
}

}  // namespace

val import_layers(const val& files) {
  const std::vector<ArchiveEntry> entries = to_entries(files);
  const auto read = is_ora(entries) ? read_ora(entries, page_limits) : read_pictures(entries);
  if (!read) return failure(read.error());
  const LayeredDrawing& content = read->content;
  const auto scene =
      write_scene(connect_scene(content.scene, content.proposed, content.colors).scene);
  if (!scene) return failure(scene.error());
  const auto picture = encode_png(content.drawing.rgba);
  if (!picture) return failure(picture.error());
  val result = val::object();
  result.set("scene", *scene);
  result.set("proposed", content.proposed);
  result.set("warnings", to_js(read->warnings));
  result.set("drawing", to_js(*picture));
  return result;
}

}  // namespace relievo::wasm
