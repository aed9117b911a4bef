#pragma once

#include "understanding/perception/network.h"

namespace relievo::understanding {

/// Returns the network that research/learning/network.py trained. Its weights are
/// compiled in.
const Network& built_in_network();

}  // namespace relievo::understanding
