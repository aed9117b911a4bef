#pragma once

#include "relief/drawing/drawing.h"
#include "relief/model/model.h"

namespace relievo {

/// A model and the picture that lies on it, which is empty where there is none.
struct DrawnModel {
  Model model;
  Drawing drawing;
};

}  // namespace relievo
