#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/image/image_size.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo::cli {

/// A picture on a sheet. Its empty margins may be trimmed there.
struct Sprite {
  std::string name;
  int x = 0;  ///< upper left corner on the sheet, px
  int y = 0;
  ImageSize size;        ///< without its margins, before rotation
  bool rotated = false;  ///< rotated clockwise by 90 degrees on the sheet
  int left = 0;          ///< its upper left corner within its margins
  int top = 0;
  ImageSize whole;  ///< with its margins
};

struct SpriteSheet {
  std::string picture;  ///< file, relative to that of the sheet; may be empty
  std::vector<Sprite> sprites;
};

/// Reads the JSON of Aseprite, TexturePacker and Phaser, with frames in a list or by name. Errors:
/// `bad_input` with the place of the value, also where the sprites lie on several pictures or are
/// the layers of frames, and `limit` above 10,000 sprites.
Result<SpriteSheet> read_sprite_sheet(std::string_view json);

/// Divides a sheet into cells, row by row, named 0, 1, ...
SpriteSheet grid_sheet(ImageSize cell, int columns, int count);

/// Writes a sheet as JSON that Aseprite, TexturePacker and game engines can read.
std::string write_sprite_sheet(const SpriteSheet& sheet, ImageSize size);

/// Returns the size of the sheet up to the last sprite.
ImageSize extent(const SpriteSheet& sheet);

/// Calls visit(x, y, sheet_x, sheet_y) for each pixel of a sprite, before rotation, and its place
/// on the sheet.
template <class Visit>
void for_each_pixel(const Sprite& sprite, Visit visit) {
  for (int y = 0; y < sprite.size.height; ++y)
    for (int x = 0; x < sprite.size.width; ++x) {
      if (sprite.rotated)
        visit(x, y, sprite.x + sprite.size.height - 1 - y, sprite.y + x);
      else
        visit(x, y, sprite.x + x, sprite.y + y);
    }
}

/// Cuts a sprite out of a sheet, with its margins. Precondition: it lies on the sheet.
template <class T>
Image<T> cut_sprite(const Image<T>& sheet, const Sprite& sprite) {
  Image<T> picture(sprite.whole.width, sprite.whole.height, sheet.channels);
  for_each_pixel(sprite, [&](int x, int y, int sheet_x, int sheet_y) {
    for (int c = 0; c < sheet.channels; ++c)
      picture.at(sprite.left + x, sprite.top + y, c) = sheet.at(sheet_x, sheet_y, c);
  });
  return picture;
}

/// Puts a picture, of the size of a sprite with its margins, in the sprite's place on a sheet.
template <class T>
void put_sprite(const Image<T>& picture, const Sprite& sprite, Image<T>& sheet) {
  for_each_pixel(sprite, [&](int x, int y, int sheet_x, int sheet_y) {
    for (int c = 0; c < sheet.channels; ++c)
      sheet.at(sheet_x, sheet_y, c) = picture.at(sprite.left + x, sprite.top + y, c);
  });
}

}  // namespace relievo::cli
