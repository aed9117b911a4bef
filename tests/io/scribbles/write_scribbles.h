#pragma once

#include <string>

#include "understanding/labels/scribbles.h"

namespace relievo {

/// The scribble file that read_scribbles reads back to the same values, one stroke a line.
std::string write_scribbles(const understanding::Scribbles& scribbles);

}  // namespace relievo
