#pragma once

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"

namespace relievo {

/// A sound PNG file as RGBA of 8 bits, read step by step as the specification (second edition,
/// ISO/IEC 15948) says, without libpng: the golden pixels of the suite.
class ReferencePng {
 public:
  explicit ReferencePng(const Bytes& bytes) {
    for (size_t at = 8; at + 12 <= bytes.size();) {
      const size_t size = number(&bytes[at]);
      read_chunk(std::string(bytes.begin() + at + 4, bytes.begin() + at + 8), &bytes[at + 8], size);
      at += size + 12;
    }
    inflate_data();
    image_ = Image8(width_, height_, 4);
    static constexpr int passes[7][4] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                                         {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    if (interlaced_)
      for (const auto& pass : passes) read_pass(pass[0], pass[1], pass[2], pass[3]);
    else
      read_pass(0, 0, 1, 1);
  }

  const Image8& image() const { return image_; }

 private:
  static uint32_t number(const uint8_t* p) {
    return uint32_t{p[0]} << 24 | uint32_t{p[1]} << 16 | uint32_t{p[2]} << 8 | p[3];
  }

  void read_chunk(const std::string& type, const uint8_t* data, size_t size) {
    if (type == "IHDR") {
      width_ = static_cast<int>(number(data));
      height_ = static_cast<int>(number(data + 4));
      depth_ = data[8];
      colour_ = data[9];
      interlaced_ = data[12] != 0;
    }
    if (type == "PLTE") palette_.assign(data, data + size);
    if (type == "tRNS") transparency_.assign(data, data + size);
    if (type == "IDAT") packed_.insert(packed_.end(), data, data + size);
  }

  void inflate_data() {
    uLongf size = static_cast<uLongf>(height_ + 14) * (static_cast<uLongf>(width_) * 8 + 16);
    data_.resize(size);
    uncompress(data_.data(), &size, packed_.data(), packed_.size());
  }

  int samples() const { return std::array<int, 7>{1, 0, 3, 1, 2, 0, 4}[colour_]; }

  void read_pass(int x0, int y0, int dx, int dy) {
    const int columns = (width_ - x0 + dx - 1) / dx;
    const int rows = (height_ - y0 + dy - 1) / dy;
    if (columns <= 0 || rows <= 0) return;
    const size_t row_bytes = (static_cast<size_t>(columns) * samples() * depth_ + 7) / 8;
    const size_t step = std::max<size_t>(1, static_cast<size_t>(samples()) * depth_ / 8);
    Bytes before(row_bytes, 0);
    for (int r = 0; r < rows; ++r) {
      Bytes row(&data_[at_ + 1], &data_[at_ + 1] + row_bytes);
      unfilter(data_[at_], row, before, step);
      at_ += row_bytes + 1;
      for (int c = 0; c < columns; ++c) put(row, c, x0 + c * dx, y0 + r * dy);
      before = row;
    }
  }

  static void unfilter(int filter, Bytes& row, const Bytes& before, size_t step) {
    for (size_t i = 0; i < row.size(); ++i) {
      const int a = i >= step ? row[i - step] : 0;
      const int b = before[i];
      const int c = i >= step ? before[i - step] : 0;
      const int p = a + b - c;
      const int pa = std::abs(p - a);
      const int pb = std::abs(p - b);
      const int pc = std::abs(p - c);
      const int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const int guess = std::array<int, 5>{0, a, b, (a + b) / 2, paeth}[filter];
      row[i] = static_cast<uint8_t>(row[i] + guess);
    }
  }

  int sample(const Bytes& row, int index) const {
    if (depth_ == 16) return row[2 * index] << 8 | row[2 * index + 1];
    const int bit = index * depth_;
    return row[bit / 8] >> (8 - depth_ - bit % 8) & ((1 << depth_) - 1);
  }

  uint8_t byte(int value) const {
    const int most = (1 << depth_) - 1;
    return static_cast<uint8_t>((value * 255 + most / 2) / most);
  }

  void put(const Bytes& row, int column, int x, int y) {
    std::array<int, 4> s = {};
    for (int k = 0; k < samples(); ++k) s[k] = sample(row, column * samples() + k);
    uint8_t* out = &image_.at(x, y);
    out[3] = 255;
    if (colour_ == 3) {
      for (int k = 0; k < 3; ++k) out[k] = palette_[3 * s[0] + k];
      if (static_cast<size_t>(s[0]) < transparency_.size()) out[3] = transparency_[s[0]];
      return;
    }
    const bool grey = colour_ == 0 || colour_ == 4;
    for (int k = 0; k < 3; ++k) out[k] = byte(s[grey ? 0 : k]);
    if (colour_ == 4) out[3] = byte(s[1]);
    if (colour_ == 6) out[3] = byte(s[3]);
    if (!transparency_.empty() && is_key(s)) out[3] = 0;
  }

  bool is_key(const std::array<int, 4>& s) const {
    for (int k = 0; k < samples(); ++k)
      if ((transparency_[2 * k] << 8 | transparency_[2 * k + 1]) != s[k]) return false;
    return true;
  }

  int width_ = 0, height_ = 0, depth_ = 0, colour_ = 0;
  bool interlaced_ = false;
  Bytes palette_, transparency_, packed_, data_;
  size_t at_ = 0;
  Image8 image_;
};

}  // namespace relievo
