#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/maps/encode_maps.h"
#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/scene.h"

namespace relievo::cli {

/// The maps of a frame, kept until the range of all heights is known.
struct FrameMaps {
  std::string name;
  Image8 colour;                    ///< the drawing, RGBA, straight alpha
  Image8 normal;                    ///< see normal_image
  Image8 occlusion;                 ///< see share_image; empty if not wanted
  ImageF height;                    ///< px, NaN on the background
  Image<int32_t> part;              ///< numbers shared by all frames, -1 on the background
  std::map<int, Outline> outlines;  ///< by part number, canvas px
};

/// Returns the maps of an empty frame.
FrameMaps blank_maps(const std::string& name, ImageSize size);

/// Resizes a picture. Pixels are means of those that they cover, weighted by alpha, if it shrinks,
/// and the nearest ones otherwise.
Image8 resized(const Image8& rgba, ImageSize size);

/// Part numbers that stay the same from frame to frame.
class PartNumbers {
 public:
  /// Renumbers the parts of a map. Parts of the same name have the same number; parts of `flat`
  /// frames, which have no names of their own, have that of the part that covered most of them in
  /// the previous frame. Returns the number of each part of the scene.
  std::vector<int> renumber(const Scene& scene, bool flat, Image<int32_t>& part);

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<int> by_name(const Scene& scene);
  std::vector<int> by_place(const Scene& scene, const Image<int32_t>& part);
  int number_of(const std::string& name);

  std::vector<std::string> names_;  ///< by number
  Image<int32_t> last_;             ///< the previous frame
};

/// Gives still pixels of `frame` the heights of the previous frame, and adapts moving ones
/// smoothly. Otherwise heights would change beside a moving join. `pixel`: canvas px per pixel;
/// `normal`: of `frame`, as in ReliefMaps. O(pixels).
void hold_heights(const FrameMaps& before, double pixel, FrameMaps& frame, ImageF& normal);

/// Changes of height from one frame to the next at still pixels, as shares of the range of heights.
struct Flicker {
  double still = 0;  ///< share of the figure's pixels that are still
  double median = 0;
  double most99 = 0;  ///< 99th percentile
  double most = 0;    ///< maximum
};

/// Measures flicker. A pixel is still if its colours differ by at most 2 of 255, and the outline of
/// its part by at most half a canvas px.
Flicker measure_flicker(const FrameMaps& before, const FrameMaps& after, const HeightRange& range);

}  // namespace relievo::cli
