#include "apps/cli/sequence/sprite_sheet.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "io/scene/json_reader.h"

namespace relievo::cli {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr size_t max_sprites = 10000;
constexpr int max_side = 32767;

Error wrong(const std::string& where, const std::string& message) {
  return {ErrorCode::bad_input, message, where};
}

/// Reads whole numbers of pixels, at least 0, from the objects of a frame. Keeps the first error.
struct PixelReader {
  const Json& frame;
  const std::string& where;
  std::optional<Error> error = std::nullopt;

  int get(const char* object, const char* key) {
    const auto found = frame.find(object);
    if (found != frame.end() && found->is_object() && found->contains(key)) {
      const Json& value = found->at(key);
      if (value.is_number_integer() && value >= 0 && value <= max_side) return value.get<int>();
    }
    if (!error)
      error = wrong(where + "." + object + "." + key, "must be a whole number of px, at least 0");
    return 0;
  }
};

bool flag(const Json& frame, const char* key) {
  const auto found = frame.find(key);
  return found != frame.end() && found->is_boolean() && found->get<bool>();
}

Result<Sprite> read_sprite(const Json& frame, const std::string& name, const std::string& where) {
  if (!frame.is_object()) return wrong(where, "must be an object");
  PixelReader px{frame, where};
  Sprite sprite;
  sprite.name = name;
  sprite.x = px.get("frame", "x");
  sprite.y = px.get("frame", "y");
  sprite.size = {px.get("frame", "w"), px.get("frame", "h")};
  sprite.rotated = flag(frame, "rotated");
  sprite.whole = sprite.size;
  if (frame.contains("sourceSize"))
    sprite.whole = {px.get("sourceSize", "w"), px.get("sourceSize", "h")};
  if (frame.contains("spriteSourceSize")) {
    sprite.left = px.get("spriteSourceSize", "x");
    sprite.top = px.get("spriteSourceSize", "y");
  }
  if (px.error) return *px.error;
  if (sprite.whole.width < 1 || sprite.whole.height < 1) return wrong(where, "has no pixels");
  if (sprite.left + sprite.size.width > sprite.whole.width ||
      sprite.top + sprite.size.height > sprite.whole.height)
    return wrong(where + ".spriteSourceSize", "reaches beyond the sprite's sourceSize");
  return sprite;
}

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns the member of an object, or `fallback`.
const Json& member(const Json& json, const char* key, const Json& fallback) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() ? *found : fallback;
}

bool is_number(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

/// Returns the layers that a sprite's name may state: as Aseprite writes it, "walk (body) 1.ase",
/// the last text in parentheses, else the names of the sheet's layers.
std::vector<std::string> layers_in(const std::string& name, const Json& meta) {
  std::vector<std::string> layers;
  const size_t end = name.rfind(')');
  const size_t start = name.rfind('(', end);
  if (end != std::string::npos && start != std::string::npos)
    layers.push_back(name.substr(start + 1, end - start - 1));
  if (meta.contains("layers") && meta.at("layers").is_array())
    for (const Json& layer : meta.at("layers"))
      if (const std::string text = text_at(layer, "name"); name.find(text) != std::string::npos)
        layers.push_back(text);
  layers.erase(std::remove_if(layers.begin(), layers.end(), is_number), layers.end());
  return layers;
}

/// Refuses a sheet on which the layers of a frame are sprites of their own: sprites whose names
/// differ in the layer only.
Status check_layers(const SpriteSheet& sheet, const Json& meta) {
  if (!meta.contains("layers") && text_at(meta, "app").find("aseprite") == std::string::npos)
    return Done{};
  std::map<std::string, std::string> layer_of;  // by the name without its layer
  for (const Sprite& sprite : sheet.sprites)
    for (const std::string& layer : layers_in(sprite.name, meta)) {
      std::string frame = sprite.name;
      frame.erase(frame.rfind(layer), layer.size());
      const auto [known, added] = layer_of.emplace(frame, layer);
      if (!added && known->second != layer)
        return wrong("frames", "lists the layers of a frame (" + known->second + ", " + layer +
                                   ") as sprites of their own; export the sheet without splitting "
                                   "its layers");
    }
  return Done{};
}

OrderedJson sprite_json(const Sprite& sprite) {
  const auto [w, h] = std::pair(sprite.size.width, sprite.size.height);
  return {{"filename", sprite.name},
          {"frame", {{"x", sprite.x}, {"y", sprite.y}, {"w", w}, {"h", h}}},
          {"rotated", false},
          {"trimmed", false},
          {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", w}, {"h", h}}},
          {"sourceSize", {{"w", w}, {"h", h}}}};
}

}  // namespace

Result<SpriteSheet> read_sprite_sheet(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.error();
  const Json none = Json::object();
  const Json& meta = member(*json, "meta", none);
  const Json& atlases = member(*json, "textures", none);
  if (atlases.size() > 1 || !member(meta, "related_multi_packs", none).empty())
    return wrong("textures",
                 "is a multi-atlas of several pictures; pack all sprites on one picture");
  const Json& atlas = atlases.size() == 1 ? *atlases.begin() : *json;
  const Json& frames = member(atlas, "frames", none);
  if (!frames.is_array() && (!frames.is_object() || &frames == &none))
    return wrong("frames", "must list the sprites of the sheet");
  SpriteSheet sheet;
  sheet.picture = text_at(atlases.size() == 1 ? atlas : meta, "image");
  if (frames.size() > max_sprites)
    return Error{ErrorCode::limit, "lists more than 10,000 sprites", "frames"};
  size_t index = 0;
  for (const auto& [key, frame] : frames.items()) {
    const std::string where = frames.is_array() ? "frames[" + key + "]" : "frames[\"" + key + "\"]";
    auto sprite = read_sprite(frame, frames.is_array() ? text_at(frame, "filename") : key, where);
    if (!sprite) return sprite.error();
    if (sprite->name.empty()) sprite->name = std::to_string(index);
    sheet.sprites.push_back(std::move(*sprite));
    ++index;
  }
  if (sheet.sprites.empty()) return wrong("frames", "lists no sprites");
  if (Status status = check_layers(sheet, meta); !status) return status.error();
  return sheet;
}

SpriteSheet grid_sheet(ImageSize cell, int columns, int count) {
  SpriteSheet sheet;
  for (int i = 0; i < count; ++i)
    sheet.sprites.push_back({std::to_string(i), i % columns * cell.width, i / columns * cell.height,
                             cell, false, 0, 0, cell});
  return sheet;
}

std::string write_sprite_sheet(const SpriteSheet& sheet, ImageSize size) {
  OrderedJson json;
  json["frames"] = OrderedJson::array();
  for (const Sprite& sprite : sheet.sprites) json["frames"].push_back(sprite_json(sprite));
  json["meta"] = {{"app", "relievo"},
                  {"image", sheet.picture},
                  {"format", "RGBA8888"},
                  {"size", {{"w", size.width}, {"h", size.height}}},
                  {"scale", "1"}};
  return json.dump(1) + "\n";
}

ImageSize extent(const SpriteSheet& sheet) {
  ImageSize size;
  for (const Sprite& sprite : sheet.sprites) {
    const auto [w, h] = sprite.rotated ? std::pair(sprite.size.height, sprite.size.width)
                                       : std::pair(sprite.size.width, sprite.size.height);
    size.width = std::max(size.width, sprite.x + w);
    size.height = std::max(size.height, sprite.y + h);
  }
  return size;
}

}  // namespace relievo::cli
