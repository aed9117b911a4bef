#include "understanding/perception/built_in_network.h"

#include <array>
#include <cassert>
#include <cstdint>

namespace relievo::understanding {
namespace {

constexpr auto file = std::to_array<uint8_t>({
#include "understanding/perception/network_bytes.inc"
});

Network decoded() {
  auto network = decode_network(file);
  assert(network.ok());
  return std::move(*network);
}

}  // namespace

const Network& built_in_network() {
  static const Network network = decoded();
  return network;
}

}  // namespace relievo::understanding
