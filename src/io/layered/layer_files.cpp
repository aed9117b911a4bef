#include "io/layered/layer_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "io/image/png.h"
#include "io/layered/layer_names.h"
#include "kernel/base/text_rules.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

using Fields = std::vector<std::string_view>;

/// Largest distance of a layer from the canvas, px.
constexpr double farthest = 1e5;

Error line_error(size_t line, const std::string& message) {
  return {ErrorCode::bad_input, message, "line " + std::to_string(line)};
}

Fields split(std::string_view text, char separator) {
  Fields fields;
  while (true) {
    const size_t end = text.find(separator);
    fields.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

/// Reads a decimal number and nothing else. The browser's library has no std::from_chars for it.
std::optional<double> parse_number(std::string_view text) {
  if (text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) return std::nullopt;
  const std::string digits(text);
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  if (end != digits.c_str() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string range_text(double low, double high) {
  return std::to_string(std::lround(low)) + " to " + std::to_string(std::lround(high));
}

/// The fields of one line, by the names of their columns, and the first error in them.
class Row {
 public:
  Row(const std::map<std::string, size_t>& columns, Fields fields, size_t line)
      : columns_(columns), fields_(std::move(fields)), line_(line) {}

  std::string_view text(const char* column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end() || found->second >= fields_.size()) return {};
    return fields_[found->second];
  }

  /// Reads the number in a column; nothing where it is empty.
  std::optional<double> number(const char* column, double low, double high) {
    const std::string_view field = text(column);
    if (field.empty()) return std::nullopt;
    const auto value = parse_number(field);
    if (value && *value >= low && *value <= high) return value;
    fail(std::string(column) + " must be a number from " + range_text(low, high) + ", not " +
         std::string(field.substr(0, 40)));
    return std::nullopt;
  }

  /// Reads two numbers with a space between them.
  std::optional<Point2> pair(const char* column, double low, double high) {
    const std::string_view field = text(column);
    if (field.empty()) return std::nullopt;
    const Fields words = split(field, ' ');
    std::vector<double> numbers;
    for (const std::string_view word : words)
      if (const auto value = parse_number(word); value && *value >= low && *value <= high)
        numbers.push_back(*value);
    if (words.size() == 2 && numbers.size() == 2) return Point2{numbers[0], numbers[1]};
    fail(std::string(column) + " must be two numbers from " + range_text(low, high) +
         ", with a space between them, not " + std::string(field.substr(0, 40)));
    return std::nullopt;
  }

  Blending blending() {
    const std::string_view name = text("blend");
    const auto found = name.empty() ? Blending() : named_blending(name);
    if (!found) fail("blend must be a mode such as multiply or screen");
    return found.value_or(Blending());
  }

  LayerRole role() {
    const std::string_view role = text("role");
    if (role == "part") return LayerRole::part;
    if (role == "texture") return LayerRole::texture;
    if (!role.empty()) fail("role must be part, texture or empty");
    return LayerRole::proposed;
  }

  void fail(const std::string& message) {
    if (!error_) error_ = line_error(line_, message);
  }

  const std::optional<Error>& error() const { return error_; }
  size_t line() const { return line_; }

 private:
  const std::map<std::string, size_t>& columns_;
  Fields fields_;
  size_t line_;
  std::optional<Error> error_;
};

Result<LayerFile> read_row(Row row) {
  LayerFile result;
  RasterLayer& layer = result.layer;
  result.file = row.text("file");
  if (!is_path_inside(result.file)) row.fail("file must be a path inside the folder");
  layer.name = row.text("name");
  if (!layer.name.empty() && !is_sound_id(layer.name))
    row.fail("name is too long or not plain UTF-8");
  layer.role = row.role();
  layer.blending = row.blending();
  const auto order = row.number("order_back_to_front", -1e9, 1e9);
  result.order = order.value_or(static_cast<double>(row.line()));
  layer.x = static_cast<int>(std::lround(row.number("x", -farthest, farthest).value_or(0)));
  layer.y = static_cast<int>(std::lround(row.number("y", -farthest, farthest).value_or(0)));
  layer.opacity = row.number("opacity", 0, 1).value_or(1);
  layer.c = row.number("c", 0, max_inflation);
  layer.d = row.number("d", -max_inflation, max_inflation);
  layer.flat = row.number("flat", 0, 1);
  layer.lean = row.pair("lean", -max_lean, max_lean);
  if (row.error()) return *row.error();
  return result;
}

Result<std::map<std::string, size_t>> read_columns(std::string_view line) {
  std::map<std::string, size_t> columns;
  const Fields names = split(line, '\t');
  for (size_t k = 0; k < names.size(); ++k)
    if (!columns.emplace(names[k], k).second)
      return line_error(1, "column " + std::string(names[k].substr(0, 40)) + " is there twice");
  if (columns.count("file") == 0)
    return line_error(1, "has no column named file; the first line names the columns");
  return columns;
}

std::string stem(const std::string& name) {
  const size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

Error in_layer(Error error, const LayerFile& packed) {
  error.where = packed.file;
  return error;
}

/// Returns the smallest canvas, from the origin, that holds every layer to the right and below.
Result<ImageSize> least_canvas(const std::vector<LayerFile>& layers, const ImageLimits& limits) {
  int64_t width = 1;
  int64_t height = 1;
  for (const LayerFile& packed : layers) {
    const auto size = png_size(packed.png, limits);
    if (!size) return in_layer(size.error(), packed);
    width = std::max(width, int64_t{packed.layer.x} + size->width);
    height = std::max(height, int64_t{packed.layer.y} + size->height);
  }
  if (Status status = check_image_size(width, height, limits); !status) return status.error();
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

/// Checks the pixels of all layers together, which the time of reading is proportional to.
Status check_total(const std::vector<LayerFile>& layers, const ImageLimits& limits) {
  int64_t total = 0;
  for (const LayerFile& packed : layers) {
    const auto size = png_size(packed.png, limits);
    if (!size) return in_layer(size.error(), packed);
    const Status added = add_layer_pixels(size->width, size->height, limits, packed.file, total);
    if (!added) return added;
  }
  return Done{};
}

/// Checks for pictures of several sizes that all lie in the corner: sprites without their margins.
bool are_unplaced(const std::vector<LayerFile>& layers, const ImageLimits& limits) {
  bool differ = false;
  for (const LayerFile& packed : layers) {
    const auto first = png_size(layers.front().png, limits);
    const auto size = png_size(packed.png, limits);
    if (packed.layer.x != 0 || packed.layer.y != 0 || !first || !size) return false;
    differ |= size->width != first->width || size->height != first->height;
  }
  return differ;
}

}  // namespace

bool comes_before(const std::string& p, const std::string& q) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  size_t i = 0;
  size_t j = 0;
  while (i < p.size() && j < q.size()) {
    if (!is_digit(p[i]) || !is_digit(q[j])) {
      if (p[i] != q[j]) return p[i] < q[j];
      ++i, ++j;
      continue;
    }
    const auto number = [&](const std::string& text, size_t& at) {
      while (at + 1 < text.size() && text[at] == '0' && is_digit(text[at + 1])) ++at;
      const size_t start = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      return text.substr(start, at - start);
    };
    const std::string a = number(p, i);
    const std::string b = number(q, j);
    if (a.size() != b.size()) return a.size() < b.size();
    if (a != b) return a < b;
  }
  return p.size() - i != q.size() - j ? p.size() - i < q.size() - j : p < q;
}

Result<std::vector<LayerFile>> read_layer_table(std::string_view text) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  const Fields lines = split(text, '\n');
  const auto without_return = [](std::string_view line) {
    return !line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line;
  };
  const auto columns = read_columns(without_return(lines[0]));
  if (!columns) return columns.error();
  std::vector<LayerFile> rows;
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::string_view line = without_return(lines[i]);
    if (line.empty()) continue;
    auto row = read_row(Row(*columns, split(line, '\t'), i + 1));
    if (!row) return row.error();
    rows.push_back(std::move(*row));
    if (rows.size() > max_layers)
      return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers", ""};
  }
  if (rows.empty()) return Error{ErrorCode::bad_input, "lists no layer", ""};
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LayerFile& p, const LayerFile& q) { return p.order < q.order; });
  return rows;
}

