#pragma once

#include <cstdint>

#include "relievo/bytes.h"

namespace relievo {

/// Takes numbers, most significant byte first, from the front of some bytes. What lies beyond their
/// end is 0, and is remembered.
class BigEndian {
 public:
  explicit BigEndian(ByteView bytes) : left_(bytes) {}

  uint64_t take(size_t bytes) {
    uint64_t value = 0;
    for (size_t k = 0; k < bytes; ++k) {
      value <<= 8;
      if (k < left_.size()) value |= left_[k];
    }
    skip(bytes);
    return value;
  }

  uint8_t u8() { return static_cast<uint8_t>(take(1)); }
  uint16_t u16() { return static_cast<uint16_t>(take(2)); }
  int16_t i16() { return static_cast<int16_t>(take(2)); }
  uint32_t u32() { return static_cast<uint32_t>(take(4)); }
  int32_t i32() { return static_cast<int32_t>(take(4)); }

  ByteView bytes(uint64_t count) {
    const ByteView taken = left_.first(within(count));
    skip(count);
    return taken;
  }

  void skip(uint64_t count) {
    beyond_ |= count > left_.size();
    left_ = left_.subspan(within(count));
  }

  size_t left() const { return left_.size(); }

  /// Whether more was taken than was there.
  bool beyond() const { return beyond_; }

 private:
  size_t within(uint64_t count) const {
    return count < left_.size() ? static_cast<size_t>(count) : left_.size();
  }

  ByteView left_;
  bool beyond_ = false;
};

}  // namespace relievo
