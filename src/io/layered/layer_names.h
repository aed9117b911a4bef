#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "io/layered/raster_layer.h"
#include "kernel/image/blend.h"

namespace relievo {

/// The statements in the name of a layer or a group.
struct LayerName {
  std::string plain;  ///< without prefix and tags; empty where that is no valid id of a part
  LayerRole role = LayerRole::proposed;
  bool ignored = false;  ///< tagged as no part of the drawing
  bool merged = false;   ///< a group's: it is like one layer
};

/// Reads a name in a group of this role. It may begin with `texture:` or `part:`; what is in a
/// group of texture is texture. Tags in square brackets, as scripts for Spine read them, may stand
/// anywhere: `[ignore]`, `[merge]`, `[overlay]` (texture), and those for bones, slots, skins and
/// files, which say nothing about parts. A group that is a part is merged.
LayerName read_layer_name(const std::string& name, LayerRole of_group);

/// Returns the blending of an OpenRaster operator, such as svg:multiply or svg:dst-out; the prefix
/// may be missing. Nothing for an unknown one.
std::optional<Blending> named_blending(std::string_view name);

/// Returns the mode of a key of a Photoshop document, such as "mul "; nothing for an unknown one.
std::optional<BlendMode> keyed_mode(const std::array<char, 4>& key);

}  // namespace relievo
