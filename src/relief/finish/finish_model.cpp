#include "relief/finish/finish_model.h"

#include <utility>

#include "relief/finish/draw_in.h"
#include "relief/finish/extend_paint.h"
#include "relief/finish/find_ink.h"
#include "relief/finish/hidden_patches.h"
#include "relief/finish/ink_mesh.h"
#include "relief/finish/model_texture.h"
#include "relief/finish/take_off_ink.h"

namespace relievo::relief {

DrawnModel finish_model(Model model, Drawing drawing, Ink mode, double ink_width) {
  if (!model.unfinished) return {std::move(model), std::move(drawing)};
  model.unfinished = false;
  const ContourInk ink = mode == Ink::paint ? ContourInk{} : find_ink(model, drawing);
  if (ink.lines.empty()) return dress_hidden(std::move(model), std::move(drawing));
  Image8& rgba = drawing.rgba;
  const bool lines = mode == Ink::shell;
  const Image8 inked = lines ? outline_texture(model, drawing) : Image8{};
  take_off_ink(model, ink, rgba);
  if (lines) draw_in(DrawIn(ink), model);
  lay_patches(hidden_patches(model, drawing), model, rgba);
  if (lines) add_ink(ink, inked, ink_width, model, rgba);
  return {std::move(model), std::move(drawing)};
}

DrawnModel dress_hidden(Model model, Drawing drawing) {
  const HiddenPatches patches = hidden_patches(model, drawing);
  extend_paint(model, drawing);
  lay_patches(patches, model, drawing.rgba);
  return {std::move(model), std::move(drawing)};
}

}  // namespace relievo::relief
