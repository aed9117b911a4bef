#pragma once

#include <string>
#include <vector>

#include "relievo/image.h"

namespace relievo::testing {

/// A part of a character made of ellipsoids.
struct TruePart {
  int label = 0;
  std::string name;
  Image8 mask;  ///< the whole part, 1 channel, 0 or 1
};

/// Two parts that overlap.
struct TruePair {
  int a = 0;  ///< labels
  int b = 0;
  double a_in_front = 0;  ///< px of their overlap
  double b_in_front = 0;
};

/// A rendered character of which everything is known.
struct TrueCharacter {
  std::string name;
  Image16 labels;
  ImageF depth;                 ///< towards the viewer, 0 on the background, else from 1 on
  std::vector<TruePart> parts;  ///< those that are seen
  std::vector<TruePair> pairs;  ///< of parts that are seen
};

/// The characters of the shared data, by name; empty where it is not here.
std::vector<TrueCharacter> true_characters();

}  // namespace relievo::testing
