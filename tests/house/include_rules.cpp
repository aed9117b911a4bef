#include "house/include_rules.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace relievo::house {
namespace {

using Names = std::set<std::string>;

/// The kernel: which other folders of it a folder may use.
const std::map<std::string, Names> kernel_rules = {
    {"base", {}},
    {"geometry", {"base"}},
    {"graph", {"base"}},
    {"image", {"base", "geometry", "solvers"}},
    {"meshing", {"base", "geometry"}},
    {"operators", {"base", "geometry"}},
    {"solvers", {"base"}},
};

/// The chain of stages; data flows from left to right.
const std::vector<std::string> stages = {
    "drawing",        "scene", "completion", "stacking", "join_proposals", "corrections", "layers",
    "discretisation", "cues",  "inflation",  "ordering", "nonlinear",      "hiding",      "model"};

/// The non-linear stage unites these two and is made of their parts.
const Names nonlinear_folders = {"inflation", "ordering"};

/// What a stage hands on: its struct and views of it. Everything else in its folder is its own.
const Names stage_structs = {
    "completion/completion.h",
    "completion/part_regions.h",
    "corrections/corrections.h",
    "cues/cue_fields.h",
    "drawing/basins.h",
    "drawing/scribbles.h",
    "drawing/segmentation.h",
    "hiding/hidden_sheets.h",
    "discretisation/discretisation.h",
    "inflation/inflation.h",
    "join_proposals/join_proposals.h",
    "nonlinear/nonlinear_solution.h",
    "layers/layered_mesh.h",
    "model/visible_sheet.h",
    "ordering/ordering.h",
    "stacking/stacking.h",
};

/// Besides, files and pictures may use what the last stage derives from a model.
const Names model_views = {"model/dress_hidden.h",   "model/ink_rims.h",
                           "model/paint_layers.h",   "model/fill_triangle.h",
                           "model/hidden_patches.h", "model/model_texture.h",
                           "model/relief_maps.h"};

/// The verbs of the stages, for the pipeline alone.
const Names stage_verbs = {"completion/clip_to_order.h",
                           "completion/complete_parts.h",
                           "drawing/find_basins.h",
                           "drawing/segment_drawing.h",
                           "hiding/hide_sheets.h",
                           "inflation/inflate.h",
                           "join_proposals/propose_layer_joins.h",
                           "join_proposals/propose_joins.h",
                           "join_proposals/propose_leans.h",
                           "join_proposals/part_profile.h",
                           "nonlinear/solve_nonlinear.h",
                           "layers/layer_parts.h",
                           "model/assemble_model.h",
                           "model/relief_maps.h",
                           "ordering/order_depth.h",
                           "stacking/stack_parts.h"};

struct Place {
  /// relievo, kernel, relief, io, lod, render, solid, face, rivals, apps, tests, benchmarks
  std::string top;
  std::string folder;  ///< below it
  std::string rest;    ///< folder/file
};

Place place(const std::string& path) {
  const size_t first = path.find('/');
  Place place{path.substr(0, first), "", ""};
  if (first == std::string::npos) return place;
  place.rest = path.substr(first + 1);
  place.folder = place.rest.substr(0, place.rest.find('/'));
  return place;
}

size_t stage_number(const std::string& folder) {
  return static_cast<size_t>(std::find(stages.begin(), stages.end(), folder) - stages.begin());
}

std::string check_kernel(const Place& from, const Place& to) {
  const auto rule = kernel_rules.find(from.folder);
  if (rule == kernel_rules.end()) return "kernel/" + from.folder + " has no rule";
  if (to.top != "kernel") return "the kernel knows only itself";
  if (to.folder == from.folder || rule->second.count(to.folder) > 0) return "";
  return "kernel/" + from.folder + " must not use kernel/" + to.folder;
}

std::string check_relief(const Place& from, const Place& to) {
  if (to.top == "kernel" || (to.top == "relief" && to.folder == from.folder)) return "";
  if (to.top != "relief") return "the stages know only the kernel and each other";
  if (from.folder == "pipeline")
    return stage_structs.count(to.rest) + stage_verbs.count(to.rest) > 0
               ? ""
               : "the pipeline uses the stages' structs and verbs only";
  const size_t mine = stage_number(from.folder);
  const size_t other = stage_number(to.folder);
  if (mine == stages.size()) return "relief/" + from.folder + " is no stage";
  if (other >= mine) return "a stage must not use a later one";
  if (from.folder == "nonlinear" && nonlinear_folders.count(to.folder) > 0) return "";
  return stage_structs.count(to.rest) > 0 ? "" : "a stage uses only the structs of earlier ones";
}

std::string check_io(const Place& to) {
  if (to.top == "kernel" || to.top == "io") return "";
  if (to.top == "relief" && stage_structs.count(to.rest) + model_views.count(to.rest) > 0)
    return "";
  return "io uses the kernel, the stages' structs and itself only";
}

std::string check_render(const Place& to) {
  if (to.top == "kernel" || to.top == "render") return "";
  if (to.top == "relief" && (to.folder == "model" || to.folder == "drawing") &&
      stage_structs.count(to.rest) + model_views.count(to.rest) > 0)
    return "";
  return "render uses the kernel, models, drawings and itself only";
}

std::string check_lod(const Place& to) {
  return to.top == "lod" ? "" : "lod uses public models and itself only";
}

std::string check_solid(const Place& to) {
  if (to.top == "kernel" || to.top == "solid") return "";
  if (to.top == "relief" && (to.folder == "model" || to.folder == "drawing") &&
      (stage_structs.count(to.rest) > 0 || to.rest == "model/ink_rims.h"))
    return "";
  return "solid uses the kernel, models, drawings and itself only";
}

/// For programs and bindings alike.
std::string check_apps(const Place& from, const Place& to) {
  for (const char* top : {"kernel", "io", "lod", "render", "solid", "face"})
    if (to.top == top || to.top == from.top) return "";
  if (to.top == "rivals" && from.top == "apps") return "";
  if (to.top != "relief") return from.top + " use the libraries only";
  if (to.folder == "pipeline" ||
      stage_structs.count(to.rest) + stage_verbs.count(to.rest) + model_views.count(to.rest) > 0)
    return "";
  return from.top + " use the pipeline and the stages' structs and verbs, not their insides";
}

/// Other methods, to compare with: made of the same stages, part of no library.
std::string check_rivals(const Place& from, const Place& to) {
  if (to.top == "io" || to.top == "solid" || to.top == "face")
    return "rivals use the kernel, the stages, the renderer and themselves only";
  return check_apps(from, to);
}

bool contains_word(const std::string& text, const std::string& word) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_letter(text[at - 1]);
    const size_t end = at + word.size();
    if (begins && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

}  // namespace

std::string include_violation(const std::string& from, const std::string& to) {
  const Place source = place(from);
  const Place target = place(to);
  if (source.top == "relievo")
    return target.top == "relievo" ? "" : "public headers include public headers only";
  if (target.top == "relievo") return "";
  if (source.top == "bindings" && source.folder == "python")
    return target.top == "bindings" ? "" : "the Python module uses public headers only";
  if (source.top == "kernel") return check_kernel(source, target);
  if (source.top == "relief") return check_relief(source, target);
  if (source.top == "io") return check_io(target);
  if (source.top == "render") return check_render(target);
  if (source.top == "solid") return check_solid(target);
  if (source.top == "lod") return check_lod(target);
  if (source.top == "rivals") return check_rivals(source, target);
  if (source.top == "apps" || source.top == "bindings" || source.top == "face")
    return check_apps(source, target);
  if (target.top == "apps" || target.top == "bindings") return "nobody includes " + target.top;
  return "";
}

std::string text_violations(const std::string& path, const std::string& text) {
  std::ostringstream found;
  const Place source = place(path);
  if (std::count(text.begin(), text.end(), '\n') > 400) found << "longer than 400 lines\n";
  for (const std::string& word : {std::string("TO") + "DO", std::string("FIX") + "ME"})
    if (contains_word(text, word)) found << "says " << word << "\n";
  const bool is_header = path.size() > 2 && path.substr(path.size() - 2) == ".h";
  if (is_header && text.rfind("#pragma once\n", 0) != 0)
    found << "does not begin with #pragma once\n";
  if (is_header && contains_word(text, "using namespace"))
    found << "opens a namespace for everybody\n";
  if (source.top == "tests") return found.str();
  if (text.find("_distribution<") != std::string::npos)
    found << "draws from a distribution that differs between libraries\n";
  if (source.top != "kernel" && source.top != "relief") return found.str();
  for (const char* header : {"<iostream>", "<cstdio>", "<fstream>"})
    if (text.find(std::string("#include ") + header) != std::string::npos)
      found << "includes " << header << ": the core neither prints nor opens files\n";
  for (const char* header : {"<format>", "<ranges>", "<source_location>"})
    if (text.find(std::string("#include ") + header) != std::string::npos)
      found << "includes " << header << ", which the browser's toolchain lacks\n";
  for (const char* name : {"bit_cast", "jthread", "shared_ptr"})
    if (contains_word(text, name)) found << "uses " << name << "\n";
  return found.str();
}

}  // namespace relievo::house
