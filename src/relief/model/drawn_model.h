#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// A model and the picture that lies on it, which is empty where there is none.
struct DrawnModel {
  Model model;
  Drawing drawing;
};

}  // namespace relievo
