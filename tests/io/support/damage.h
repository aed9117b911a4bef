#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "relievo/bytes.h"

namespace relievo {

/// Calls `read` on about `runs` truncations of sound bytes and as many copies with one bit flipped,
/// spread evenly. Each must give a value, or an error that says something.
template <class Read>
void survive_damage(const Bytes& good, size_t runs, Read read) {
  const auto check = [&](ByteView bytes, size_t at) {
    const auto result = read(bytes);
    if (!result.ok()) {
      EXPECT_FALSE(result.error().message.empty()) << at;
    }
  };
  for (size_t cut = 0; cut < good.size(); cut += std::max<size_t>(1, good.size() / runs))
    check(ByteView(good).first(cut), cut);
  // An odd step, so that every bit of a byte has its turn.
  for (size_t bit = 0; bit < 8 * good.size(); bit += 8 * good.size() / runs | 1) {
    Bytes damaged = good;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ (1 << bit % 8));
    check(damaged, bit);
  }
}

}  // namespace relievo
