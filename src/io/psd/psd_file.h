#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "kernel/image/pixel_box.h"
#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// One packed plane.
struct PsdChannel {
  int id = 0;  ///< 0 to 2: red, green, blue, or 0: grey; -1: alpha; -2: mask; -3: real user mask
  ByteView data;
};

/// The mask that a layer's alpha is multiplied with.
struct PsdMask {
  PixelBox box;
  uint8_t outside = 0;  ///< its value outside the box
  bool disabled = false;
  bool rendered = false;  ///< from the vector mask
};

enum class PsdKind { layer, group, group_end };

/// A layer's record. Views point into the file's bytes.
struct PsdLayer {
  std::string name;
  PsdKind kind = PsdKind::layer;
  PixelBox box;
  std::vector<PsdChannel> channels;
  std::optional<PsdMask> mask;
  std::array<char, 4> blend = {'n', 'o', 'r', 'm'};
  double opacity = 1;
  bool hidden = false;
  bool clipped = false;      ///< to the next layer below that is not clipped
  bool adjusts = false;      ///< it has no pixels but changes what is below
  bool has_effects = false;  ///< shadows, strokes and the like around it
  bool is_artboard = false;  ///< a group that may have a ground of its own
  ByteView solid_fill;       ///< block of a fill with one colour; empty: none
  ByteView vector_mask;      ///< block of a vector mask; empty: none
};

struct PsdFile {
  int width = 0;
  int height = 0;
  int depth = 8;                 ///< bits of a value: 8 or 16
  int colors = 3;                ///< 3: RGB, 1: grey
  int channels = 3;              ///< of the flattened picture
  std::vector<PsdLayer> layers;  ///< from the back to the front; a group's end comes before it
  ByteView merged;               ///< the flattened picture, packed
  bool has_merged = true;        ///< that picture shows the layers
  bool merged_alpha = false;     ///< its first channel behind the colours is transparency
};

/// Returns whether the bytes begin like a Photoshop document.
bool is_psd(ByteView bytes);

/// Reads everything but pixels; `bytes` must outlive the result. Follows "Adobe Photoshop File
/// Formats Specification". Errors: `bad_input` for other colour modes and depths, large documents
/// (PSB) and damage; `limit`. Linear in the size of the records.
Result<PsdFile> read_psd_file(ByteView bytes, const ImageLimits& limits);

/// Unpacks one plane of a layer: width x height values, those of 16 bits rounded to 8. `data`
/// begins with its packing: raw, PackBits, or zlib with or without differences along rows. `depth`:
/// 8 or
/// 16. Error: `bad_input` where the data is damaged. Memory: the plane alone, for any data.
Result<std::vector<uint8_t>> decode_channel(ByteView data, int width, int height, int depth);

/// Unpacks the planes of the flattened picture at the end of the file, which are packed together.
Result<std::vector<std::vector<uint8_t>>> decode_merged(ByteView data, int planes, int width,
                                                        int height, int depth);

/// Takes numbers, most significant byte first, from the front of some bytes. Bytes beyond their end
/// are 0.
class BigEndian {
 public:
  explicit BigEndian(ByteView bytes) : left_(bytes) {}

  uint64_t take(size_t bytes) {
    uint64_t value = 0;
    for (size_t k = 0; k < bytes; ++k) {
      value <<= 8;
      if (k < left_.size()) value |= left_[k];
    }
    skip(bytes);
    return value;
  }

  uint8_t u8() { return static_cast<uint8_t>(take(1)); }
  uint16_t u16() { return static_cast<uint16_t>(take(2)); }
  int16_t i16() { return static_cast<int16_t>(take(2)); }
  uint32_t u32() { return static_cast<uint32_t>(take(4)); }
  int32_t i32() { return static_cast<int32_t>(take(4)); }

  ByteView bytes(uint64_t count) {
    const ByteView taken = left_.first(within(count));
    skip(count);
    return taken;
  }

  void skip(uint64_t count) {
    beyond_ |= count > left_.size();
    left_ = left_.subspan(within(count));
  }

  size_t left() const { return left_.size(); }

  /// Returns whether more bytes were taken than there were.
  bool beyond() const { return beyond_; }

 private:
  size_t within(uint64_t count) const {
    return count < left_.size() ? static_cast<size_t>(count) : left_.size();
  }

  ByteView left_;
  bool beyond_ = false;
};

}  // namespace relievo
