#include "io/image/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>

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

  /// Returns the empty canvas.
  Result<Image8> canvas(const ImageLimits& limits) const {
    if (gif_ == nullptr) return damaged_image("GIF", reason());
    if (Status size = check_image_size(gif_->SWidth, gif_->SHeight, limits); !size)
      return size.error();
    if (int64_t{gif_->SWidth} * gif_->SHeight / most_pixels_per_byte > size_)
      return damaged_image("GIF", "it ends early");
    return Image8(gif_->SWidth, gif_->SHeight, 4);
  }

  /// Reads on to the next picture; false where none follows. Precondition: there is a canvas.
  Result<bool> find_picture() {
    for (;;) {
      // Many files lack the mark of their end.
      if (rest_.empty() && pictures_ > 0) return false;
      GifRecordType record = UNDEFINED_RECORD_TYPE;
      if (DGifGetRecordType(gif_, &record) == GIF_ERROR) return damaged_image("GIF", reason());
      if (record == TERMINATE_RECORD_TYPE) return false;
      if (record == EXTENSION_RECORD_TYPE && !read_extension())
        return damaged_image("GIF", reason());
      if (record != IMAGE_DESC_RECORD_TYPE) continue;
      if (DGifGetImageDesc(gif_) == GIF_ERROR) return damaged_image("GIF", reason());
      ++pictures_;
      return true;
    }
  }

  /// Passes over the pixels of the picture that was found.
  bool skip_pixels() {
    int size = 0;
    GifByteType* block = nullptr;
    if (DGifGetCode(gif_, &size, &block) == GIF_ERROR) return false;
    while (block != nullptr)
      if (DGifGetCodeNext(gif_, &block) == GIF_ERROR) return false;
    return true;
  }

  /// Paints the picture that was found over the canvas, on which the earlier ones are.
  Status paint_picture(Image8& canvas) {
    const GifImageDesc& at = gif_->Image;
    const ColorMapObject* colors = at.ColorMap != nullptr ? at.ColorMap : gif_->SColorMap;
    if (colors == nullptr) return damaged_image("GIF", "it has no colours");
    if (at.Left < 0 || at.Top < 0 || at.Width <= 0 || at.Height <= 0 ||
        at.Left + at.Width > gif_->SWidth || at.Top + at.Height > gif_->SHeight)
      return damaged_image("GIF", "its picture lies outside its canvas");
    std::vector<GifPixelType> line(static_cast<size_t>(at.Width));
    for (const int y : row_order(at)) {
      if (DGifGetLine(gif_, line.data(), at.Width) == GIF_ERROR)
        return damaged_image("GIF", reason());
      if (!paint(line, *colors, &canvas.at(at.Left, at.Top + y)))
        return damaged_image("GIF", "a pixel has no colour");
    }
    return Done{};
  }

  /// Removes the picture, painted last, from the canvas where the file asks for it. `before` is the
  /// canvas without it.
  void dispose(const Image8& before, Image8& canvas) const {
    if (disposal_ == DISPOSE_PREVIOUS) canvas = before;
    if (disposal_ != DISPOSE_BACKGROUND) return;
    const GifImageDesc& at = gif_->Image;
    for (int y = at.Top; y < at.Top + at.Height; ++y)
      std::fill_n(&canvas.at(at.Left, y), size_t{4} * at.Width, uint8_t{0});
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
          DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK) {
        transparent_ = control.TransparentColor;
        disposal_ = control.DisposalMode;
      }
      if (DGifGetExtensionNext(gif_, &block) == GIF_ERROR) return false;
    }
    return true;
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
      // A transparent pixel keeps what is below it.
      if (alpha == 255 || out[3] == 0) {
        const std::array<uint8_t, 4> rgba = {color.Red, color.Green, color.Blue, alpha};
        std::copy(rgba.begin(), rgba.end(), out);
      }
      out += 4;
    }
    return true;
  }

  ByteView rest_;
  int64_t size_;
  int error_ = 0;
  GifFileType* gif_ = nullptr;
  size_t pictures_ = 0;
  int transparent_ = NO_TRANSPARENT_COLOR;
  int disposal_ = DISPOSAL_UNSPECIFIED;
};

}  // namespace

bool is_gif(ByteView bytes) {
  return bytes.size() >= 6 && std::memcmp(bytes.data(), "GIF8", 4) == 0 &&
         (bytes[4] == '7' || bytes[4] == '9') && bytes[5] == 'a';
}

Result<ImageSize> gif_size(ByteView bytes, const ImageLimits& limits) {
  constexpr size_t header_end = 10;
  if (bytes.size() < header_end) return damaged_image("GIF", "it ends early");
  const ImageSize size{bytes[6] | bytes[7] << 8, bytes[8] | bytes[9] << 8};
  if (Status status = check_image_size(size.width, size.height, limits); !status)
    return status.error();
  return size;
}

Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits) {
  if (!is_gif(bytes)) return damaged_image("GIF", "it does not begin with the GIF signature");
  GifReader reader(bytes);
  auto canvas = reader.canvas(limits);
  if (!canvas) return canvas;
  const auto found = reader.find_picture();
  if (!found) return found.error();
  if (!*found) return damaged_image("GIF", "it holds no picture");
  if (Status status = reader.paint_picture(*canvas); !status) return status.error();
  return canvas;
}

size_t gif_frame_count(ByteView bytes) {
  if (!is_gif(bytes)) return 0;
  GifReader reader(bytes);
  if (!reader.canvas({})) return 0;
  for (size_t count = 0;; ++count) {
    const auto found = reader.find_picture();
    if (!found || !*found || !reader.skip_pixels()) return count;
  }
}

Result<std::vector<Image8>> decode_gif_frames(ByteView bytes, const ImageLimits& limits) {
  if (!is_gif(bytes)) return damaged_image("GIF", "it does not begin with the GIF signature");
  GifReader reader(bytes);
  auto canvas = reader.canvas(limits);
  if (!canvas) return canvas.error();
  std::vector<Image8> frames;
  for (;;) {
    const auto found = reader.find_picture();
    if (!found) return found.error();
    if (!*found) break;
    const Image8 before = *canvas;
    if (Status status = reader.paint_picture(*canvas); !status) return status.error();
    frames.push_back(*canvas);
    reader.dispose(before, *canvas);
  }
  if (frames.empty()) return damaged_image("GIF", "it holds no picture");
  return frames;
}

}  // namespace relievo
