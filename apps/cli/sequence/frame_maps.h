#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/maps/encode_maps.h"
#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/scene.h"

namespace relievo::cli {

/// What is kept of a frame until the range of all of them is known.
struct FrameMaps {
  std::string name;
  Image8 colour;                    ///< the drawing, RGBA, straight alpha
  Image8 normal;                    ///< as normal_image
  Image8 occlusion;                 ///< as share_image; empty where it is not wanted
  ImageF height;                    ///< px, NaN on the background
  Image<int32_t> part;              ///< numbers that all frames share, -1 on the background
  std::map<int, Outline> outlines;  ///< by these numbers, canvas px
};

/// Of a frame on which nothing is drawn.
FrameMaps blank_maps(const std::string& name, ImageSize size);

/// A picture at another size: means of what a pixel covers, weighted by alpha, where it gets
/// smaller, the nearest pixel otherwise.
Image8 resized(const Image8& rgba, ImageSize size);

/// Numbers of parts that stay the same from frame to frame.
class PartNumbers {
 public:
  /// Gives the parts of a map their numbers: one for each name or, where names say nothing, that of
  /// the part which covered most of it in the frame before. Returns them.
  std::vector<int> renumber(const Scene& scene, bool flat, Image<int32_t>& part);

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<int> by_name(const Scene& scene);
  std::vector<int> by_place(const Scene& scene, const Image<int32_t>& part);
  int number_of(const std::string& name);

  std::vector<std::string> names_;  ///< by number
  Image<int32_t> last_;             ///< the frame before
};

/// Gives what stands still in `frame` the heights of the frame before, and what moves those that
/// bring it there smoothly: beside a join that moves, the surface is another one in each frame.
/// `pixel`: canvas px per pixel; `normal`: of `frame`, as ReliefMaps. O(pixels).
void hold_heights(const FrameMaps& before, double pixel, FrameMaps& frame, ImageF& normal);

/// How heights change from one frame to the next where the drawing stands still: shares of the
/// range of all heights.
struct Flicker {
  double still = 0;  ///< share of the figure's pixels that do
  double median = 0;
  double most99 = 0;  ///< 99 of 100 pixels change no more
  double most = 0;
};

/// A pixel stands still where its colours differ by at most 2 of 255, and the outline of its part
/// by at most half a canvas px.
Flicker measure_flicker(const FrameMaps& before, const FrameMaps& after, const HeightRange& range);

}  // namespace relievo::cli
