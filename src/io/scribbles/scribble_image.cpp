#include "io/scribbles/scribble_image.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace relievo {
namespace {

constexpr size_t most_colours = 1000;
constexpr uint32_t black = 0x000000;
constexpr uint32_t mid_grey = 0x808080;
constexpr uint32_t white = 0xffffff;

/// The colour of a pixel, with a bit for soft strokes; `nothing` for no stroke.
using Paint = int64_t;
constexpr Paint nothing = -1;
constexpr Paint soft_bit = 1 << 24;

Paint paint_of(const uint8_t* rgba) {
  const uint32_t colour = uint32_t{rgba[0]} << 16 | uint32_t{rgba[1]} << 8 | rgba[2];
  if (rgba[3] < 64 || colour == white) return nothing;
  return colour | (rgba[3] < 192 ? soft_bit : 0);
}

std::string id_of(uint32_t colour) {
  std::array<char, 8> text = {};
  std::snprintf(text.data(), text.size(), "#%06x", colour);
  return text.data();
}

class ImageReader {
 public:
  explicit ImageReader(const Image8& rgba) : rgba_(rgba) {}

  Result<understanding::Scribbles> read() {
    scribbles_.complete = true;
    collect_colours();
    if (colours_.empty())
      return Error{ErrorCode::bad_input,
                   "no strokes were found in the scribble picture: paint them at least 3 px wide "
                   "in plain colours",
                   ""};
    if (colours_.size() > most_colours)
      return Error{ErrorCode::limit,
                   "the scribble picture has more than " + std::to_string(most_colours) +
                       " colours; paint without smooth edges",
                   ""};
    for (int y = 0; y < rgba_.height; ++y) collect_runs(y);
    for (size_t r = 0; r < runs_.size(); ++r)
      if (!runs_[r].visited) add_stroke(r);
    return std::move(scribbles_);
  }

 private:
  Paint at(int x, int y) const { return paint_of(&rgba_.at(x, y)); }

  bool fills_square(int x, int y) const {
    const Paint paint = at(x, y);
    for (int v = y - 1; v <= y + 1; ++v)
      for (int u = x - 1; u <= x + 1; ++u)
        if (at(u, v) != paint) return false;
    return true;
  }

  void collect_colours() {
    for (int y = 1; y + 1 < rgba_.height; ++y)
      for (int x = 1; x + 1 < rgba_.width; ++x) {
        const Paint paint = at(x, y);
        if (paint != nothing && colours_.count(paint) == 0 && fills_square(x, y))
          colours_.insert(paint);
      }
  }

  /// Neighbouring pixels of one paint in a row, end excluded.
  struct Run {
    Paint paint;
    int y, begin, end;
    bool visited = false;
  };

  void collect_runs(int y) {
    row_begin_.push_back(runs_.size());
    for (int begin = 0, end = 0; begin < rgba_.width; begin = end) {
      const Paint paint = at(begin, y);
      while (end < rgba_.width && at(end, y) == paint) ++end;
      if (paint != nothing && colours_.count(paint) > 0) runs_.push_back({paint, y, begin, end});
    }
  }

  /// Returns an unvisited run of the same paint that shares a side with run r.
  std::optional<size_t> next_to(size_t r) const {
    const Run& run = runs_[r];
    for (const int y : {run.y - 1, run.y + 1}) {
      if (y < 0 || y >= rgba_.height) continue;
      const size_t last = y + 1 < rgba_.height ? row_begin_[y + 1] : runs_.size();
      for (size_t n = row_begin_[y]; n < last; ++n) {
        const Run& other = runs_[n];
        if (!other.visited && other.paint == run.paint && other.begin < run.end &&
            run.begin < other.end)
          return n;
      }
    }
    return std::nullopt;
  }

  /// Adds one line through all runs connected with run r, never off their pixels: there and back
  /// along the branches of a tree.
  void add_stroke(size_t r) {
    understanding::Scribble stroke = stroke_of(runs_[r].paint);
    const auto go_to = [&](int x, int y) { stroke.points.push_back(Point2{x + 0.5, y + 0.5}); };
    const auto enter = [&](size_t run) {
      runs_[run].visited = true;
      go_to(runs_[run].begin, runs_[run].y);
      go_to(runs_[run].end - 1, runs_[run].y);
    };
    const auto cross_over = [&](size_t from, size_t to) {
      const int x = std::max(runs_[from].begin, runs_[to].begin);
      go_to(x, runs_[from].y);
      go_to(x, runs_[to].y);
    };
    std::vector<size_t> trail = {r};
    enter(r);
    while (!trail.empty()) {
      const size_t here = trail.back();
      if (const auto next = next_to(here)) {
        cross_over(here, *next);
        enter(*next);
        trail.push_back(*next);
        continue;
      }
      trail.pop_back();
      if (!trail.empty()) cross_over(here, trail.back());
    }
    scribbles_.strokes.push_back(std::move(stroke));
  }

  understanding::Scribble stroke_of(Paint paint) {
    understanding::Scribble stroke;
    const auto colour = static_cast<uint32_t>(paint & white);
    if (colour == black || colour == mid_grey) {
      stroke.kind = colour == black ? understanding::ScribbleKind::outside
                                    : understanding::ScribbleKind::hole;
      return stroke;
    }
    stroke.kind = (paint & soft_bit) != 0 ? understanding::ScribbleKind::soft
                                          : understanding::ScribbleKind::hard;
    stroke.part = part_of(colour);
    return stroke;
  }

  int part_of(uint32_t colour) {
    const auto [found, is_new] =
        part_of_colour_.emplace(colour, static_cast<int>(scribbles_.parts.size()));
    if (is_new) scribbles_.parts.push_back(id_of(colour));
    return found->second;
  }

  const Image8& rgba_;
  std::vector<Run> runs_;
  std::vector<size_t> row_begin_;  ///< [height] first run of each row
  std::set<Paint> colours_;
  std::map<uint32_t, int> part_of_colour_;
  understanding::Scribbles scribbles_;
};

}  // namespace

Result<understanding::Scribbles> scribbles_from_image(const Image8& rgba, int width, int height) {
  if (rgba.width != width || rgba.height != height)
    return Error{ErrorCode::bad_input,
                 "the scribble picture must be as large as the drawing, " + std::to_string(width) +
                     " x " + std::to_string(height) + " pixels",
                 ""};
  return ImageReader(rgba).read();
}

}  // namespace relievo
