#include "apps/cli/check_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "api/inputs.h"
#include "apps/cli/common_arguments.h"
#include "apps/cli/cue_argument.h"
#include "apps/cli/messages.h"
#include "apps/cli/outputs.h"
#include "apps/cli/pictures.h"
#include "apps/cli/reconstruct.h"
#include "apps/cli/relief_arguments.h"
#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/mesh/placement.h"
#include "io/overlay/mesh_lines.h"
#include "kernel/geometry/polyline.h"
#include "kernel/meshing/splice_curves.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layer_parts.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

constexpr const char* check_help =
    R"(Reads a drawing, lists its parts and joins, and reports mistakes. Writes only the files that you
name: the scene, to be edited and built, and a picture of how the drawing was understood.

Examples:
  relievo check wolf.svg
  relievo check wolf.svg --overlay understood.png
  relievo check wolf.svg -o wolf.json
  relievo check wolf.svg --profile figure --size 60)";

struct CheckArguments {
  CommonArguments common;
  std::string output;      ///< scene .json; empty: not wanted
  std::string overlay;     ///< file; empty: not wanted
  ReliefArguments relief;  ///< of which the options of solids are used
};

/// Counts the characters of UTF-8 text, which are the bytes that do not continue one.
size_t length(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

/// Text in aligned columns with headings.
class Table {
 public:
  explicit Table(std::vector<std::string> headings) : rows_{std::move(headings)} {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.size() == 1; }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string Table::text() const {
  std::vector<size_t> widths(rows_[0].size());
  for (const auto& row : rows_)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    for (size_t i = 0; i + 1 < row.size(); ++i)
      text += printable(row[i]) + std::string(widths[i] - length(row[i]) + 2, ' ');
    text += printable(row.back()) + "\n";
  }
  return text;
}

/// Formats a number with at most six significant digits.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Vertices of the trial mesh: few, but enough to find all contradictions between annotations.
constexpr int trial_vertices = 5000;

std::string part_table(const Scene& scene) {
  Table table({"part", "c", "d", "flat", "lean", "rings", "points", "size in px"});
  for (const Part& part : scene.parts) {
    size_t points = 0;
    for (const Ring& ring : part.outline) points += ring.size();
    const Box2 box = bounding_box(part.outline);
    table.add({part.id, number(part.c), number(part.d), number(part.flat),
               number(part.lean.x) + " " + number(part.lean.y), std::to_string(part.outline.size()),
               std::to_string(points),
               number(box.max.x - box.min.x) + " x " + number(box.max.y - box.min.y)});
  }
  return table.text();
}

std::string guessed(double confidence) {
  return "guessed, " + number(std::round(100 * confidence)) + " % sure";
}

/// Formats the confidence of a guess; empty for an annotation of the drawing.
std::string confidence_of(const understanding::JoinProposals& guesses, const Join& join) {
  for (const understanding::ProposedJoin& guess : guesses.joins)
    if (guess.join.upper == join.upper && guess.join.lower == join.lower)
      return guessed(guess.confidence);
  return "";
}

std::string confidence_of(const understanding::JoinProposals& guesses, const Relation& relation) {
  for (const understanding::ProposedRelation& guess : guesses.relations)
    if (guess.relation.upper == relation.upper && guess.relation.lower == relation.lower)
      return relation.kind == RelationKind::joined ? guessed(guess.confidence) : "guessed";
  return "";
}

/// Describes the kind of a relation, and whether it holds along a range only.
std::string detail_of(const Relation& relation) {
  const std::string kind =
      relation.kind == RelationKind::joined ? "from behind" : name(relation.kind);
  return kind + (relation.range ? " along a range" : "");
}

std::string annotation_table(const SceneInput& input) {
  const Scene& scene = input.scene;
  Table table({"annotation", "upper", "lower", "detail", ""});
  const auto id = [&](int part) { return scene.parts[part].id; };
  for (const Join& join : scene.joins)
    table.add({"join", id(join.upper), id(join.lower), counted(join.line.size(), "point"),
               confidence_of(input.guesses, join)});
  for (const Relation& relation : scene.relations)
    table.add({relation.kind == RelationKind::joined ? "join" : "relation", id(relation.upper),
               id(relation.lower), detail_of(relation), confidence_of(input.guesses, relation)});
  for (const RobinRange& range : scene.robin)
    table.add({"robin", id(range.upper), id(range.lower),
               "alpha0 " + (range.alpha0 ? number(*range.alpha0) : "default") + ", rho " +
                   (range.rho ? number(*range.rho) : "default"),
               ""});
  return table.empty() ? "" : table.text();
}

std::string cue_table(const Scene& scene) {
  Table table({"cue", "part", "value", "px in the part"});
  for (const Cue& cue : scene.cues) {
    double inside = 0;
    for (const LineSpan span : spans_inside(cue.line, scene.parts[cue.part].outline))
      inside += span.to - span.from;
    table.add({name(cue.kind), scene.parts[cue.part].id,
               number(cue.value) + (cue.kind == CueKind::bulge ? "" : " degrees"), number(inside)});
  }
  return table.empty() ? "" : table.text();
}

/// Warns of outlines that cross themselves, where the surface is pinched.
std::vector<std::string> warnings_about_outlines(const Scene& scene) {
  std::vector<std::string> warnings;
  for (size_t p = 0; p < scene.parts.size(); ++p)
    if (const auto place = find_self_crossing(scene.parts[p].outline))
      warnings.push_back("parts[" + std::to_string(p) + "] (\"" + scene.parts[p].id +
                         "\"): its outline crosses itself at " + number(place->x) + " " +
                         number(place->y) + "; everything inside it is filled");
  return warnings;
}

/// Lists the pairs of parts that overlap, and how much of the overlap is glued.
std::string overlap_table(const Scene& scene, const relief::LayeredMesh& mesh) {
  std::map<std::pair<int, int>, std::pair<size_t, size_t>> pairs;
  for (const relief::DepthPair& pair : mesh.constraints) {
    auto& [equal, above] = pairs[{mesh.node_part[pair.upper], mesh.node_part[pair.lower]}];
    ++(pair.equal ? equal : above);
  }
  if (pairs.empty()) return "";
  Table table({"overlap", "over", "glued at", "above at"});
  for (const auto& [parts, counts] : pairs)
    table.add({scene.parts[parts.first].id, scene.parts[parts.second].id,
               std::to_string(100 * counts.first / (counts.first + counts.second)) + " %",
               std::to_string(100 - 100 * counts.first / (counts.first + counts.second)) + " %"});
  return table.text();
}

/// Prints tables of the scene, and warnings about it, whose number it returns.
size_t print_scene(const SceneInput& input) {
  const Scene& scene = input.scene;
  print_result("canvas " + number(scene.width) + " x " + number(scene.height) + " px, " +
               counted(scene.parts.size(), "part") +
               (input.proposed ? " found in the drawing" : "") + ", back to front");
  print_result("\n" + part_table(scene));
  for (const std::string& table : {annotation_table(input), cue_table(scene)})
    if (!table.empty()) print_result("\n" + table);
  const std::vector<std::string> of_cues = warnings_about_cues(scene);
  const std::vector<std::string> of_outlines = warnings_about_outlines(scene);
  print_warnings(of_cues);
  print_warnings(of_outlines);
  return of_cues.size() + of_outlines.size();
}

/// Lists what would go wrong in printing the solid or figure, and returns the number of findings.
Result<size_t> print_weak_spots(const CheckArguments& check, SceneInput& input,
                                const RunContext& context) {
  ReliefArguments arguments = check.relief;
  arguments.options.layers.vertex_budget = trial_vertices;
  const auto relief = reconstruct(input, arguments, context);
  if (!relief) return relief.error();
  const auto made = make_model(*relief, input, arguments, Ink::none, context);
  if (!made) return made.error();
  const std::vector<PrintFinding> findings = print_findings(*made, arguments);
  Table table({"to print", "part", "problem and remedy"});
  for (const PrintFinding& finding : findings)
    table.add({name(finding.trouble), finding.part, describe(finding)});
  print_result(table.empty() ? "\nready to print\n" : "\n" + table.text());
  return findings.size();
}

/// Writes the scene and the overlay, if they are wanted.
Status write_outputs(const CheckArguments& check, const InputFile& file, const SceneInput& input,
                     const relief::LayeredMesh& mesh, Interruption& interruption) {
  Outputs outputs;
  if (!check.output.empty()) {
    const auto drawing = drawing_of(file, input);
    if (!drawing) return drawing.error();
    add_scene(outputs, check.output, input.scene, *drawing);
  }
  outputs.add(check.overlay, [&] {
    const MeshLines lines = find_mesh_lines(mesh, relief::InflationOptions().alpha0);
    return draw_overlay(input.scene, {{}, lines}, input.drawing.rgba);
  });
  if (Status s = save(outputs, input.files, interruption); !s) return s;
  for (const OutputFile& written : outputs.files) print_result(written.path.string());
  return Done{};
}

Status run_check(const CheckArguments& check, Interruption& interruption) {
  const std::vector<std::filesystem::path> outputs = {check.output, check.overlay};
  if (Status s = check_outputs(outputs, {check.common.input}); !s) return s;
  const auto file = read_input(check.common.input);
  if (!file) return file.error();
  auto input = load_scene(*file, check.common.connect, {interruption.flag(), {}});
  if (!input) return input.error();
  if (Status s = check_outputs(outputs, input->files); !s) return s;
  if (Status status = validate(input->scene); !status) return status;
  print_warnings(input->warnings);
  for (const std::string& line : input->understood) print_note(line);
  const size_t of_scene = print_scene(*input);
  relief::LayerOptions options;
  options.vertex_budget = trial_vertices;
  // A guessed join that is too short for this coarse mesh is not a mistake of the drawing.
  Scene tried = input->scene;
  understanding::JoinProposals guesses = input->guesses;
  std::vector<std::string> left_out;
  const auto mesh = without_bad_guesses({tried, guesses, left_out}, [&] {
    return relief::layer_parts(tried, options, {interruption.flag(), {}});
  });
  if (!mesh) return mesh.error();
  if (Status status = relief::check_fixed(*mesh, tried, {}); !status) return status;
  print_warnings(mesh->warnings);
  if (const std::string table = overlap_table(input->scene, *mesh); !table.empty())
    print_result("\n" + table);
  size_t complaints = input->warnings.size() + of_scene + mesh->warnings.size();
  if (check.relief.solid.value_or(false)) {
    const auto weak_spots = print_weak_spots(check, *input, {interruption.flag(), {}});
    if (!weak_spots) return weak_spots.error();
    complaints += *weak_spots;
  }
  if (Status s = write_outputs(check, *file, *input, *mesh, interruption); !s) return s;
  print_note(check.common.input + ": " +
             (complaints == 0 ? "no mistakes found"
                              : "see the " + counted(complaints, "complaint") + " above"));
  return Done{};
}

}  // namespace

void add_check(CLI::App& main, Command& chosen) {
  const auto check = std::make_shared<CheckArguments>();
  CLI::App& app = *main.add_subcommand("check", check_help);
  add_common(app, check->common, input_help);
  add_connect(app, check->common);
  add_path(app, "-o,--output", check->output, "The scene, with everything that was guessed (.json)",
           {".json"});
  add_path(app, "--overlay", check->overlay,
           "Picture of the drawing with its parts, joins, relations and soft ranges marked (.png)");
  add_solid_options(app, check->relief);
  add_size(app, check->relief.solid_options.size, 1, 10000);
  app.callback([check, &chosen] { chosen = command(check, run_check); });
}

}  // namespace relievo::cli
