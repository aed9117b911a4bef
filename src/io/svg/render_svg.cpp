#include "io/svg/render_svg.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "io/svg/embedded_image.h"
#include "io/svg/interpret_svg.h"
#include "io/svg/scanner.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

constexpr int max_side = 16384;
constexpr int64_t max_pixels = 100000000;

struct Release {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(GError* error) const { g_error_free(error); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

/// Whether the renderer may see the element: no scripts, nothing foreign, nothing from elsewhere,
/// and no picture of unknown size.
bool is_harmless(const pugi::xml_node& element) {
  const std::string_view name = local_name(element.name());
  if (name == "script" || name == "foreignObject" || name == "feImage") return false;
  if (trimmed_svg(element.attribute("data-relievo").value()) == "ignore") return false;
  if (name != "image") return true;
  const auto size = embedded_png_size(element);
  return size && static_cast<int64_t>(size->width) * size->height <= 25000000;
}

void remove_harmful(pugi::xml_node parent) {
  for (pugi::xml_node child = parent.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) {
      if (is_harmless(child)) {
        remove_harmful(child);
      } else {
        parent.remove_child(child);
      }
    }
    child = next;
  }
}

void set_attribute(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) attribute = node.append_attribute(name);
  attribute.set_value(value.c_str());
}

/// Namespaces that were written as entities of the document type are put in their place.
void repair_namespaces(pugi::xml_node root) {
  for (pugi::xml_attribute attribute : root.attributes()) {
    const std::string_view name = attribute.name();
    if (name.substr(0, 5) != "xmlns" || attribute.value()[0] != '&') continue;
    const std::string_view prefix = local_name(name);
    if (prefix == "xmlns" || prefix == "svg") attribute.set_value("http://www.w3.org/2000/svg");
    if (prefix == "xlink") attribute.set_value("http://www.w3.org/1999/xlink");
  }
  if (local_name(root.name()) == root.name()) {
    set_attribute(root, "xmlns", "http://www.w3.org/2000/svg");
  }
  set_attribute(root, "xmlns:xlink", "http://www.w3.org/1999/xlink");
}

/// Gives the root the size that the canvas has for us, so that both agree on where things are.
void fix_size(pugi::xml_node root, const SvgCanvas& canvas) {
  const std::string width = std::to_string(canvas.px_width);
  const std::string height = std::to_string(canvas.px_height);
  set_attribute(root, "width", width);
  set_attribute(root, "height", height);
  if (!parse_view_box(root.attribute("viewBox").value())) {
    set_attribute(root, "viewBox", "0 0 " + width + " " + height);
  }
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
};

/// The document as the renderer may see it.
Result<std::string> safe_text(SvgDocument& document, const SvgCanvas& canvas,
                              const SvgOptions& options) {
  const auto drawing = read_drawing(document, options);
  if (!drawing) return drawing.error();
  const auto interpretation = interpret_svg(*drawing, options);
  if (!interpretation) return interpretation.error();
  for (pugi::xml_node join : interpretation->join_elements) {
    set_attribute(join, "data-relievo", "ignore");
  }
  remove_harmful(document.root);
  repair_namespaces(document.root);
  fix_size(document.root, canvas);
  StringWriter writer;
  document.root.print(writer, "", pugi::format_raw);
  return std::move(writer.text);
}

Error render_error(GError* cause) {
  const Owned<GError> owned(cause);
  return {ErrorCode::bad_input,
          std::string("the drawing cannot be rendered: ") + (cause ? cause->message : "unknown"),
          "svg"};
}

/// Premultiplied native-endian ARGB to straight RGBA.
Image8 straight_rgba(cairo_surface_t* surface, int width, int height) {
  Image8 image(width, height, 4);
  cairo_surface_flush(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<size_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      const uint32_t alpha = row[x] >> 24;
      const auto channel = [&](int shift) {
        const uint32_t value = row[x] >> shift & 255;
        return static_cast<uint8_t>(alpha ? std::min(255u, (value * 255 + alpha / 2) / alpha) : 0);
      };
      image.at(x, y, 0) = channel(16);
      image.at(x, y, 1) = channel(8);
      image.at(x, y, 2) = channel(0);
      image.at(x, y, 3) = static_cast<uint8_t>(alpha);
    }
  }
  return image;
}

Result<Drawing> rasterize(const std::string& text, const SvgCanvas& canvas, int width, int height) {
  GError* error = nullptr;
  const Owned<RsvgHandle> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(text.data()), text.size(), &error));
  if (!handle) return render_error(error);
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return Error{ErrorCode::limit, "not enough memory for the texture", "svg"};
  }
  const Owned<cairo_t> context(cairo_create(surface.get()));
  cairo_scale(context.get(), width / canvas.px_width, height / canvas.px_height);
  const RsvgRectangle viewport{0, 0, canvas.px_width, canvas.px_height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error)) {
    return render_error(error);
  }
  return Drawing{straight_rgba(surface.get(), width, height)};
}

}  // namespace

Result<Drawing> render_svg(std::string_view bytes, int width, int height,
                           const SvgOptions& options) {
  if (width < 1 || height < 1 || width > max_side || height > max_side ||
      static_cast<int64_t>(width) * height > max_pixels) {
    return Error{ErrorCode::limit,
                 "texture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " px is not in the limits",
                 "svg"};
  }
  auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto canvas = canvas_of(**document, options);
  if (!canvas) return canvas.error();
  const auto text = safe_text(**document, *canvas, options);
  if (!text) return text.error();
  return rasterize(*text, *canvas, width, height);
}

}  // namespace relievo