Result<std::vector<LayerFile>> layers_of_names(std::vector<std::string> names) {
  if (names.size() > max_layers)
    return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers", ""};
  std::sort(names.begin(), names.end(), comes_before);
  std::vector<LayerFile> rows;
  for (std::string& name : names) {
    LayerFile row;
    row.layer.name = stem(name);
    row.file = std::move(name);
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<understanding::LayeredDrawing> unpack_layers(const std::vector<LayerFile>& layers,
                                                    std::vector<LayerGroup> groups,
                                                    ImageSize canvas, const ImageLimits& limits) {
  if (Status status = check_total(layers, limits); !status) return status.error();
  const bool open = canvas.width == 0 || canvas.height == 0;
  const auto size = open ? least_canvas(layers, limits) : Result<ImageSize>(canvas);
  if (!size) return size.error();
  LayerStack stack{std::move(groups), {}};
  for (const LayerFile& packed : layers) stack.layers.push_back(packed.layer);
  const auto pixels_of = [&](size_t k) -> Result<Image8> {
    auto pixels = decode_png(layers[k].png, limits);
    if (!pixels) return in_layer(pixels.error(), layers[k]);
    return pixels;
  };
  auto drawing = compose_layers(*size, std::move(stack), pixels_of, limits);
  if (drawing && open && are_unplaced(layers, limits))
    drawing->warnings.emplace_back(
        "the pictures differ in size, but nothing says where they lie, so all were put into the "
        "upper left corner; list them in layers.tsv with their x and y, or export them as large "
        "as the canvas");
  return drawing;
}

}  // namespace relievo
