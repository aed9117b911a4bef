#include "understanding/perception/built_in_network.h"

#include <cassert>
#include <utility>

namespace relievo::understanding {
namespace {

/// Consecutive bytes of a file, as a text: compilers read that faster than numbers.
struct Piece {
  const char* bytes;
  size_t size;
};

constexpr Piece file[] = {
#include "understanding/perception/network_bytes.inc"
};

Network decoded() {
  Bytes bytes;
  for (const Piece& piece : file) bytes.insert(bytes.end(), piece.bytes, piece.bytes + piece.size);
  auto network = decode_network(bytes);
  assert(network.ok());
  return std::move(*network);
}

}  // namespace

const Network& built_in_network() {
  static const Network network = decoded();
  return network;
}

}  // namespace relievo::understanding
