#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "face/inputs.h"
#include "relief/finish/finish_model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "solid/check_print.h"
#include "solid/make_solid.h"

namespace relievo::cli {

/// A model, and what is to be told of it where it is a solid.
struct MadeModel {
  relief::DrawnModel drawn;
  std::optional<SolidFacts> solid;
};

/// What is wrong with a solid as it lies, or stands, on the bed; nothing with other models.
std::vector<PrintFinding> print_findings(const MadeModel& made, const ReliefArguments& arguments);

/// The options of a relief, and what they change of the scene's own values.
Result<relief::ReliefOptions> settle_options(Scene& scene, const ReliefArguments& arguments);

/// A scene, what of it was guessed, and where to say that some of that is left out.
struct GuessedScene {
  Scene& scene;
  understanding::JoinProposals& guesses;
  std::vector<std::string>& warnings;
};

/// Takes a join that was guessed out of the scene where it is what an error is about; false where
/// the error is about something else.
bool leave_out_guess(const Error& error, const GuessedScene& guessed);

/// What `work` makes of the scene, once no guessed join is in its way: one that is fine for a mesh
/// may be too short for a coarser one.
template <class Work>
auto without_bad_guesses(const GuessedScene& guessed, Work work) {
  auto done = work();
  while (!done && leave_out_guess(done.error(), guessed)) done = work();
  return done;
}

/// The relief of a scene by the chosen options, or the field of it that they ask for. They may
/// change the scene's own values (c), and guessed joins may be left out.
Result<relief::Relief> reconstruct(SceneInput& input, const ReliefArguments& arguments,
                                   const RunContext& context);

/// The solid of a relief where that is asked for; otherwise the surface that the chosen visibility
/// keeps, with the drawing on it, and what is hidden has colours of its own.
Result<MadeModel> make_model(const relief::Relief& relief, const SceneInput& input,
                             const ReliefArguments& arguments, const RunContext& context);

}  // namespace relievo::cli
