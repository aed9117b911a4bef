#include "io/psd/psd_channel.h"

#include <zlib.h>

#include <algorithm>

#include "io/psd/big_endian.h"

namespace relievo {
namespace {

enum Packing : uint16_t { raw, pack_bits, zip, zip_differences };

Error does_not_unpack() {
  return {ErrorCode::bad_input, "is damaged: its pixels do not unpack", ""};
}

/// One row of PackBits.
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

/// Rows of PackBits, the lengths of all of them first.
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

/// Sums the differences along every row; those of 16-bit values are of the values.
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

/// 8-bit values of what was unpacked.
std::vector<uint8_t> to_8_bit(std::vector<uint8_t> bytes, int depth) {
  if (depth == 8) return bytes;
  std::vector<uint8_t> values(bytes.size() / 2);
  for (size_t k = 0; k < values.size(); ++k) {
    const int value = bytes[2 * k] << 8 | bytes[2 * k + 1];
    values[k] = static_cast<uint8_t>((value + 128) / 257);
  }
  return values;
}

/// Rows of all planes, one after the other.
Result<std::vector<uint8_t>> unpack(ByteView packed, size_t rows, size_t row_bytes, int depth) {
  BigEndian data(packed);
  const uint16_t packing = data.u16();
  // Nothing packs better than zlib, by some 1032 to 1.
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
