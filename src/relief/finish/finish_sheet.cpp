#include "relief/finish/finish_sheet.h"

#include "relief/finish/extend_paint.h"
#include "relief/finish/model_texture.h"
#include "relief/finish/take_off_ink.h"

namespace relievo::relief {

TakenInk finish_sheet(Ink ink, const Model& sheet, Drawing& drawing) {
  TakenInk taken;
  if (ink != Ink::paint) taken.contours = find_ink(sheet, drawing);
  if (taken.contours.lines.empty()) {
    extend_paint(sheet, drawing);
    return taken;
  }
  taken.inked = outline_texture(sheet, drawing);
  take_off_ink(sheet, taken.contours, drawing.rgba);
  if (ink == Ink::none) return {};
  return taken;
}

}  // namespace relievo::relief
