#include "io/psd/psd_bytes.h"

#include <zlib.h>

namespace relievo {
namespace {

void put(Bytes& bytes, uint64_t value, int count) {
  for (int k = count - 1; k >= 0; --k) bytes.push_back(static_cast<uint8_t>(value >> (8 * k)));
}

void put(Bytes& bytes, const std::string& text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

/// With its length before it.
void put_block(Bytes& bytes, const Bytes& block) {
  put(bytes, block.size(), 4);
  bytes.insert(bytes.end(), block.begin(), block.end());
}

/// Runs of equal bytes, and single bytes.
Bytes packed_row(const uint8_t* row, size_t size) {
  Bytes packed;
  for (size_t k = 0; k < size;) {
    size_t run = 1;
    while (k + run < size && run < 128 && row[k + run] == row[k]) ++run;
    packed.push_back(static_cast<uint8_t>(run == 1 ? 0 : 257 - run));
    packed.push_back(row[k]);
    k += run;
  }
  return packed;
}

/// Values of the depth, row by row.
std::vector<Bytes> rows_of(const Image8& image, int channel, int depth) {
  std::vector<Bytes> rows(image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      put(rows[y], depth == 8 ? image.at(x, y, channel) : image.at(x, y, channel) * 257, depth / 8);
  return rows;
}

void take_differences(Bytes& row, int depth) {
  for (size_t k = row.size(); k-- > size_t(depth) / 8;) {
    if (depth == 8) {
      row[k] = static_cast<uint8_t>(row[k] - row[k - 1]);
    } else if (k % 2 == 1) {
      const int value = (row[k - 1] << 8 | row[k]) - (row[k - 3] << 8 | row[k - 2]);
      row[k - 1] = static_cast<uint8_t>(value >> 8);
      row[k] = static_cast<uint8_t>(value);
    }
  }
}

Bytes deflated(const Bytes& bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes packed(size);
  compress(packed.data(), &size, bytes.data(), bytes.size());
  packed.resize(size);
  return packed;
}

/// Planes packed together, as one channel or as the flattened picture.
Bytes packed_rows(std::vector<Bytes> rows, const PsdSpec& spec) {
  Bytes result;
  put(result, static_cast<uint16_t>(spec.packing), 2);
  Bytes all;
  for (Bytes& row : rows) {
    if (spec.packing == PsdPacking::zip_differences) take_differences(row, spec.depth);
    if (spec.packing == PsdPacking::pack_bits) {
      row = packed_row(row.data(), row.size());
      put(result, row.size(), 2);
    }
    all.insert(all.end(), row.begin(), row.end());
  }
  if (spec.packing == PsdPacking::zip || spec.packing == PsdPacking::zip_differences)
    all = deflated(all);
  result.insert(result.end(), all.begin(), all.end());
  return result;
}

struct Written {
  Bytes record;
  Bytes pixels;
};

void put_box(Bytes& bytes, const PsdLayerSpec& layer, const Image8& image) {
  for (const int side : {layer.y, layer.x, layer.y + image.height, layer.x + image.width})
    put(bytes, static_cast<uint32_t>(side), 4);
}

Bytes extra_of(const PsdLayerSpec& layer) {
  Bytes extra;
  Bytes mask;
  if (!layer.mask.empty()) {
    put_box(mask, layer, layer.mask);
    put(mask, layer.outside, 1);
    put(mask, 0, 3);
  }
  put_block(extra, mask);
  put(extra, 0, 4);  // blending ranges
  Bytes name = {static_cast<uint8_t>(layer.name.size())};
  put(name, layer.name);
  while (name.size() % 4 != 0) name.push_back(0);
  extra.insert(extra.end(), name.begin(), name.end());
  if (layer.divider != 0) {
    put(extra, "8BIMlsct");
    put(extra, 4, 4);
    put(extra, layer.divider, 4);
  }
  if (layer.effects) {
    put(extra, "8BIMlfx2");
    put(extra, 0, 4);
  }
  for (const auto& [key, block] : layer.blocks) {
    put(extra, "8BIM" + key);
    put_block(extra, block);
    if (block.size() % 2 != 0) extra.push_back(0);
  }
  return extra;
}

Written written(const PsdLayerSpec& layer, const PsdSpec& spec) {
  Written result;
  put_box(result.record, layer, layer.rgba);
  const int masks = layer.mask.empty() ? 0 : 1;
  put(result.record, 4 + masks, 2);
  for (int k = -1; k < 3 + masks; ++k) {
    const bool is_mask = k == 3;
    const Image8& image = is_mask ? layer.mask : layer.rgba;
    const Bytes plane = packed_rows(rows_of(image, is_mask ? 0 : (k + 4) % 4, spec.depth), spec);
    put(result.record, static_cast<uint16_t>(is_mask ? -2 : k), 2);
    put(result.record, plane.size(), 4);
    result.pixels.insert(result.pixels.end(), plane.begin(), plane.end());
  }
  put(result.record, "8BIM" + layer.blend);
  put(result.record, layer.opacity, 1);
  put(result.record, layer.clipped ? 1 : 0, 1);
  put(result.record, layer.hidden ? 2 : 0, 1);
  put(result.record, 0, 1);
  put_block(result.record, extra_of(layer));
  return result;
}

/// Layers of 16 bits stand in a block of their own.
Bytes layer_section(const PsdSpec& spec) {
  Bytes info;
  const int count = static_cast<int>(spec.layers.size());
  put(info, static_cast<uint16_t>(spec.merged_alpha ? -count : count), 2);
  Bytes pixels;
  for (const PsdLayerSpec& layer : spec.layers) {
    const Written one = written(layer, spec);
    info.insert(info.end(), one.record.begin(), one.record.end());
    pixels.insert(pixels.end(), one.pixels.begin(), one.pixels.end());
  }
  info.insert(info.end(), pixels.begin(), pixels.end());
  Bytes section;
  if (spec.depth == 8) {
    put_block(section, info);
    put(section, 0, 4);
    return section;
  }
  put(section, 0, 4);
  put(section, 0, 4);
  put(section, "8BIMLr16");
  put_block(section, info);
  return section;
}

}  // namespace

Bytes psd_bytes(const PsdSpec& spec) {
  Bytes bytes;
  put(bytes, "8BPS");
  put(bytes, spec.version, 2);
  put(bytes, 0, 6);
  put(bytes, spec.merged_alpha ? 4 : 3, 2);
  put(bytes, spec.height, 4);
  put(bytes, spec.width, 4);
  put(bytes, spec.depth, 2);
  put(bytes, spec.mode, 2);
  put(bytes, 0, 4);
  put(bytes, 0, 4);
  put_block(bytes, spec.layers.empty() ? Bytes() : layer_section(spec));
  const Image8 merged = spec.merged.empty() ? Image8(spec.width, spec.height, 4) : spec.merged;
  std::vector<Bytes> rows;
  for (int k = 0; k < (spec.merged_alpha ? 4 : 3); ++k)
    for (Bytes& row : rows_of(merged, k, spec.depth)) rows.push_back(std::move(row));
  const Bytes picture = packed_rows(std::move(rows), spec);
  bytes.insert(bytes.end(), picture.begin(), picture.end());
  return bytes;
}

Image8 filled(int width, int height, const std::vector<uint8_t>& rgba) {
  const int channels = static_cast<int>(rgba.size());
  Image8 image(width, height, channels);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = rgba[i % channels];
  return image;
}

}  // namespace relievo
