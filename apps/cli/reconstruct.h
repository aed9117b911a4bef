#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/inputs.h"
#include "apps/cli/arguments.h"
#include "relief/finish/finish_model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"

namespace relievo::cli {

/// A model with its drawing, and the facts about it if it is a solid.
struct MadeModel {
  relief::DrawnModel drawn;
  std::optional<SolidFacts> solid;
};

/// Finds the weak spots of a solid as it lies or stands on the bed. Other models have none.
std::vector<PrintFinding> print_findings(const MadeModel& made, const ReliefArguments& arguments);

/// Returns the options of the relief, and applies those that replace values of the scene.
Result<relief::ReliefOptions> settle_options(Scene& scene, const ReliefArguments& arguments);

/// A scene, the guesses in it, and the warnings, which say if a guess is left out.
struct GuessedScene {
  Scene& scene;
  understanding::JoinProposals& guesses;
  std::vector<std::string>& warnings;
};

/// Removes the guessed join that an error is about. Returns false if it is about anything else.
bool leave_out_guess(const Error& error, const GuessedScene& guessed);

/// Returns the result of `work`, which is repeated without the guessed joins that make it fail: a
/// join that suits a fine mesh may be too short for a coarse one.
template <class Work>
auto without_bad_guesses(const GuessedScene& guessed, Work work) {
  auto done = work();
  while (!done && leave_out_guess(done.error(), guessed)) done = work();
  return done;
}

/// Builds the relief of a scene, or the field of it that the options ask for. Changes the scene:
/// options may replace its values, and guessed joins may be left out.
Result<relief::Relief> reconstruct(SceneInput& input, const ReliefArguments& arguments,
                                   const RunContext& context);

/// Makes a solid of the relief if the options ask for one. Otherwise makes the surface that the
/// chosen visibility keeps, with the drawing on it and colours for its hidden faces.
Result<MadeModel> make_model(const relief::Relief& relief, const SceneInput& input,
                             const ReliefArguments& arguments, Ink ink, const RunContext& context);

}  // namespace relievo::cli
