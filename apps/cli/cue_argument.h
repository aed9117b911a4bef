#pragma once

#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Parses PART:KIND:X,Y,X,Y,...:VALUE. The part's id may contain colons. Errors: `usage`.
Result<CueArgument> parse_cue(const std::string& text);

/// Adds the cues to the scene. Errors: `usage` if it has no part with the id of a cue.
Status add_cues(const std::vector<CueArgument>& cues, Scene& scene);

/// Returns a warning for each cue whose line lies outside its part, where it has no effect.
std::vector<std::string> warnings_about_cues(const Scene& scene);

}  // namespace relievo::cli
