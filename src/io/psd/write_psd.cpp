#include "io/psd/write_psd.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <pugixml.hpp>

#include "io/files/byte_writer.h"
#include "io/psd/psd_file.h"
#include "kernel/image/compose.h"
#include "relief/finish/paint_layers.h"

namespace relievo {
namespace {

constexpr int max_side = 30000;

/// Append a number, most significant byte first.
void put16(Bytes& bytes, uint32_t value) {
  bytes.push_back(static_cast<uint8_t>(value >> 8 & 0xff));
  bytes.push_back(static_cast<uint8_t>(value & 0xff));
}
void put32(Bytes& bytes, size_t value) {
  put16(bytes, static_cast<uint32_t>(value >> 16 & 0xffff));
  put16(bytes, static_cast<uint32_t>(value & 0xffff));
}

void append(Bytes& bytes, const Bytes& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

/// Appends the length of a block and the block.
void put_block(Bytes& bytes, const Bytes& block) {
  put32(bytes, block.size());
  append(bytes, block);
}

/// Packs one row by PackBits: three and more equal values as a run, others as they are.
void pack_row(const std::vector<uint8_t>& row, Bytes& packed) {
  const auto run_at = [&](size_t i) {
    size_t end = i + 1;
    while (end < row.size() && end - i < 128 && row[end] == row[i]) ++end;
    return end - i;
  };
  for (size_t i = 0; i < row.size();) {
    const size_t run = run_at(i);
    if (run >= 3) {
      packed.push_back(static_cast<uint8_t>(257 - run));
      packed.push_back(row[i]);
      i += run;
      continue;
    }
    size_t end = i;
    while (end < row.size() && end - i < 128 && run_at(end) < 3) ++end;
    packed.push_back(static_cast<uint8_t>(end - i - 1));
    packed.insert(packed.end(), row.begin() + static_cast<std::ptrdiff_t>(i),
                  row.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
}

/// Packs the rows of a channel inside a box: appends their packed lengths to `lengths` and the
/// packed rows to `rows`.
void pack(const Image8& rgba, int channel, const PixelBox& box, Bytes& lengths, Bytes& rows) {
  std::vector<uint8_t> row(static_cast<size_t>(box.width()));
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) row[x - box.left] = rgba.at(x, y, channel);
    const size_t before = rows.size();
    pack_row(row, rows);
    put16(lengths, static_cast<uint32_t>(rows.size() - before));
  }
}

PixelBox opaque_box(const Image8& rgba) {
  PixelBox box{rgba.width, rgba.height, 0, 0};
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x) {
      if (rgba.at(x, y, 3) == 0) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
             std::max(box.bottom, y + 1)};
    }
  return box.empty() ? PixelBox{} : box;
}

/// Returns UTF-8 as counted UTF-16, without invalid bytes.
Bytes unicode_name(const std::string& name) {
  std::vector<uint32_t> units;
  for (const wchar_t character : pugi::as_wide(name)) {
    auto code = static_cast<uint32_t>(character);
    if (code >= 0x10000) {
      units.push_back(0xd800 + ((code - 0x10000) >> 10 & 0x3ff));
      code = 0xdc00 + ((code - 0x10000) & 0x3ff);
    }
    units.push_back(code);
  }
  Bytes bytes;
  put32(bytes, units.size());
  for (const uint32_t unit : units) put16(bytes, unit);
  if (bytes.size() % 4 != 0) put16(bytes, 0);
  return bytes;
}

/// Returns the fields of a record behind the fixed ones: no mask, no blending ranges, both names.
Bytes extra_of(const std::string& name) {
  Bytes extra;
  put32(extra, 0);
  put32(extra, 0);
  std::string plain;
  for (const char c : name.substr(0, 255)) plain += static_cast<uint8_t>(c) < 0x80 ? c : '?';
  extra.push_back(static_cast<uint8_t>(plain.size()));
  append_text(extra, plain);
  while (extra.size() % 4 != 0) extra.push_back(0);
  append_text(extra, "8BIMluni");
  put_block(extra, unicode_name(name));
  return extra;
}

constexpr std::array<int, 4> channels = {-1, 0, 1, 2};  // as in PsdChannel

void put_layer(const PsdPicture& layer, Bytes& records, Bytes& pixels) {
  const PixelBox box = opaque_box(*layer.rgba);
  for (const int side :
       {layer.top + box.top, layer.left + box.left, layer.top + box.bottom, layer.left + box.right})
    put32(records, static_cast<size_t>(side));
  put16(records, channels.size());
  for (const int channel : channels) {
    Bytes lengths;
    Bytes rows;
    pack(*layer.rgba, channel < 0 ? 3 : channel, box, lengths, rows);
    put16(records, static_cast<uint16_t>(channel));
    put32(records, 2 + lengths.size() + rows.size());
    put16(pixels, 1);
    append(pixels, lengths);
    append(pixels, rows);
  }
  append_text(records, "8BIMnorm");
  records.push_back(255);
  records.push_back(0);
  records.push_back(layer.hidden ? 2 : 0);
  records.push_back(0);
  put_block(records, extra_of(layer.name));
}

Bytes layer_section(const std::vector<PsdPicture>& layers) {
  Bytes info;
  // Negative: the first channel behind the colours of the flattened picture is its alpha.
  put16(info, static_cast<uint16_t>(-static_cast<int>(layers.size())));
  Bytes pixels;
  for (const PsdPicture& layer : layers) put_layer(layer, info, pixels);
  append(info, pixels);
  while (info.size() % 4 != 0) info.push_back(0);
  Bytes section;
  put_block(section, info);
  put32(section, 0);  // no global mask
  return section;
}

void put_merged(const std::vector<PsdPicture>& layers, int width, int height, Bytes& bytes) {
  Image8 merged(width, height, 4);
  for (const PsdPicture& layer : layers)
    if (!layer.hidden) lay_picture_over(merged, layer.left, layer.top, *layer.rgba);
  Bytes lengths;
  Bytes rows;
  for (const int channel : {0, 1, 2, 3})
    pack(merged, channel, {0, 0, width, height}, lengths, rows);
  put16(bytes, 1);
  append(bytes, lengths);
  append(bytes, rows);
}

}  // namespace

Result<Bytes> encode_psd(const std::vector<PsdPicture>& layers, int width, int height) {
  if (width > max_side || height > max_side)
    return Error{ErrorCode::limit,
                 "a Photoshop document has at most 30,000 px a side; make the drawing smaller", ""};
  Bytes bytes;
  append_text(bytes, "8BPS");
  put16(bytes, 1);
  put32(bytes, 0);
  put16(bytes, 0);
  put16(bytes, 4);
  put32(bytes, static_cast<size_t>(height));
  put32(bytes, static_cast<size_t>(width));
  put16(bytes, 8);
  put16(bytes, 3);
  put32(bytes, 0);  // no palette
  put32(bytes, 0);  // no resources
  put_block(bytes, layer_section(layers));
  put_merged(layers, width, height, bytes);
  return bytes;
}

Result<Bytes> encode_part_layers(const Scene& scene, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  const std::vector<relief::PaintedLayer> parts = relief::paint_layers(scene, drawing);
  std::vector<PsdPicture> layers = {{"drawing", &rgba, 0, 0, true}};
  for (const relief::PaintedLayer& part : parts)
    layers.push_back({"part:" + part.name, &part.rgba, part.left, part.top});
  return encode_psd(layers, rgba.width, rgba.height);
}

}  // namespace relievo
