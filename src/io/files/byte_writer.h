#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string_view>

#include "relievo/bytes.h"

namespace relievo {

/// Append a number to `bytes`, least significant byte first.
inline void append_u16(Bytes& bytes, uint16_t value) {
  bytes.push_back(static_cast<uint8_t>(value & 0xff));
  bytes.push_back(static_cast<uint8_t>(value >> 8));
}
inline void append_u32(Bytes& bytes, uint32_t value) {
  append_u16(bytes, static_cast<uint16_t>(value & 0xffff));
  append_u16(bytes, static_cast<uint16_t>(value >> 16));
}
inline void append_f32(Bytes& bytes, double value) {
  const float narrow = static_cast<float>(value);
  uint32_t bits = 0;
  std::memcpy(&bits, &narrow, sizeof bits);
  append_u32(bytes, bits);
}
/// Append numbers in single precision.
inline void append_f32s(Bytes& bytes, std::initializer_list<double> values) {
  for (const double value : values) append_f32(bytes, value);
}

inline void append_text(Bytes& bytes, std::string_view text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

}  // namespace relievo
