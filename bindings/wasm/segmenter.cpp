#include "bindings/wasm/segmenter.h"

#include <utility>
#include <vector>

#include "bindings/wasm/js_values.h"
#include "io/files/paths.h"
#include "io/image/orientation.h"
#include "io/image/png.h"
#include "io/project/project_json.h"
#include "io/scene/scene_json.h"
#include "understanding/areas/find_basins.h"
#include "understanding/labels/label_basins.h"
#include "understanding/scene/keep_edits.h"
#include "understanding/scene/understand_drawing.h"

namespace relievo::wasm {
namespace {

using emscripten::val;

const Error nothing_open = {ErrorCode::usage, "no drawing has been opened yet", ""};

Result<Project> read_project(const std::string& text) {
  auto project = read_project_json(text);
  if (!project) return in_file(project.error(), "project.json");
  if (!project->segmentation)
    return Error{ErrorCode::bad_input, "has no segmentation", "project.json"};
  return project;
}

/// Reads the text of a scene; an empty text is a scene without parts.
Result<Scene> read_edited(const std::string& text) {
  if (text.empty()) return Scene{};
  auto scene = read_scene(text);
  return scene ? std::move(scene) : in_file(scene.error(), "scene.json");
}

val parts_of(const understanding::Segmentation& segmentation) {
  val list = val::array();
  for (size_t k = 0; k < segmentation.parts.size(); ++k) {
    val part = val::object();
    part.set("label", segmentation.parts[k].label);
    part.set("id", segmentation.parts[k].id);
    list.set(k, part);
  }
  return list;
}

val bridges_of(const understanding::Segmentation& segmentation) {
  val list = val::array();
  for (size_t k = 0; k < segmentation.bridges.size(); ++k) {
    const understanding::Bridge& found = segmentation.bridges[k];
    val bridge = val::object();
    bridge.set("points", to_js(flatten(found.points)));
    bridge.set("left", found.label_a);
    bridge.set("right", found.label_b);
    list.set(k, bridge);
  }
  return list;
}

}  // namespace

/// A project with the segmentation that its strokes make, which is not renumbered yet.
struct Segmenter::Labelled {
  Project project;
  understanding::Segmentation found;
};

val Segmenter::open_png(const val& file, const val& network) {
  const Bytes png = to_bytes(file);
  auto rgba = decode_png(png);
  return rgba ? open(upright(std::move(*rgba), png_orientation(png)), network)
              : failure(rgba.error());
}

val Segmenter::open_pixels(const val& rgba, int width, int height, const val& network) {
  return open(to_image(rgba, width, height), network);
}

val Segmenter::open(Image8 rgba, const val& network) {
  if (network_.empty()) {
    auto decoded = understanding::decode_network(to_bytes(network));
    if (!decoded) return failure(decoded.error());
    network_ = std::move(*decoded);
  }
  Drawing drawing{std::move(rgba)};
  auto basins = understanding::find_basins(drawing, network_);
  if (!basins) return failure(basins.error());
  drawing_ = std::move(drawing);
  basins_ = std::move(*basins);
  return val::object();
}

Status Segmenter::remember(const val& last) {
  Bytes file = to_bytes(last);
  if (file == last_file_) return Done{};
  Image16 labels;
  if (!file.empty()) {
    auto decoded = decode_png_values(file);
    if (!decoded) return in_file(decoded.error(), "labels.png");
    labels = std::move(*decoded);
  }
  last_labels_ = std::move(labels);
  last_file_ = std::move(file);
  return Done{};
}

Result<Segmenter::Labelled> Segmenter::read(const std::string& project, const val& last) {
  if (basins_.basins.empty()) return nothing_open;
  auto known = read_project(project);
  if (!known) return known.error();
  if (Status status = remember(last); !status) return status.error();
  understanding::SegmentationRecord& record = *known->segmentation;
  record.labels = last_labels_;
  auto found = understanding::label_basins(basins_, record.scribbles);
  if (!found) return found.error();
  return Labelled{std::move(*known), std::move(*found)};
}

val Segmenter::label(const std::string& project, const val& last) {
  auto labelled = read(project, last);
  if (!labelled) return failure(labelled.error());
  understanding::relabel(labelled->found, *labelled->project.segmentation);
  val result = val::object();
  result.set("labels", to_js(labelled->found.labels.pixels));
  result.set("parts", parts_of(labelled->found));
  result.set("bridges", bridges_of(labelled->found));
  result.set("notes", to_js(labelled->found.notes));
  return result;
}

val Segmenter::propose(const std::string& text, const val& last, const std::string& edited_text) {
  auto labelled = read(text, last);
  if (!labelled) return failure(labelled.error());
  const auto edited = read_edited(edited_text);
  if (!edited) return failure(edited.error());
  understanding::SegmentationRecord& record = *labelled->project.segmentation;
  auto understood = understanding::understand_drawing(drawing_.rgba, std::move(labelled->found),
                                                      std::move(record), *edited);
  if (!understood) return failure(understood.error());
  record = std::move(understood->record);
  const auto labels = encode_png(record.labels);
  if (!labels) return failure(labels.error());
  std::string scene;
  if (!understood->scene.parts.empty()) {
    auto written = write_scene(understood->scene);
    if (!written) return failure(written.error());
    scene = std::move(*written);
  }
  val result = val::object();
  result.set("project", write_project_json(labelled->project));
  result.set("scene", scene);
  result.set("labels", to_js(*labels));
  result.set("warnings", to_js(understood->warnings));
  return result;
}

val check_segmentation(const std::string& project, const val& labels) {
  const auto read = read_project(project);
  if (!read) return failure(read.error());
  const auto decoded = decode_png_values(to_bytes(labels));
  if (!decoded) return failure(in_file(decoded.error(), "labels.png"));
  return val::object();
}

}  // namespace relievo::wasm
