#include "apps/cli/sequence/sprite_sheet.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

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
  const bool there = json->is_object() && json->contains("frames");
  if (!there || !(json->at("frames").is_array() || json->at("frames").is_object()))
    return wrong("frames", "must list the sprites of the sheet");
  SpriteSheet sheet;
  if (json->contains("meta") && json->at("meta").is_object())
    sheet.picture = text_at(json->at("meta"), "image");
  const Json& frames = json->at("frames");
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
