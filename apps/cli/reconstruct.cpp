#include "apps/cli/reconstruct.h"

#include <algorithm>
#include <utility>

#include "api/solid_of.h"
#include "apps/cli/cue_argument.h"
#include "relief/finish/finish_model.h"
#include "relief/surface/assemble_model.h"

namespace relievo::cli {
namespace {

/// The middle of the range that the paper gives for outlines beside joins, [0, 0.2].
constexpr double paper_alpha0 = 0.1;

/// Gives a part the values of all results of the paper [P section 4]. Keeps the sign of d.
Part as_in_paper(Part part) {
  part.c = 4;
  part.d = part.d < 0 ? -1 : 1;
  part.flat = 0;
  part.lean = {};
  return part;
}

/// Whole parts are the default, since they stay connected when the model is turned.
Visibility shown(const ReliefArguments& arguments) {
  return arguments.visibility.value_or(Visibility::orbit);
}

}  // namespace

Result<relief::ReliefOptions> settle_options(Scene& scene, const ReliefArguments& arguments) {
  relief::ReliefOptions options = arguments.options;
  options.hidden = arguments.solid.value_or(false) ? arguments.solid_options.back != BackSide::flat
                                                   : shown(arguments) != Visibility::relief;
  if (arguments.as_in_paper) {
    for (Part& part : scene.parts) part = as_in_paper(std::move(part));
    options.layers.attach = false;
    options.inflation.alpha0 = paper_alpha0;
    options.ordering.straight_limbs = false;
    options.ordering.close_caps = false;
  }
  if (arguments.c)
    for (Part& part : scene.parts) part.c = *arguments.c;
  if (arguments.flat)
    for (Part& part : scene.parts) part.flat = *arguments.flat;
  if (arguments.lean)
    for (Part& part : scene.parts) part.lean = *arguments.lean;
  if (Status status = add_cues(arguments.cues, scene); !status) return status.error();
  return options;
}

bool leave_out_guess(const Error& error, const GuessedScene& guessed) {
  const auto& [scene, guesses, warnings] = guessed;
  const auto [list, index] = error.culprit;
  if (list != CulpritList::joins || index >= scene.joins.size()) return false;
  const Join join = scene.joins[index];
  const auto between = [&](const auto& other) {
    return other.upper == join.upper && other.lower == join.lower;
  };
  const auto guess = std::find_if(
      guesses.joins.begin(), guesses.joins.end(),
      [&](const understanding::ProposedJoin& one) { return !one.user && between(one.join); });
  if (guess == guesses.joins.end()) return false;
  guesses.joins.erase(guess);
  scene.joins.erase(scene.joins.begin() + static_cast<std::ptrdiff_t>(index));
  std::erase_if(scene.robin, between);
  warnings.push_back("the guess that \"" + scene.parts[join.upper].id + "\" joins \"" +
                     scene.parts[join.lower].id +
                     "\" is left out: the join is too small for this mesh; use more --vertices");
  return true;
}

Result<relief::Relief> reconstruct(SceneInput& input, const ReliefArguments& arguments,
                                   const RunContext& context) {
  Scene& scene = input.scene;
  const auto options = settle_options(scene, arguments);
  if (!options) return options.error();
  auto relief = without_bad_guesses({scene, input.guesses, input.warnings},
                                    [&] { return relief::build_relief(scene, *options, context); });
  if (!relief) return relief;
  relief::keep_field(*relief, arguments.field);
  for (std::string& warning : warnings_about_cues(scene))
    relief->layers.warnings.push_back(std::move(warning));
  return relief;
}

Result<MadeModel> make_model(const relief::Relief& relief, const SceneInput& input,
                             const ReliefArguments& arguments, Ink ink, const RunContext& context) {
  if (arguments.solid.value_or(false)) {
    SolidOptions solid_options = arguments.solid_options;
    solid_options.ink = ink;
    solid_options.ink_width = arguments.ink_width;
    auto solid = solid_of(relief, input.scene, input.drawing, solid_options, context);
    if (!solid) return solid.error();
    return MadeModel{{std::move(solid->model), std::move(solid->drawing)}, solid->facts};
  }
  ModelOptions options;
  options.visibility = shown(arguments);
  auto model = relief::assemble_model(
      {relief.layers, relief.inflation, relief.ordering, input.scene}, options, context);
  if (!model) return model.error();
  return MadeModel{relief::finish_model(std::move(*model), input.drawing, ink, arguments.ink_width),
                   {}};
}

std::vector<PrintFinding> print_findings(const MadeModel& made, const ReliefArguments& arguments) {
  if (!made.solid) return {};
  return check_print(made.drawn.model, made.solid->loose, arguments.nozzle,
                     stands(arguments.solid_options));
}

}  // namespace relievo::cli
