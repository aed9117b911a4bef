#pragma once

#include "relief/finish/find_ink.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Takes the contours off a drawing: the paint goes on under them and beyond the outline.
/// O(pixels).
void take_off_ink(const Model& model, const ContourInk& ink, Image8& rgba);

}  // namespace relievo::relief
