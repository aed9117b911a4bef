#include "io/image/webp.h"

#include <webp/decode.h>
#include <webp/demux.h>

#include <cstddef>
#include <cstring>
#include <memory>

#include "io/image/orientation.h"
#include "io/image/row_average.h"

namespace relievo {
namespace {

/// Frees what libwebp hands out.
struct ReleaseWebp {
  void operator()(WebPDemuxer* demuxer) const { WebPDemuxDelete(demuxer); }
  void operator()(WebPAnimDecoder* decoder) const { WebPAnimDecoderDelete(decoder); }
};

using Demuxer = std::unique_ptr<WebPDemuxer, ReleaseWebp>;

Error damaged_webp() { return damaged_image("WebP", "it ends early, or its data is wrong"); }

Demuxer open_webp(ByteView bytes) {
  const WebPData data = {bytes.data(), bytes.size()};
  return Demuxer(WebPDemux(&data));
}

int orientation_of(const WebPDemuxer* demuxer) {
  WebPChunkIterator chunk;
  if (WebPDemuxGetChunk(demuxer, "EXIF", 1, &chunk) == 0) return 1;
  const int orientation = exif_orientation({chunk.chunk.bytes, chunk.chunk.size});
  WebPDemuxReleaseChunkIterator(&chunk);
  return orientation;
}

Result<ImageSize> size_of(const WebPDemuxer* demuxer, const ImageLimits& limits) {
  const auto width = static_cast<int>(WebPDemuxGetI(demuxer, WEBP_FF_CANVAS_WIDTH));
  const auto height = static_cast<int>(WebPDemuxGetI(demuxer, WEBP_FF_CANVAS_HEIGHT));
  if (Status size = check_image_size(width, height, limits); !size) return size.error();
  return ImageSize{width, height};
}

/// Copies a frame, or reduces it.
Image8 frame_of(const uint8_t* rgba, const ImageSize& size, int factor) {
  RowAverage average(size.width, size.height, factor);
  for (int y = 0; y < size.height; ++y) average.add(rgba + ptrdiff_t{4} * size.width * y);
  return average.take();
}

/// Decodes at most so many frames.
Result<std::vector<Image8>> decode_some(ByteView bytes, size_t most, const ImageLimits& limits,
                                        int factor) {
  const Demuxer demuxer = open_webp(bytes);
  if (!demuxer) return damaged_webp();
  const auto size = size_of(demuxer.get(), limits);
  if (!size) return size.error();
  WebPAnimDecoderOptions options;
  if (WebPAnimDecoderOptionsInit(&options) == 0)
    return Error{ErrorCode::internal, "libwebp has another version", ""};
  options.color_mode = MODE_RGBA;
  const WebPData data = {bytes.data(), bytes.size()};
  const std::unique_ptr<WebPAnimDecoder, ReleaseWebp> decoder(WebPAnimDecoderNew(&data, &options));
  if (!decoder) return damaged_webp();
  const int orientation = orientation_of(demuxer.get());
  std::vector<Image8> frames;
  while (frames.size() < most && WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
    uint8_t* rgba = nullptr;
    int time = 0;
    if (WebPAnimDecoderGetNext(decoder.get(), &rgba, &time) == 0) return damaged_webp();
    frames.push_back(upright(frame_of(rgba, *size, factor), orientation));
  }
  if (frames.empty()) return damaged_webp();
  return frames;
}

}  // namespace

bool is_webp(ByteView bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

Result<ImageSize> webp_size(ByteView bytes, const ImageLimits& limits) {
  const Demuxer demuxer = open_webp(bytes);
  if (!demuxer) return damaged_webp();
  return size_of(demuxer.get(), limits);
}

Result<Image8> decode_webp(ByteView bytes, const ImageLimits& limits, int factor) {
  auto frames = decode_some(bytes, 1, limits, factor);
  if (!frames) return frames.error();
  return std::move(frames->front());
}

size_t webp_frame_count(ByteView bytes) {
  const Demuxer demuxer = open_webp(bytes);
  return demuxer ? WebPDemuxGetI(demuxer.get(), WEBP_FF_FRAME_COUNT) : 0;
}

Result<std::vector<Image8>> decode_webp_frames(ByteView bytes, const ImageLimits& limits) {
  return decode_some(bytes, SIZE_MAX, limits, 1);
}

}  // namespace relievo
