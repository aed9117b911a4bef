#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "relievo/bytes.h"

namespace relievo {

/// Reads little-endian numbers one after the other; tests for the end with `at_end`.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : bytes_(bytes) {}

  template <class Number>
  Number take() {
    Number number{};
    std::memcpy(&number, bytes_.data() + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }

  std::string take_text(size_t size) {
    const std::string text(bytes_.begin() + at_, bytes_.begin() + at_ + size);
    at_ += size;
    return text;
  }

  void seek(size_t at) { at_ = at; }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  ByteView bytes_;
  size_t at_ = 0;
};

}  // namespace relievo
