#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::cli {

/// One picture of a sheet, which may have lost its empty margins there.
struct Sprite {
  std::string name;
  int x = 0;  ///< of its upper left corner on the sheet, px
  int y = 0;
  ImageSize size;        ///< as drawn, before it is turned
  bool rotated = false;  ///< turned clockwise by 90 degrees on the sheet
  int left = 0;          ///< of its corner in the whole picture
  int top = 0;
  ImageSize whole;  ///< with its margins
};

struct SpriteSheet {
  std::string picture;  ///< the file, relative to the sheet's own; may be empty
  std::vector<Sprite> sprites;
};

/// Reads the JSON that Aseprite and TexturePacker write, with frames in a list or by name. Errors:
/// `bad_input` naming the value, `limit` above 10,000 sprites.
Result<SpriteSheet> read_sprite_sheet(std::string_view json);

/// The cells of a sheet row by row, called 0, 1, ...
SpriteSheet grid_sheet(ImageSize cell, int columns, int count);

/// A sheet as JSON that Aseprite, TexturePacker and game engines' importers read.
std::string write_sprite_sheet(const SpriteSheet& sheet, ImageSize size);

/// The extent of all sprites on their sheet.
ImageSize extent(const SpriteSheet& sheet);

/// Pixel of the sheet where pixel (x, y) of the sprite as drawn lies.
struct SheetPixel {
  int x;
  int y;
};
inline SheetPixel on_sheet(const Sprite& sprite, int x, int y) {
  return sprite.rotated ? SheetPixel{sprite.x + sprite.size.height - 1 - y, sprite.y + x}
                        : SheetPixel{sprite.x + x, sprite.y + y};
}

/// The whole picture of a sprite. Precondition: it lies on the sheet.
template <class T>
Image<T> cut_sprite(const Image<T>& sheet, const Sprite& sprite) {
  Image<T> picture(sprite.whole.width, sprite.whole.height, sheet.channels);
  for (int y = 0; y < sprite.size.height; ++y)
    for (int x = 0; x < sprite.size.width; ++x) {
      const SheetPixel at = on_sheet(sprite, x, y);
      for (int c = 0; c < sheet.channels; ++c)
        picture.at(sprite.left + x, sprite.top + y, c) = sheet.at(at.x, at.y, c);
    }
  return picture;
}

/// Puts what a sheet has of a picture, whose size is that of the whole sprite, in its place.
template <class T>
void put_sprite(const Image<T>& picture, const Sprite& sprite, Image<T>& sheet) {
  for (int y = 0; y < sprite.size.height; ++y)
    for (int x = 0; x < sprite.size.width; ++x) {
      const SheetPixel at = on_sheet(sprite, x, y);
      for (int c = 0; c < sheet.channels; ++c)
        sheet.at(at.x, at.y, c) = picture.at(sprite.left + x, sprite.top + y, c);
    }
}

}  // namespace relievo::cli
