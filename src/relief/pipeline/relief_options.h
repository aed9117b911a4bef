#pragma once

#include "relief/inflation/inflate.h"
#include "relief/joint/solve_jointly.h"
#include "relief/layers/layer_parts.h"
#include "relief/ordering/order_depth.h"
#include "relievo/options.h"

namespace relievo {

struct ReliefOptions {
  Method method = Method::approximate;
  LayerOptions layers;
  InflationOptions inflation;
  OrderingOptions ordering;
  JointOptions joint;  ///< of the non-linear method; epsilon and limbs are the ordering's
  /// Whether what is hidden from the front is wanted too: in models of whole sheets.
  bool hidden = true;
};

}  // namespace relievo
