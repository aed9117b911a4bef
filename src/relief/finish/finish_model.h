#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// A model and the picture on it, which is empty if there is none.
struct DrawnModel {
  Model model;
  Drawing drawing;
};

/// Finishes a surface for files and pictures. Contours become lines, stay in the paint or are left
/// out, as `ink` says; lines are `ink_width` times as wide as drawn; paint continues over rims, and
/// hidden faces get colours (dress_hidden). Returns a model that is not `unfinished` as it is.
/// Near-linear in pixels and triangles.
DrawnModel finish_model(Model model, Drawing drawing, Ink ink, double ink_width = 1);

/// Gives triangles hidden behind other parts colours of their own, which the drawing does not have.
/// The picture is the drawing, with paint carried over its rims (extend_paint), and below it the
/// patches of hidden_patches. Texture coordinates become those of the picture, vertices between
/// seen and hidden triangles are doubled, and no triangle counts as hidden any more. Linear in
/// pixels and triangles.
DrawnModel dress_hidden(Model model, Drawing drawing);

}  // namespace relievo::relief
