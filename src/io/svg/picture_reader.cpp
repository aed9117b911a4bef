#include "io/svg/picture_reader.h"

#include <utility>

#include "io/svg/svg_region.h"
#include "io/svg/svg_transform.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

/// Returns the picture that the element embeds, read once; null where it embeds none, with a
/// warning.
const SvgPicture* picture_of(const pugi::xml_node& image, const InheritedState& around,
                             Reading& reading) {
  const auto known = reading.pictures.find(image.hash_value());
  if (known != reading.pictures.end()) return &known->second;
  const auto complain = [&](const Error& error) {
    reading.warn(reading.whereabouts(image, around) + " is a picture and becomes no part: it " +
                 error.message + "; embed it as PNG, or find its parts with: relievo segment");
    return nullptr;
  };
  const auto size = embedded_size(image);
  if (!size) return complain(size.error());
  reading.picture_pixels += int64_t{size->width} * size->height;
  if (reading.picture_pixels > max_picture_pixels) {
    reading.fail("has pictures with too many pixels", static_cast<size_t>(max_picture_pixels));
    return nullptr;
  }
  auto picture = embedded_picture(image);
  if (!picture) return complain(picture.error());
  return &reading.pictures.emplace(image.hash_value(), std::move(*picture)).first->second;
}

/// Returns the size at which an <image> is shown. A side that is not stated follows the picture.
RootSize shown_size(const pugi::xml_node& image, ImageSize pixels, const LengthContext& lengths) {
  const auto width =
      parse_length(image.attribute("width").value(), LengthAxis::horizontal, lengths);
  const auto height =
      parse_length(image.attribute("height").value(), LengthAxis::vertical, lengths);
  const double aspect = double(pixels.width) / pixels.height;
  if (width && height) return {*width, *height};
  if (width) return {*width, *width / aspect};
  if (height) return {*height * aspect, *height};
  return {double(pixels.width), double(pixels.height)};
}

/// Returns the map of the picture's pixels to the units in which the <image> is placed.
Affine2 map_of(const pugi::xml_node& image, ImageSize pixels, const LengthContext& lengths) {
  const RootSize size = shown_size(image, pixels, lengths);
  return placement_of(image, lengths) *
         fit_view_box({0, 0, double(pixels.width), double(pixels.height)}, size.width, size.height,
                      image.attribute("preserveAspectRatio").value());
}

ShownPicture shown(const SvgPicture& picture, const Affine2& map, const Box2& canvas) {
  return {mapped_region(picture.opaque, map, canvas), picture.outlined, picture.has_holes};
}

/// A pattern that shows one <image>.
struct PatternPicture {
  pugi::xml_node pattern;
  pugi::xml_node image;
  Affine2 to_content;  ///< map of the image to the content of the pattern
};

pugi::xml_node only_element(const pugi::xml_node& parent) {
  pugi::xml_node only;
  for (const pugi::xml_node& child : parent.children()) {
    if (child.type() != pugi::node_element) continue;
    if (only) return {};
    only = child;
  }
  return only;
}

constexpr int max_steps = 8;  ///< from a pattern to its picture

std::optional<PatternPicture> pattern_picture(const SvgDocument& document,
                                              const std::string& server,
                                              const LengthContext& lengths) {
  const pugi::xml_node pattern = named_element(document, server, "pattern");
  PatternPicture picture{pattern, only_element(pattern), {}};
  for (int i = 0; i < max_steps && picture.image; ++i) {
    const std::string_view name = local_name(picture.image.name());
    const auto transform = parse_transform(picture.image.attribute("transform").value());
    if (!transform) return std::nullopt;
    picture.to_content = picture.to_content * *transform;
    if (name == "image") return picture;
    if (name == "use") {
      picture.to_content = picture.to_content * placement_of(picture.image, lengths);
      picture.image = referenced_element(document, picture.image);
    } else {
      picture.image = name == "g" ? only_element(picture.image) : pugi::xml_node();
    }
  }
  return std::nullopt;
}

