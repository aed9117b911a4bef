#include "apps/cli/relief_arguments.h"

#include <array>
#include <string>

#include "apps/cli/cue_argument.h"
#include "apps/cli/solid_arguments.h"
#include "apps/cli/within.h"

namespace relievo::cli {
namespace {

Visibility visibility(const std::string& name) {
  if (name == "orbit") return Visibility::orbit;
  return name == "all" ? Visibility::all : Visibility::relief;
}

Field field(const std::string& name) {
  if (name == "inflation") return Field::inflation;
  return name == "shift" ? Field::shift : Field::relief;
}

/// An option that takes one of two words, of which the first sets the flag.
void add_choice(CLI::App& app, const char* option, const std::array<std::string, 2>& words,
                bool& flag, const char* meaning) {
  app.add_option_function<std::string>(
         option, [&flag, first = words[0]](const std::string& word) { flag = word == first; },
         meaning)
      ->check(CLI::IsMember({words[0], words[1]}));
}

void add_cue_option(CLI::App& app, ReliefArguments& relief) {
  app.add_option_function<std::vector<std::string>>(
         "--cue",
         [&relief](const std::vector<std::string>& cues) {
           for (const std::string& text : cues) {
             const auto cue = parse_cue(text);
             if (!cue) throw CLI::ValidationError("--cue " + text, cue.error().message);
             relief.cues.push_back(*cue);
           }
         },
         "Profile along a line on a part, PART:KIND:X,Y,X,Y,...:VALUE in canvas px; may be "
         "repeated. bulge: times as high there; slope: degrees that it rises along the line; "
         "crease: degrees that it rises to the line from both sides")
      ->expected(1)
      ->take_all();
}

void add_method_options(CLI::App& app, ReliefArguments& relief) {
  app.add_option_function<std::string>(
         "--method",
         [&relief](const std::string& name) {
           if (name == "nonlinear") relief.options.method = Method::nonlinear;
         },
         "approximate (the default) or nonlinear: inflation and depth order at once")
      ->check(CLI::IsMember({"approximate", "nonlinear"}));
  relief::NonlinearOptions& nonlinear = relief.options.nonlinear;
  app.add_option("--lambda-bnd", nonlinear.lambda_bnd,
                 "Of nonlinear: how firmly outlines beside joins stay down (default 0.01: no pits)")
      ->check(within(relief::min_lambda_bnd, relief::max_lambda_bnd));
  app.add_option("--lambda-shift", nonlinear.lambda_shift,
                 "Of nonlinear: what a shift costs beside a change of the inflation (default 1)")
      ->check(within(relief::min_lambda_shift, relief::max_lambda_shift));
  app.add_option_function<std::string>(
         "--field", [&relief](const std::string& name) { relief.field = field(name); },
         "relief (the default), or one of the two that it is the sum of: inflation, shift")
      ->check(CLI::IsMember({"relief", "inflation", "shift"}));
}

void add_shape_options(CLI::App& app, ReliefArguments& relief) {
  app.add_option("--c", relief.c, "Inflation of all parts: 4 a hemisphere, 2 round limbs")
      ->check(within(min_inflation, max_inflation));
  app.add_option("--flat", relief.flat, "Profile of all parts: 0 round (the default), 1 a flat top")
      ->check(within(0.0, 1.0));
  app.add_option_function<std::vector<double>>(
         "--lean",
         [&relief](const std::vector<double>& lean) {
           relief.lean = {lean[0], lean[1]};
         },
         "Slope of all parts: how much nearer they come per px to the right and downwards")
      ->expected(2)
      ->check(within(-max_lean, max_lean));
  add_cue_option(app, relief);
  relief::InflationOptions& inflation = relief.options.inflation;
  app.add_option("--rho", inflation.rho, "Softness of ramps beside joins (default 0.25)")
      ->check(within(0.001, max_rho));
  app.add_option("--alpha0", inflation.alpha0, "How firmly ramps begin, 0 to 1 (default 0)")
      ->check(within(0.0, 1.0));
}

}  // namespace

void add_mesh_options(CLI::App& app, ReliefArguments& relief) {
  relief::LayerOptions& layers = relief.options.layers;
  auto* vertices =
      app.add_option("--vertices", layers.vertex_budget, "About so many vertices (default 40000)")
          ->check(CLI::Range(100, 10000000));
  app.add_option("--edge", layers.edge_length, "Spacing of the outlines in px, instead")
      ->check(within(0.01, 10000.0))
      ->excludes(vertices);
  app.add_option("--max-vertices", layers.max_nodes, "Refuse to make more (default 4000000)")
      ->check(CLI::Range(100, 100000000));
}

void add_relief_options(CLI::App& app, ReliefArguments& relief) {
  add_mesh_options(app, relief);
  add_method_options(app, relief);
  add_shape_options(app, relief);
  add_choice(app, "--ramps", {"auto", "robin"}, relief.options.layers.attach,
             "Outlines beside joins: auto, attached to the part below at first (the default); "
             "robin, as in the paper");
  relief::OrderingOptions& ordering = relief.options.ordering;
  add_choice(app, "--limbs", {"straight", "back"}, ordering.straight_limbs,
             "Joined limbs: straight, as far forward as they begin (the default); back, each "
             "falling back to the drawing plane, as in the paper");
  add_choice(app, "--caps", {"closed", "loose"}, ordering.close_caps,
             "Hats and eyes: closed, round what they lie on and on it (the default); loose, as far "
             "forward as where they cross it, as in the paper");
  auto* preset = app.add_option_function<std::string>(
      "--preset", [&relief](const std::string& name) { relief.as_in_paper = name == "paper"; },
      "default: the parts' own values; paper: its c = 4 and d = 1 or -1 for all, round and "
      "upright, with its ranges beside joins and neither straight limbs nor closed caps");
  preset->check(CLI::IsMember({"default", "paper"}));
  for (const char* value :
       {"--c", "--flat", "--lean", "--rho", "--alpha0", "--ramps", "--limbs", "--caps"})
    preset->excludes(app.get_option(value));
  app.add_flag_callback(
      "--no-glue", [&relief] { relief.options.layers.glue = false; },
      "Let outlines beside joins rise above the part below");
}

void add_visibility(CLI::App& app, ReliefArguments& relief) {
  auto* visible =
      app.add_option_function<std::string>(
             "--visible",
             [&relief](const std::string& name) { relief.visibility = visibility(name); },
             "orbit: whole parts (default); relief: what the front shows, with walls (default of "
             ".stl and .3mf); all: every face")
          ->check(CLI::IsMember({"relief", "orbit", "all"}));
  app.add_flag_callback(
         "--keep-hidden", [&relief] { relief.visibility = Visibility::all; },
         "The same as --visible all")
      ->excludes(visible);
  add_solid_options(app, relief);
}

}  // namespace relievo::cli
