#include "io/image/gif_decode.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "io/image/image_limits.h"

namespace relievo {
namespace {

/// A code of 12 bits stands for at most 4096 pixels: 4096 / 1.5.
constexpr int64_t most_pixels_per_byte = 2731;

int read_bytes(GifFileType* gif, GifByteType* out, int count) {
  auto* rest = static_cast<ByteView*>(gif->UserData);
  const size_t available = std::min(rest->size(), static_cast<size_t>(count));
  std::memcpy(out, rest->data(), available);
  *rest = rest->subspan(available);
  return static_cast<int>(available);
}

class GifReader {
 public:
  explicit GifReader(ByteView bytes) : rest_(bytes), size_(static_cast<int64_t>(bytes.size())) {
    gif_ = DGifOpen(&rest_, read_bytes, &error_);
  }
  GifReader(const GifReader&) = delete;
  GifReader& operator=(const GifReader&) = delete;
  ~GifReader() {
    if (gif_ != nullptr) DGifCloseFile(gif_, &error_);
  }

  Result<Image8> read(const ImageLimits& limits) {
    if (gif_ == nullptr) return damaged_image("GIF", reason());
    if (Status size = check_image_size(gif_->SWidth, gif_->SHeight, limits); !size)
      return size.error();
    if (int64_t{gif_->SWidth} * gif_->SHeight / most_pixels_per_byte > size_)
      return damaged_image("GIF", "it ends early");
    for (;;) {
      GifRecordType record = UNDEFINED_RECORD_TYPE;
      if (DGifGetRecordType(gif_, &record) == GIF_ERROR) return damaged_image("GIF", reason());
      if (record == TERMINATE_RECORD_TYPE) return damaged_image("GIF", "it holds no picture");
      if (record == IMAGE_DESC_RECORD_TYPE) return read_picture();
      if (record == EXTENSION_RECORD_TYPE && !read_extension())
        return damaged_image("GIF", reason());
    }
  }

 private:
  std::string reason() const {
    const char* text = GifErrorString(gif_ != nullptr ? gif_->Error : error_);
    return text != nullptr ? text : "it ends early";
  }

  bool read_extension() {
    int code = 0;
    GifByteType* block = nullptr;
    if (DGifGetExtension(gif_, &code, &block) == GIF_ERROR) return false;
    while (block != nullptr) {
      GraphicsControlBlock control;
      if (code == GRAPHICS_EXT_FUNC_CODE &&
          DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
        transparent_ = control.TransparentColor;
      if (DGifGetExtensionNext(gif_, &block) == GIF_ERROR) return false;
    }
    return true;
  }

  Result<Image8> read_picture() {
    if (DGifGetImageDesc(gif_) == GIF_ERROR) return damaged_image("GIF", reason());
    const GifImageDesc& at = gif_->Image;
    const ColorMapObject* colors = at.ColorMap != nullptr ? at.ColorMap : gif_->SColorMap;
    if (colors == nullptr) return damaged_image("GIF", "it has no colours");
    if (at.Left < 0 || at.Top < 0 || at.Width <= 0 || at.Height <= 0 ||
        at.Left + at.Width > gif_->SWidth || at.Top + at.Height > gif_->SHeight)
      return damaged_image("GIF", "its picture lies outside its canvas");
    Image8 image(gif_->SWidth, gif_->SHeight, 4);
    std::vector<GifPixelType> line(static_cast<size_t>(at.Width));
    for (const int y : row_order(at)) {
      if (DGifGetLine(gif_, line.data(), at.Width) == GIF_ERROR)
        return damaged_image("GIF", reason());
      if (!paint(line, *colors, &image.at(at.Left, at.Top + y)))
        return damaged_image("GIF", "a pixel has no colour");
    }
    return image;
  }

  static std::vector<int> row_order(const GifImageDesc& at) {
    constexpr std::array<std::array<int, 2>, 4> passes = {{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    std::vector<int> rows;
    if (at.Interlace)
      for (const auto& [first, step] : passes)
        for (int y = first; y < at.Height; y += step) rows.push_back(y);
    else
      for (int y = 0; y < at.Height; ++y) rows.push_back(y);
    return rows;
  }

  bool paint(const std::vector<GifPixelType>& line, const ColorMapObject& colors,
             uint8_t* out) const {
    for (const GifPixelType index : line) {
      if (index >= colors.ColorCount) return false;
      const GifColorType& color = colors.Colors[index];
      const uint8_t alpha = index == transparent_ ? 0 : 255;
      for (const uint8_t value : {color.Red, color.Green, color.Blue, alpha}) *out++ = value;
    }
    return true;
  }

  ByteView rest_;
  int64_t size_;
  int error_ = 0;
  GifFileType* gif_ = nullptr;
  int transparent_ = NO_TRANSPARENT_COLOR;
};

}  // namespace

bool is_gif(ByteView bytes) {
  return bytes.size() >= 6 && std::memcmp(bytes.data(), "GIF8", 4) == 0 &&
         (bytes[4] == '7' || bytes[4] == '9') && bytes[5] == 'a';
}

Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits) {
  if (!is_gif(bytes)) return damaged_image("GIF", "it does not begin with the GIF signature");
  return GifReader(bytes).read(limits);
}

}  // namespace relievo
