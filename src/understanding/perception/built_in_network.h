#pragma once

#include "understanding/perception/network.h"

namespace relievo::understanding {

/// Returns the network that research/learning/network.py trained. Its weights are compiled in; the
/// editor, which loads them with the first flat drawing, does not use this.
const Network& built_in_network();

}  // namespace relievo::understanding
