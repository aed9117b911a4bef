#include "io/psd/psd_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <pugixml.hpp>
#include <string_view>

#include "io/layered/layer_files.h"

namespace relievo {
namespace {

constexpr int grey_mode = 1;
constexpr int rgb_mode = 3;

Error bad(const std::string& message) { return {ErrorCode::bad_input, message, ""}; }
Error damaged() { return bad("is damaged: it ends early, or its layers have impossible sizes"); }

std::string_view text_of(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

PixelBox take_box(BigEndian& data) {
  PixelBox box;
  box.top = data.i32();
  box.left = data.i32();
  box.bottom = data.i32();
  box.right = data.i32();
  return box;
}

Status check_box(const PixelBox& box, const ImageLimits& limits) {
  constexpr int farthest = 1'000'000;
  for (const int side : {box.top, box.left, box.bottom, box.right})
    if (side < -farthest || side > farthest) return damaged();
  if (box.empty()) return Done{};
  return check_image_size(box.width(), box.height(), limits);
}

/// Takes a counted string of UTF-16 as UTF-8.
std::string take_unicode(BigEndian data) {
  std::wstring text;
  const uint32_t count = data.u32();
  for (uint32_t k = 0; k < count && data.left() >= 2; ++k) {
    uint32_t code = data.u16();
    if (code >= 0xd800 && code < 0xdc00 && data.left() >= 2) {
      code = 0x10000 + ((code - 0xd800) << 10) + (data.u16() - 0xdc00u);
      ++k;
    }
    if (code != 0 && code < 0x110000) text += static_cast<wchar_t>(code);
  }
  return pugi::as_utf8(text);
}

/// Returns whether a key belongs to layers without pixels of their own.
bool is_adjustment(std::string_view key) {
  static constexpr std::array<std::string_view, 21> keys = {
      "brit", "levl", "curv", "expA", "vibA", "hue ", "hue2", "blnc", "blwh", "phfl", "mixr",
      "clrL", "nvrt", "post", "thrs", "grdm", "selc", "CgEd", "SoCo", "GdFl", "PtFl"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void read_block(std::string_view key, ByteView block, PsdLayer& layer) {
  BigEndian data(block);
  if (key == "luni") layer.name = take_unicode(data);
  if (key == "lsct" || key == "lsdk") {
    const uint32_t type = data.u32();
    if (type == 1 || type == 2) layer.kind = PsdKind::group;
    if (type == 3) layer.kind = PsdKind::group_end;
    if (block.size() >= 12 && layer.kind == PsdKind::group) {
      data.skip(4);
      std::memcpy(layer.blend.data(), data.bytes(4).data(), 4);
    }
  }
  if (key == "iOpa") layer.opacity *= data.u8() / 255.0;
  layer.adjusts |= is_adjustment(key);
  layer.has_effects |= key == "lfx2" || key == "lrFX" || key == "lmfx";
  layer.is_artboard |= key == "artb" || key == "artd" || key == "abdd";
  if (key == "SoCo") layer.solid_fill = block;
  if (key == "vmsk" || key == "vsms") layer.vector_mask = block;
}

std::optional<PsdMask> take_mask(ByteView block) {
  if (block.size() < 18) return std::nullopt;
  BigEndian data(block);
  PsdMask mask;
  mask.box = take_box(data);
  mask.outside = data.u8();
  const uint8_t flags = data.u8();
  mask.disabled = (flags & 2) != 0;
  mask.rendered = (flags & 8) != 0;
  return mask;
}

/// Reads the part of a record behind its fixed fields.
void read_extra(BigEndian extra, PsdLayer& layer) {
  layer.mask = take_mask(extra.bytes(extra.u32()));
  extra.skip(extra.u32());  // blending ranges
  const uint8_t length = extra.u8();
  layer.name = std::string(text_of(extra.bytes(length)));
  extra.skip((4 - (length + 1) % 4) % 4);
  while (extra.left() >= 12) {
    const std::string_view mark = text_of(extra.bytes(4));
    if (mark != "8BIM" && mark != "8B64") return;
    const std::string_view key = text_of(extra.bytes(4));
    const uint32_t size = extra.u32();
    read_block(key, extra.bytes(size), layer);
    extra.skip(size % 2);
  }
}

/// Takes a record without its channels' data, whose lengths are added to `lengths`.
Result<PsdLayer> take_record(BigEndian& data, const ImageLimits& limits,
                             std::vector<uint32_t>& lengths) {
  PsdLayer layer;
  layer.box = take_box(data);
  if (Status status = check_box(layer.box, limits); !status) return status.error();
  const uint16_t channels = data.u16();
  if (channels > 56) return damaged();
  for (int k = 0; k < channels; ++k) {
    layer.channels.push_back({data.i16(), {}});
    lengths.push_back(data.u32());
  }
  if (text_of(data.bytes(4)) != "8BIM") return damaged();
  const ByteView blend = data.bytes(4);
  if (blend.size() < 4) return damaged();
  std::memcpy(layer.blend.data(), blend.data(), 4);
  layer.opacity = data.u8() / 255.0;
  layer.clipped = data.u8() != 0;
  layer.hidden = (data.u8() & 2) != 0;
  data.skip(1);
  read_extra(BigEndian(data.bytes(data.u32())), layer);
  if (layer.mask)
    if (Status status = check_box(layer.mask->box, limits); !status) return status.error();
  if (data.beyond()) return damaged();
  return layer;
}

Status read_layers(BigEndian data, const ImageLimits& limits, PsdFile& file) {
  if (data.left() < 2) return Done{};
  const int16_t stated = data.i16();
  const int count = std::abs(int{stated});
  file.merged_alpha = stated < 0 && file.channels > file.colors;
  // Each end of a group has a record of its own.
  if (count > 2 * static_cast<int>(max_layers))
    return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers", ""};
  std::vector<uint32_t> lengths;
  for (int k = 0; k < count; ++k) {
    auto layer = take_record(data, limits, lengths);
    if (!layer) return layer.error();
    file.layers.push_back(std::move(*layer));
  }
  auto length = lengths.begin();
  for (PsdLayer& layer : file.layers)
    for (PsdChannel& channel : layer.channels) channel.data = data.bytes(*length++);
  if (data.beyond()) return damaged();
  return Done{};
}

/// Reads whether the flattened picture shows the layers: programs may leave it out.
void read_resources(BigEndian data, PsdFile& file) {
  constexpr uint16_t version_info = 1057;
  while (data.left() >= 12 && text_of(data.bytes(4)) == "8BIM") {
    const uint16_t id = data.u16();
    const uint8_t length = data.u8();
    data.skip(length + (length + 1) % 2);
    const uint32_t size = data.u32();
    BigEndian resource(data.bytes(size));
    data.skip(size % 2);
    resource.skip(4);
    if (id == version_info) file.has_merged = resource.u8() != 0;
  }
}

/// Reads the layers; those of 16 bits stand in a block behind the others.
Status read_layer_section(BigEndian data, const ImageLimits& limits, PsdFile& file) {
  if (data.left() < 4) return Done{};
  const ByteView info = data.bytes(data.u32());
  if (info.size() > 2) return read_layers(BigEndian(info), limits, file);
  data.skip(data.u32());  // global mask
  while (data.left() >= 12) {
    const std::string_view mark = text_of(data.bytes(4));
    if (mark != "8BIM" && mark != "8B64") return Done{};
    const std::string_view key = text_of(data.bytes(4));
    const uint32_t size = data.u32();
    const ByteView block = data.bytes(size);
    data.skip((4 - size % 4) % 4);
    if (key == "Lr16" || key == "Layr") return read_layers(BigEndian(block), limits, file);
  }
  return Done{};
}

enum Packing : uint16_t { raw, pack_bits, zip, zip_differences };

Error does_not_unpack() {
  return {ErrorCode::bad_input, "is damaged: its pixels cannot be unpacked", ""};
}

/// Unpacks one row of PackBits.
bool unpack_row(ByteView packed, uint8_t* row, size_t size) {
  size_t made = 0;
  for (size_t k = 0; k < packed.size() && made < size;) {
    const auto head = static_cast<int8_t>(packed[k++]);
    if (head == -128) continue;
    const size_t count = head >= 0 ? size_t{1} + head : size_t{1} - head;
    if (made + count > size || k >= packed.size()) return false;
    if (head >= 0) {
      if (k + count > packed.size()) return false;
      std::copy_n(packed.begin() + static_cast<std::ptrdiff_t>(k), count, row + made);
      k += count;
    } else {
      std::fill_n(row + made, count, packed[k++]);
    }
    made += count;
  }
  return made == size;
}

/// Unpacks rows of PackBits, whose lengths come first.
bool unpack_rows(BigEndian& data, size_t rows, size_t row_bytes, std::vector<uint8_t>& bytes) {
  std::vector<uint16_t> lengths(rows);
  for (uint16_t& length : lengths) length = data.u16();
  for (size_t y = 0; y < rows; ++y)
    if (!unpack_row(data.bytes(lengths[y]), bytes.data() + y * row_bytes, row_bytes)) return false;
  return !data.beyond();
}

bool inflate_all(ByteView packed, std::vector<uint8_t>& bytes) {
  uLongf size = bytes.size();
  const int code = uncompress(bytes.data(), &size, packed.data(), packed.size());
  return (code == Z_OK || code == Z_BUF_ERROR) && size == bytes.size();
}

/// Sums the differences along every row, of 16-bit values where `depth` is 16.
void add_up(std::vector<uint8_t>& bytes, size_t row_bytes, int depth) {
  for (size_t at = 0; at + row_bytes <= bytes.size(); at += row_bytes) {
    uint8_t* row = bytes.data() + at;
    if (depth == 8) {
      for (size_t k = 1; k < row_bytes; ++k) row[k] = static_cast<uint8_t>(row[k] + row[k - 1]);
      continue;
    }
    for (size_t k = 2; k + 1 < row_bytes; k += 2) {
      const int before = row[k - 2] << 8 | row[k - 1];
      const int value = (row[k] << 8 | row[k + 1]) + before;
      row[k] = static_cast<uint8_t>(value >> 8);
      row[k + 1] = static_cast<uint8_t>(value);
    }
  }
}

/// Converts unpacked values to 8 bits.
std::vector<uint8_t> to_8_bit(std::vector<uint8_t> bytes, int depth) {
  if (depth == 8) return bytes;
  std::vector<uint8_t> values(bytes.size() / 2);
  for (size_t k = 0; k < values.size(); ++k) {
    const int value = bytes[2 * k] << 8 | bytes[2 * k + 1];
    values[k] = static_cast<uint8_t>((value + 128) / 257);
  }
  return values;
}

/// Unpacks the rows of all planes, one after the other.
Result<std::vector<uint8_t>> unpack(ByteView packed, size_t rows, size_t row_bytes, int depth) {
  BigEndian data(packed);
  const uint16_t packing = data.u16();
  // The best packing is that of zlib, of at most 1032 to 1.
  if (rows * row_bytes > 1100 * (packed.size() + 100)) return does_not_unpack();
  std::vector<uint8_t> bytes(rows * row_bytes);
  if (packing == raw) {
    const ByteView all = data.bytes(bytes.size());
    if (data.beyond()) return does_not_unpack();
    std::copy(all.begin(), all.end(), bytes.begin());
  } else if (packing == pack_bits) {
    if (!unpack_rows(data, rows, row_bytes, bytes)) return does_not_unpack();
  } else if (packing == zip || packing == zip_differences) {
    if (!inflate_all(data.bytes(data.left()), bytes)) return does_not_unpack();
    if (packing == zip_differences) add_up(bytes, row_bytes, depth);
  } else {
    return does_not_unpack();
  }
  return to_8_bit(std::move(bytes), depth);
}

}  // namespace

bool is_psd(ByteView bytes) { return bytes.size() >= 4 && text_of(bytes.subspan(0, 4)) == "8BPS"; }

Result<PsdFile> read_psd_file(ByteView bytes, const ImageLimits& limits) {
  BigEndian data(bytes);
  PsdFile file;
  data.skip(4);
  const uint16_t version = data.u16();
  if (version == 2) return bad("is a large document (PSB); save it as PSD");
  if (version != 1) return damaged();
  data.skip(6);
  file.channels = data.u16();
  file.height = data.i32();
  file.width = data.i32();
  file.depth = data.u16();
  const uint16_t mode = data.u16();
  if (Status size = check_image_size(file.width, file.height, limits); !size) return size.error();
  if (mode != rgb_mode && mode != grey_mode)
    return bad("is neither in RGB nor in grey; convert it to RGB");
  if (file.depth != 8 && file.depth != 16)
    return bad("has " + std::to_string(file.depth) + " bits a channel; convert it to 8 or 16");
  file.colors = mode == rgb_mode ? 3 : 1;
  if (file.channels < file.colors || file.channels > 56) return damaged();
  data.skip(data.u32());  // colour mode data
  read_resources(BigEndian(data.bytes(data.u32())), file);
  const ByteView layers = data.bytes(data.u32());
  if (data.beyond()) return damaged();
  if (Status status = read_layer_section(BigEndian(layers), limits, file); !status)
    return status.error();
  file.merged = data.bytes(data.left());
  return file;
}

Result<std::vector<uint8_t>> decode_channel(ByteView data, int width, int height, int depth) {
  return unpack(data, height, size_t(width) * depth / 8, depth);
}

Result<std::vector<std::vector<uint8_t>>> decode_merged(ByteView data, int planes, int width,
                                                        int height, int depth) {
  auto all = unpack(data, size_t(height) * planes, size_t(width) * depth / 8, depth);
  if (!all) return all.error();
  std::vector<std::vector<uint8_t>> split;
  const auto size = static_cast<std::ptrdiff_t>(width) * height;
  for (auto begin = all->begin(); begin != all->end(); begin += size)
    split.emplace_back(begin, begin + size);
  return split;
}

}  // namespace relievo
