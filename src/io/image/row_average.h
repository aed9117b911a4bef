#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// Pixels that a reduced picture keeps at least; it has twice as many at most, or little more.
/// Finding parts needs no more.
constexpr int64_t kept_pixels = 2'000'000;

/// Returns the largest whole factor by which both sides of a picture can be divided so that
/// `kept_pixels` are left; 1 for pictures below four times as many.
int reduction_factor(int64_t width, int64_t height);

/// Returns the number of squares of `factor` px that a side takes. The last one may be cut off.
inline int reduced_side(int side, int factor) { return (side + factor - 1) / factor; }

/// Averages squares of factor x factor px while the rows of a picture arrive, so that the whole
/// picture is never held. Colours count by their alpha.
class RowAverage {
 public:
  RowAverage(int width, int height, int factor);

  /// Adds the next row of RGBA pixels with straight alpha.
  void add(const uint8_t* row);

  /// Hands over the reduced picture once all rows were added.
  Image8 take() { return std::move(reduced_); }

 private:
  struct Sum {
    uint32_t red = 0;  ///< colours times alpha
    uint32_t green = 0;
    uint32_t blue = 0;
    uint32_t alpha = 0;
  };

  void sum_up(const uint8_t* row);
  void write_row(int y, int rows);

  int width_;
  int height_;
  int factor_;
  int added_ = 0;          ///< rows so far
  std::vector<Sum> sums_;  ///< of the squares that are begun
  Image8 reduced_;
};

/// Returns an RGBA picture whose pixels are averages of factor x factor px of `rgba`.
Image8 averaged(Image8 rgba, int factor);

}  // namespace relievo
