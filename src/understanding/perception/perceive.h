#pragma once

#include "relievo/image.h"
#include "understanding/perception/network.h"

namespace relievo::understanding {

/// Ways across contours to the parts in front, by cells of a picture.
struct FrontMap {
  ImageF way;  ///< [2] along x and y; shorter than 1 where the order is unsure; empty if unknown
  double cell = 1;  ///< px
};

/// Maps of what a network sees in a picture, by cells of `cell` px a side.
struct Perception {
  Image8 figure;   ///< probability that a cell belongs to the figure, of 255
  Image8 contour;  ///< probability that a contour of a visible part runs through a cell, of 255
  FrontMap front;
  double cell = 1;  ///< px
};

/// Applies a network to a picture (RGBA), which is laid on white and reduced or enlarged so that
/// its longer side has 512 px. Its layers are those that research/learning/network.py trains.
/// Error: `bad_input` where the network has other layers. Precondition: the picture is not empty.
/// O(pixels).
Result<Perception> perceive(const Image8& rgba, const Network& network);

/// Interpolates a map of cells at the centres of the pixels of a picture of the given size.
/// O(pixels).
Image8 at_pixels(const Image8& map, double cell, int width, int height);

}  // namespace relievo::understanding
