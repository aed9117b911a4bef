#include "io/psd/psd_fill.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "relievo/point.h"

namespace relievo {
namespace {

constexpr size_t record_bytes = 26;  ///< of a vector mask
constexpr size_t max_knots = 4000;   ///< of all paths of a mask
constexpr int steps = 12;            ///< lines that a curve is flattened to
constexpr int fine_rows = 4;         ///< of a pixel, where its coverage is measured

/// A corner of a path with the ends of the curves to and from it, px.
struct Knot {
  Point2 before;
  Point2 at;
  Point2 after;
};

/// Takes a point, y first, in fractions of the canvas with 24 bits behind the point.
Point2 take_point(BigEndian& data, int width, int height) {
  constexpr double one = 1 << 24;
  const double y = data.i32() / one;
  const double x = data.i32() / one;
  return {x * width, y * height};
}

Ring flattened(const std::vector<Knot>& knots) {
  Ring ring;
  for (size_t k = 0; k < knots.size(); ++k) {
    const Knot& from = knots[k];
    const Knot& to = knots[(k + 1) % knots.size()];
    for (int i = 0; i < steps; ++i) {
      const double t = i / double(steps);
      const double u = 1 - t;
      ring.push_back(u * u * u * from.at + 3 * u * u * t * from.after + 3 * u * t * t * to.before +
                     t * t * t * to.at);
    }
  }
  return ring;
}

/// Adds the area of a path to those before it, by its operation: 0: exclude, 1: combine, 2:
/// subtract, 3: intersect, and -1: a further ring of the path before it.
Region combined(const Region& area, const Region& path, int operation) {
  if (operation == 1) return unite(area, path);
  if (operation == 2) return subtract(area, path);
  if (operation == 3) return intersect(area, path);
  return unite(subtract(area, path), subtract(path, area));
}

Region canvas_region(int width, int height) {
  return {{{0, 0}, {double(width), 0}, {double(width), double(height)}, {0, double(height)}}};
}

/// Reads the records of a vector mask one by one.
class MaskReader {
 public:
  MaskReader(int width, int height) : width_(width), height_(height) {}

  void take(BigEndian record) {
    const uint16_t kind = record.u16();
    if (kind == 0 || kind == 3) {
      end_path();
      record.skip(2);  // number of knots
      operation_ = record.i16();
    } else if (kind == 8) {
      if (record.u16() == 1) area_ = canvas_region(width_, height_);
    } else if (kind <= 5) {
      const Point2 before = take_point(record, width_, height_);
      const Point2 at = take_point(record, width_, height_);
      knots_.push_back({before, at, take_point(record, width_, height_)});
      ++count_;
    }
  }

  /// Returns the area of all paths, on the canvas.
  Region finish() {
    end_path();
    return intersect(area_, canvas_region(width_, height_));
  }

  size_t count() const { return count_; }

 private:
  void end_path() {
    if (knots_.size() > 1) {
      const Region path = unite(Region{flattened(knots_)}, Region());
      // A first path that is subtracted is taken from the whole canvas.
      if (first_ && operation_ > 1) area_ = canvas_region(width_, height_);
      area_ = combined(area_, path, operation_);
      first_ = false;
    }
    knots_.clear();
  }

  int width_;
  int height_;
  Region area_;
  std::vector<Knot> knots_;
  size_t count_ = 0;
  int operation_ = 1;
  bool first_ = true;
};

/// A side of a ring that is not level, from its upper to its lower end.
struct Side {
  Point2 upper;
  Point2 lower;
  double x_at(double y) const {
    return upper.x + (y - upper.y) / (lower.y - upper.y) * (lower.x - upper.x);
  }
};

std::vector<Side> sides_of(const Region& region) {
  std::vector<Side> sides;
  for (const Ring& ring : region)
    for (size_t k = 0; k < ring.size(); ++k) {
      const Point2 p = ring[k];
      const Point2 q = ring[(k + 1) % ring.size()];
      if (p.y != q.y) sides.push_back(p.y < q.y ? Side{p, q} : Side{q, p});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& p, const Side& q) { return p.upper.y < q.upper.y; });
  return sides;
}

/// Adds the covered share of each pixel of a row between two places on it.
void add_span(std::vector<double>& row, double from, double to) {
  const auto width = static_cast<double>(row.size());
  from = std::clamp(from, 0.0, width);
  to = std::clamp(to, 0.0, width);
  for (auto x = static_cast<size_t>(from); x < row.size() && double(x) < to; ++x)
    row[x] += std::min(to, double(x) + 1) - std::max(from, double(x));
}

}  // namespace

std::optional<std::array<uint8_t, 3>> fill_color(ByteView solid_fill) {
  const std::string_view text(reinterpret_cast<const char*>(solid_fill.data()), solid_fill.size());
  std::array<uint8_t, 3> rgb = {};
  const std::array<std::string_view, 3> keys = {"Rd  doub", "Grn doub", "Bl  doub"};
  for (size_t k = 0; k < 3; ++k) {
    const size_t at = text.find(keys[k]);
    if (at == std::string_view::npos) return std::nullopt;
    BigEndian data(solid_fill.subspan(at + keys[k].size()));
    const uint64_t bits = data.take(8);
    double value = 0;  // the browser's library has no std::bit_cast
    std::memcpy(&value, &bits, sizeof value);
    if (data.beyond() || !(value >= 0 && value <= 255)) return std::nullopt;
    rgb[k] = static_cast<uint8_t>(std::lround(value));
  }
  return rgb;
}

std::optional<Region> vector_mask(ByteView block, int width, int height) {
  BigEndian data(block);
  data.skip(4);  // version
  const uint32_t flags = data.u32();
  if (data.beyond() || (flags & 4) != 0) return std::nullopt;
  MaskReader reader(width, height);
  while (data.left() >= record_bytes && reader.count() <= max_knots)
    reader.take(BigEndian(data.bytes(record_bytes)));
  if (reader.count() > max_knots) return std::nullopt;
  const Region area = reader.finish();
  return (flags & 1) != 0 ? subtract(canvas_region(width, height), area) : area;
}

std::vector<uint8_t> coverage(const Region& region, const PixelBox& box) {
  const std::vector<Side> sides = sides_of(region);
  std::vector<uint8_t> values;
  std::vector<const Side*> active;
  size_t next = 0;
  for (int y = box.top; y < box.bottom; ++y) {
    std::vector<double> row(box.width(), 0);
    for (int fine = 0; fine < fine_rows; ++fine) {
      const double level = y + (fine + 0.5) / fine_rows;
      for (; next < sides.size() && sides[next].upper.y <= level; ++next)
        active.push_back(&sides[next]);
      std::erase_if(active, [&](const Side* side) { return side->lower.y <= level; });
      std::vector<double> crossings;
      for (const Side* side : active) crossings.push_back(side->x_at(level) - box.left);
      std::sort(crossings.begin(), crossings.end());
      for (size_t k = 0; k + 1 < crossings.size(); k += 2)
        add_span(row, crossings[k], crossings[k + 1]);
    }
    for (const double sum : row)
      values.push_back(static_cast<uint8_t>(std::lround(255 * std::min(sum / fine_rows, 1.0))));
  }
  return values;
}

}  // namespace relievo
