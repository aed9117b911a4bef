#pragma once

#include <string>
#include <vector>

#include "apps/cli/arguments.h"
#include "relievo/result.h"

namespace relievo::cli {

/// Reads PART:KIND:X,Y,X,Y,...:VALUE; the part's id may have colons. Fails with usage.
Result<CueArgument> parse_cue(const std::string& text);

/// Adds the cues to the scene. Fails with usage where it has no part of that name.
Status add_cues(const std::vector<CueArgument>& cues, Scene& scene);

/// One for each cue that lies nowhere in its part, which makes it of no effect.
std::vector<std::string> warnings_about_cues(const Scene& scene);

}  // namespace relievo::cli
