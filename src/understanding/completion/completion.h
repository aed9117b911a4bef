#pragma once

#include <array>
#include <vector>

#include "kernel/image/mask.h"

namespace relievo::understanding {

/// How a part's hidden region was found.
enum class CompletionKind {
  whole,         ///< nothing of it is hidden
  ellipse,       ///< its contour is that of an ellipse
  continuation,  ///< its contour goes on smoothly, as the sides of a limb do
  membrane,      ///< the illusory surface of a diffusion
  given,         ///< drawn by the user
};

/// The kinds as files and reports spell them.
inline constexpr std::array<const char*, 5> completion_names = {"whole", "ellipse", "continuation",
                                                                "membrane", "given"};

inline const char* name(CompletionKind kind) { return completion_names[static_cast<int>(kind)]; }

/// A part with what others hide of it [P §3].
struct CompletedPart {
  Mask shape;  ///< the visible part and what is hidden, which lies below its occluders only
  CompletionKind kind = CompletionKind::whole;
};

/// Parts in the order of their labels.
struct Completion {
  std::vector<CompletedPart> parts;
};

/// What the shapes of two neighbours say about which hides the other.
struct NeighbourEvidence {
  int a = -1;  ///< parts, a < b
  int b = -1;
  int shared = 0;        ///< length of their common boundary, pixel sides
  double a_below_b = 0;  ///< px of b that a would cover if everything around could hide it
  double b_below_a = 0;
  bool a_shaped = false;  ///< the common boundary fits the rest of a's contour
  bool b_shaped = false;
  bool open = false;  ///< the drawing shows nothing along it: they have grown together
};

}  // namespace relievo::understanding