/// Returns the tile of the pattern in user units.
Box2 tile_of(const pugi::xml_node& pattern, const Box2& box, const LengthContext& lengths) {
  const bool of_box =
      std::string_view(pattern.attribute("patternUnits").value()) != "userSpaceOnUse";
  const Point2 size = box.max - box.min;
  LengthContext fractions = lengths;
  if (of_box) fractions.viewport_width = fractions.viewport_height = 1;
  const auto length = [&](const char* name, LengthAxis axis) {
    return parse_length(pattern.attribute(name).value(), axis, fractions).value_or(0);
  };
  Box2 tile{{length("x", LengthAxis::horizontal), length("y", LengthAxis::vertical)}, {}};
  tile.max = tile.min + Point2{length("width", LengthAxis::horizontal),
                               length("height", LengthAxis::vertical)};
  if (!of_box) return tile;
  const auto in_box = [&](Point2 p) { return box.min + Point2{p.x * size.x, p.y * size.y}; };
  return {in_box(tile.min), in_box(tile.max)};
}

/// Returns whether the tile covers the box but for a thousandth.
bool covers(const Box2& tile, const Box2& box) {
  const double slack = 1e-3 * box.diagonal();
  return tile.min.x < box.min.x + slack && tile.min.y < box.min.y + slack &&
         tile.max.x > box.max.x - slack && tile.max.y > box.max.y - slack;
}

/// Returns the map of the pattern's content to user units.
Affine2 content_map(const pugi::xml_node& pattern, const Box2& tile, const Box2& box) {
  const Affine2 corner = translation(tile.min.x, tile.min.y);
  const Point2 size = tile.max - tile.min;
  if (const auto view = parse_view_box(pattern.attribute("viewBox").value()))
    return corner *
           fit_view_box(*view, size.x, size.y, pattern.attribute("preserveAspectRatio").value());
  const bool of_box =
      std::string_view(pattern.attribute("patternContentUnits").value()) == "objectBoundingBox";
  return of_box ? corner * scaling(box.max.x - box.min.x, box.max.y - box.min.y) : corner;
}

}  // namespace

std::optional<SvgShape> picture_shape(const pugi::xml_node& image, const InheritedState& around,
                                      Reading& reading) {
  if (!around.style.visible) return std::nullopt;
  const SvgPicture* picture = picture_of(image, around, reading);
  if (picture == nullptr) return std::nullopt;
  const RootSize size = shown_size(image, picture->size, around.lengths);
  if (!(size.width > 0) || !(size.height > 0)) return std::nullopt;
  SvgShape shape;
  const Affine2 place = around.to_canvas * placement_of(image, around.lengths);
  shape.lines = {rectangle_line({{0, 0}, {size.width, size.height}}, place)};
  shape.fill = picture->color;
  shape.fill->a *= around.opacity;
  shape.picture = shown(*picture, around.to_canvas * map_of(image, picture->size, around.lengths),
                        reading.drawing.canvas());
  return shape;
}

void fill_with_picture(const pugi::xml_node& element, const InheritedState& around, SvgShape& shape,
                       Reading& reading) {
  const auto& server = around.style.fill.server;
  const auto found =
      server ? pattern_picture(reading.document, *server, around.lengths) : std::nullopt;
  if (!found) return;
  const Box2 box = object_box(element, around.lengths, reading.boxes);
  const Box2 tile = tile_of(found->pattern, box, around.lengths);
  if (box.empty() || found->pattern.attribute("patternTransform") || !covers(tile, box)) return;
  const SvgPicture* picture = picture_of(found->image, around, reading);
  if (picture == nullptr) return;
  const Affine2 map = around.to_canvas * content_map(found->pattern, tile, box) *
                      found->to_content * map_of(found->image, picture->size, around.lengths);
  const double alpha = shape.fill ? shape.fill->a : 1;
  shape.fill = picture->color;
  shape.fill->a *= alpha;
  shape.picture = shown(*picture, map, reading.drawing.canvas());
}

}  // namespace relievo
