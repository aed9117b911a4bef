#pragma once

#include <string_view>

#include "relievo/bytes.h"

namespace relievo::fuzz {

/// Reads bytes from a stranger by one of the readers, to which they may do nothing but be refused.
using Reader = void (*)(ByteView bytes);

/// The reader of a name: svg, scene, archive, picture, layers, glb or scribbles; null for others.
Reader reader_of(std::string_view name);

}  // namespace relievo::fuzz
