#pragma once

#include <array>
#include <vector>

#include "kernel/image/mask.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// How the hidden region of a part was found.
enum class CompletionKind {
  whole,         ///< nothing of the part is hidden
  ellipse,       ///< its contour is that of an ellipse
  continuation,  ///< its contour goes on smoothly, as the sides of a limb do
  membrane,      ///< the illusory surface of a diffusion
  given,         ///< drawn by the user
};

/// The kinds as files and reports spell them.
inline constexpr std::array<const char*, 5> completion_names = {"whole", "ellipse", "continuation",
                                                                "membrane", "given"};

inline const char* name(CompletionKind kind) { return completion_names[static_cast<int>(kind)]; }

/// A part with its hidden region [P §3].
struct CompletedPart {
  Mask shape;  ///< the visible part and its hidden region, which lies below its occluders only
  CompletionKind kind = CompletionKind::whole;
  std::vector<int> occluders;  ///< the parts that were taken to hide it, sorted
};

/// All parts, indexed as in PartRegions.
using Completion = std::vector<CompletedPart>;

/// Evidence from the shapes of two neighbours about which hides the other.
struct NeighbourEvidence {
  PartLabel a = 0;  ///< a < b
  PartLabel b = 0;
  int shared = 0;        ///< length of their common boundary, pixel sides
  double a_below_b = 0;  ///< px of b that a covers if all other parts could hide it
  double b_below_a = 0;
  bool a_shaped = false;  ///< the common boundary fits the rest of a's contour
  bool b_shaped = false;
  double front = 0;   ///< how far a is seen in front of b, from -1 to 1
  bool open = false;  ///< the drawing shows neither line nor edge between them
};

}  // namespace relievo::understanding
