#pragma once

#include <cstdint>
#include <pugixml.hpp>

#include "io/image/image_limits.h"
#include "kernel/geometry/region.h"
#include "kernel/image/color.h"
#include "kernel/image/image_size.h"
#include "relievo/result.h"

namespace relievo {

/// A picture that an <image> embeds.
struct SvgPicture {
  ImageSize size;          ///< px
  Region opaque;           ///< where its alpha is at least one half, in px of the picture
  Color color;             ///< mean; grey where the pixels are not looked at
  bool outlined = false;   ///< a line of another colour runs along its outline
  bool has_holes = false;  ///< some of it is not opaque
};

/// Limits of a picture inside a drawing.
constexpr ImageLimits embedded_limits = {25'000'000, 25'000'000};

/// Most pixels of all pictures of a drawing together.
constexpr int64_t max_picture_pixels = 100'000'000;

/// Returns the size of the PNG or JPEG file that the <image> embeds in a data: reference, by its
/// header alone. Errors: `bad_input` where it embeds none, `limit`.
Result<ImageSize> embedded_size(const pugi::xml_node& image);

/// Makes the reference of an <image> state the type that its embedded file has. Precondition:
/// embedded_size succeeds.
void state_media_type(pugi::xml_node image);

/// Reads the picture that the <image> embeds. A JPEG picture is opaque, so its pixels are not
/// looked at. Errors: as embedded_size, and `bad_input` where the picture is damaged. O(pixels).
Result<SvgPicture> embedded_picture(const pugi::xml_node& image);

}  // namespace relievo
