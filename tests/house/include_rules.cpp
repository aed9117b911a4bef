#include "house/include_rules.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace relievo::house {
namespace {

using NameSet = std::set<std::string>;

/// The kernel: which other rooms of it a room may use.
const std::map<std::string, NameSet> kernel_rules = {
    {"base", {}},
    {"cholesky", {"base"}},
    {"geometry", {"base"}},
    {"graph", {"base"}},
    {"image", {"base", "cholesky", "geometry"}},
    {"meshing", {"base", "geometry"}},
    {"operators", {"base", "geometry"}},
    {"solvers", {"base", "cholesky"}},
};

/// The rooms of both wings. Data flows from left to right: a room uses itself and earlier ones.
const std::map<std::string, std::vector<std::string>> wings = {
    {"understanding",
     {"perception", "lines", "paper", "areas", "labels", "marks", "completion", "stacking", "joins",
      "scene"}},
    {"relief",
     {"layers", "discretisation", "cues", "inflation", "ordering", "nonlinear", "hiding", "session",
      "surface", "finish", "maps"}},
};

/// What a stage of the relief hands on. Everything else in its room is its own.
const NameSet stage_structs = {
    "cues/cue_fields.h",       "discretisation/discretisation.h", "inflation/inflation.h",
    "layers/layered_mesh.h",   "nonlinear/nonlinear_solution.h",  "ordering/ordering.h",
    "surface/visible_sheet.h",
};

/// Values of the understanding that files hold, for their readers and writers.
const NameSet file_structs = {
    "labels/scribbles.h",
    "marks/layered_drawing.h",
    "scene/segmentation_record.h",
};

/// The verbs of the stages, for the session alone.
const NameSet stage_verbs = {
    "hiding/hide_sheets.h",     "inflation/inflate.h",      "layers/layer_parts.h",
    "maps/relief_maps.h",       "ordering/order_depth.h",   "nonlinear/solve_nonlinear.h",
    "surface/assemble_limbs.h", "surface/assemble_model.h",
};

/// The non-linear stage unites these two and is made of their parts.
const NameSet united_rooms = {"inflation", "ordering"};

/// The rooms that programs and bindings use as a whole, and headers of others that they use.
const NameSet open_rooms = {"perception", "labels", "marks", "scene", "session", "finish", "maps"};
const NameSet open_headers = {"areas/basins.h", "areas/find_basins.h", "joins/join_proposals.h"};

struct Place {
  /// relievo, kernel, scene, understanding, relief, io, lod, render, solid, api, apps, bindings,
  /// research, tests, benchmarks
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

bool is_wing(const std::string& top) { return wings.count(top) > 0; }

bool is_handed_on(const Place& to) {
  return to.top == "relief" && stage_structs.count(to.rest) > 0;
}

bool is_verb(const Place& to) { return to.top == "relief" && stage_verbs.count(to.rest) > 0; }

bool is_open(const Place& to) {
  return is_wing(to.top) && open_rooms.count(to.folder) + open_headers.count(to.rest) > 0;
}

std::string check_kernel(const Place& from, const Place& to) {
  const auto rule = kernel_rules.find(from.folder);
  if (rule == kernel_rules.end()) return "kernel/" + from.folder + " has no rule";
  if (to.top != "kernel") return "the kernel knows only itself";
  if (to.folder == from.folder || rule->second.count(to.folder) > 0) return "";
  return "kernel/" + from.folder + " must not use kernel/" + to.folder;
}

std::string check_wing(const Place& from, const Place& to) {
  if (to.top == "kernel" || to.top == "scene") return "";
  if (to.top != from.top) return "a wing knows only the kernel, scenes and itself";
  if (to.folder == from.folder) return "";
  const std::vector<std::string>& rooms = wings.at(from.top);
  const auto mine = std::find(rooms.begin(), rooms.end(), from.folder);
  if (mine == rooms.end()) return from.top + "/" + from.folder + " is no room";
  if (std::find(rooms.begin(), mine, to.folder) == mine) return "a room must not use a later one";
  if (from.top == "understanding" || is_handed_on(to)) return "";
  if (from.folder == "session" && is_verb(to)) return "";
  if (from.folder == "maps" && to.folder == "surface") return "";
  if (from.folder == "nonlinear" && united_rooms.count(to.folder) > 0) return "";
  return "a stage uses only the structs of earlier ones";
}

std::string check_scene(const Place& to) {
  return to.top == "kernel" || to.top == "scene" ? "" : "scenes know only the kernel";
}

std::string check_io(const Place& to) {
  if (to.top == "kernel" || to.top == "scene" || to.top == "io" || is_handed_on(to)) return "";
  if (to.top == "understanding" && file_structs.count(to.rest) > 0) return "";
  if (to.top == "relief" && to.folder == "finish") return "";
  return "io uses the kernel, scenes, finished models, structs of both wings and itself only";
}

std::string check_render(const Place& to) {
  if (to.top == "kernel" || to.top == "render") return "";
  if (to.top == "relief" && to.folder == "finish") return "";
  return "render uses the kernel, finished models and itself only";
}

std::string check_lod(const Place& to) {
  return to.top == "kernel" || to.top == "lod" ? "" : "lod uses the kernel and itself only";
}

std::string check_solid(const Place& to) {
  if (to.top == "kernel" || to.top == "solid") return "";
  if (to.rest == "surface/visible_sheet.h" || (to.top == "relief" && to.folder == "finish"))
    return "";
  return "solid uses the kernel, visible sheets, finished models and itself only";
}

/// Checks programs and bindings alike.
std::string check_apps(const Place& from, const Place& to) {
  for (const char* top : {"kernel", "scene", "io", "lod", "render", "solid", "api"})
    if (to.top == top || to.top == from.top) return "";
  if (!is_wing(to.top)) return from.top + " use the libraries only";
  if (is_handed_on(to) || is_verb(to) || is_open(to)) return "";
  return from.top + " use open rooms and the stages' structs and verbs, not their insides";
}

/// Checks research: rival methods are made of the same stages as ours; its programs use the parts
/// of the command line. What is learned is measured inside the understanding.
std::string check_research(const Place& from, const Place& to) {
  if (to.top == "seams") return "";
  if (from.folder == "learning" && to.top == "understanding") return "";
  if (from.folder != "rivals") return to.top == "apps" ? "" : check_apps(from, to);
  if (to.top == "io" || to.top == "solid" || to.top == "api" || to.folder == "compare")
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
  if (source.top == "scene") return check_scene(target);
  if (is_wing(source.top)) return check_wing(source, target);
  if (source.top == "io") return check_io(target);
  if (source.top == "render") return check_render(target);
  if (source.top == "solid") return check_solid(target);
  if (source.top == "lod") return check_lod(target);
  if (source.top == "research" && source.folder != "tests") return check_research(source, target);
  if (source.top == "apps" || source.top == "bindings" || source.top == "api")
    return check_apps(source, target);
  if (target.top == "apps" || target.top == "bindings") return "nobody includes " + target.top;
  if (target.top == "research" && source.top != "research") return "nobody includes research";
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
  if (source.top != "kernel" && source.top != "scene" && !is_wing(source.top)) return found.str();
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
