#include "io/layered/layer_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

constexpr std::array<std::string_view, 14> tags = {"bone",    "slot",   "skin",   "scale", "folder",
                                                   "overlay", "trim",   "mesh",   "path",  "pad",
                                                   "rotate",  "origin", "ignore", "merge"};

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Takes the first tag out of the text; returns its word, or nothing where there is none. The value
/// after its colon is left in `value`.
std::string take_tag(std::string& text, std::string& value) {
  for (size_t open = text.find('['); open != std::string::npos; open = text.find('[', open + 1)) {
    const size_t close = text.find(']', open);
    if (close == std::string::npos) return "";
    const std::string inside = text.substr(open + 1, close - open - 1);
    const size_t colon = inside.find(':');
    const std::string word = lower_case(inside.substr(0, colon));
    if (std::find(tags.begin(), tags.end(), word) == tags.end()) continue;
    value = colon == std::string::npos ? "" : inside.substr(colon + 1);
    text.erase(open, close - open + 1);
    return word;
  }
  return "";
}

using NamedBlending = std::pair<std::string_view, Blending>;

constexpr NamedBlending mode(std::string_view name, BlendMode mode) {
  return {name, {mode, CoverMode::over}};
}

constexpr NamedBlending cover(std::string_view name, CoverMode cover) {
  return {name, {BlendMode::normal, cover}};
}

constexpr std::array blendings = {
    mode("src-over", BlendMode::normal),
    mode("normal", BlendMode::normal),
    mode("multiply", BlendMode::multiply),
    mode("screen", BlendMode::screen),
    mode("overlay", BlendMode::overlay),
    mode("darken", BlendMode::darken),
    mode("lighten", BlendMode::lighten),
    mode("color-dodge", BlendMode::color_dodge),
    mode("color-burn", BlendMode::color_burn),
    mode("hard-light", BlendMode::hard_light),
    mode("soft-light", BlendMode::soft_light),
    mode("difference", BlendMode::difference),
    mode("exclusion", BlendMode::exclusion),
    mode("plus", BlendMode::add),
    mode("add", BlendMode::add),
    mode("hue", BlendMode::hue),
    mode("saturation", BlendMode::saturation),
    mode("color", BlendMode::color),
    mode("luminosity", BlendMode::luminosity),
    cover("src-atop", CoverMode::atop),
    cover("src-in", CoverMode::source_in),
    cover("dst-in", CoverMode::below_in),
    cover("dst-out", CoverMode::below_out),
    cover("dst-atop", CoverMode::below_atop),
};

using KeyedMode = std::pair<std::string_view, BlendMode>;

/// Groups that pass through have a key of their own.
constexpr std::array keyed_modes = {
    KeyedMode{"norm", BlendMode::normal},       KeyedMode{"pass", BlendMode::normal},
    KeyedMode{"mul ", BlendMode::multiply},     KeyedMode{"scrn", BlendMode::screen},
    KeyedMode{"over", BlendMode::overlay},      KeyedMode{"dark", BlendMode::darken},
    KeyedMode{"lite", BlendMode::lighten},      KeyedMode{"div ", BlendMode::color_dodge},
    KeyedMode{"idiv", BlendMode::color_burn},   KeyedMode{"hLit", BlendMode::hard_light},
    KeyedMode{"sLit", BlendMode::soft_light},   KeyedMode{"diff", BlendMode::difference},
    KeyedMode{"smud", BlendMode::exclusion},    KeyedMode{"lddg", BlendMode::add},
    KeyedMode{"lbrn", BlendMode::linear_burn},  KeyedMode{"fsub", BlendMode::subtract},
    KeyedMode{"fdiv", BlendMode::divide},       KeyedMode{"vLit", BlendMode::vivid_light},
    KeyedMode{"lLit", BlendMode::linear_light}, KeyedMode{"pLit", BlendMode::pin_light},
    KeyedMode{"hue ", BlendMode::hue},          KeyedMode{"sat ", BlendMode::saturation},
    KeyedMode{"colr", BlendMode::color},        KeyedMode{"lum ", BlendMode::luminosity},
};

}  // namespace

LayerName read_layer_name(const std::string& name, LayerRole of_group) {
  LayerName said;
  std::string rest = name;
  std::string value;
  std::string from_tag;
  bool overlay = false;
  for (std::string tag = take_tag(rest, value); !tag.empty(); tag = take_tag(rest, value)) {
    said.ignored |= tag == "ignore";
    said.merged |= tag == "merge";
    overlay |= tag == "overlay";
    if (from_tag.empty() && (tag == "slot" || tag == "bone")) from_tag = value;
  }
  // A name without tags keeps its spaces.
  std::string_view plain = rest.size() == name.size() ? std::string_view(rest) : trimmed(rest);
  const bool texture = overlay || plain.starts_with("texture:");
  const bool part = plain.starts_with("part:");
  if (texture || of_group == LayerRole::texture) said.role = LayerRole::texture;
  if (part && said.role != LayerRole::texture) said.role = LayerRole::part;
  if (said.role == LayerRole::part) plain = trimmed(plain.substr(5));
  said.merged |= said.role == LayerRole::part;
  said.plain = plain.empty() ? from_tag : std::string(plain);
  if (!is_sound_id(said.plain)) said.plain.clear();
  return said;
}

std::optional<Blending> named_blending(std::string_view name) {
  if (name.starts_with("svg:")) name.remove_prefix(4);
  const auto* found = std::find_if(blendings.begin(), blendings.end(),
                                   [&](const NamedBlending& one) { return one.first == name; });
  if (found == blendings.end()) return std::nullopt;
  return found->second;
}

std::optional<BlendMode> keyed_mode(const std::array<char, 4>& key) {
  const auto* found = std::find_if(
      keyed_modes.begin(), keyed_modes.end(),
      [&](const KeyedMode& one) { return one.first == std::string_view(key.data(), key.size()); });
  if (found == keyed_modes.end()) return std::nullopt;
  return found->second;
}

}  // namespace relievo
