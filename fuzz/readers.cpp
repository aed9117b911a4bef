#include "fuzz/readers.h"

#include <cstdlib>

#include "io/archive/zip_archive.h"
#include "io/image/decode_image.h"
#include "io/layered/layer_files.h"
#include "io/layered/read_ora.h"
#include "io/mesh/glb_decode.h"
#include "io/project/project_file.h"
#include "io/psd/read_psd.h"
#include "io/scene/scene_json.h"
#include "io/scribbles/scribble_image.h"
#include "io/scribbles/scribbles_json.h"
#include "io/svg/read_svg.h"
#include "understanding/marks/make_parts.h"

namespace relievo::fuzz {
namespace {

constexpr ImageLimits small_pictures = {1 << 18, 1 << 12, 1 << 20};

std::string_view text_of(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What is refused has a reason, and no reader finds a defect of ours.
template <class T>
bool is_read(const Result<T>& result) {
  if (!result && (result.error().message.empty() || result.error().code == ErrorCode::internal))
    std::abort();
  return result.ok();
}

/// Makes parts of a drawing that is read, of few marks.
void make_parts_of(Result<understanding::LayeredDrawing> drawing) {
  if (!is_read(drawing) || drawing->flat) return;
  is_read(understanding::make_parts(*drawing, 100));
}

/// A scene that is passed on is valid.
void expect_valid(const Scene& scene) {
  if (!validate(scene)) std::abort();
}

void svg(ByteView bytes) {
  SvgOptions options;
  options.max_points = 20000;
  options.max_elements = 2000;
  options.max_total_tangle = 1e5;
  make_parts_of(read_svg(text_of(bytes), options));
}

void scene(ByteView bytes) {
  const auto read = read_scene(text_of(bytes));
  if (is_read(read)) expect_valid(*read);
}

void archive(ByteView bytes) {
  const auto project = decode_project(bytes);
  is_read(project);
  ArchiveLimits limits;
  limits.max_bytes = 1 << 20;
  const auto entries = unpack_archive(bytes, limits);
  if (is_read(entries)) make_parts_of(read_ora(*entries, small_pictures));
}

void picture(ByteView bytes) { is_read(decode_image(bytes, small_pictures)); }

void layers(ByteView bytes) { is_read(read_layer_table(text_of(bytes))); }

void psd(ByteView bytes) { make_parts_of(read_psd(bytes, small_pictures)); }

void glb(ByteView bytes) {
  GlbLimits limits;
  limits.image = small_pictures;
  is_read(decode_glb(bytes, limits));
}

void scribbles(ByteView bytes) {
  is_read(read_scribbles(text_of(bytes)));
  const auto image = decode_image(bytes, small_pictures);
  if (is_read(image) && image->channels == 4) is_read(scribbles_from_image(*image, 64, 64));
}

}  // namespace

Reader reader_of(std::string_view name) {
  if (name == "svg") return svg;
  if (name == "scene") return scene;
  if (name == "archive") return archive;
  if (name == "picture") return picture;
  if (name == "layers") return layers;
  if (name == "psd") return psd;
  if (name == "glb") return glb;
  if (name == "scribbles") return scribbles;
  return nullptr;
}

}  // namespace relievo::fuzz
