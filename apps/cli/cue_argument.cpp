#include "apps/cli/cue_argument.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "kernel/geometry/polyline.h"

namespace relievo::cli {
namespace {

Error misread(const char* message) { return {ErrorCode::usage, message, "--cue"}; }

/// Parses a comma-separated list of numbers; nothing if it contains anything else.
std::optional<std::vector<double>> numbers(std::string_view text) {
  std::vector<double> list;
  while (true) {
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc()) return std::nullopt;
    list.push_back(value);
    text.remove_prefix(static_cast<size_t>(end - text.data()));
    if (text.empty()) return list;
    if (text.front() != ',') return std::nullopt;
    text.remove_prefix(1);
  }
}

/// Removes the last colon and the text after it. Returns that text.
std::string_view take_last(std::string_view& text) {
  const size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return {};
  const std::string_view last = text.substr(colon + 1);
  text = text.substr(0, colon);
  return last;
}

}  // namespace

Result<CueArgument> parse_cue(const std::string& text) {
  std::string_view rest = text;
  const auto value = numbers(take_last(rest));
  const auto line = numbers(take_last(rest));
  const std::string_view kind = take_last(rest);
  CueArgument argument{std::string(rest), {}};
  bool known = false;
  for (const CueKind each : {CueKind::bulge, CueKind::slope, CueKind::crease}) {
    if (kind != name(each)) continue;
    argument.cue.kind = each;
    known = true;
  }
  if (!known || rest.empty())
    return misread("must be PART:KIND:X,Y,X,Y,...:VALUE, where KIND is bulge, slope or crease");
  if (!line || line->size() < 4 || line->size() % 2 != 0)
    return misread("needs a line of at least two points as X,Y,X,Y");
  if (!value || value->size() != 1) return misread("needs one number as its value");
  argument.cue.value = value->front();
  if (!has_sound_value(argument.cue))
    return misread(
        "has a value out of range: it must be 0.05 to 10 for a bulge, -75 to 75 degrees otherwise");
  for (size_t i = 0; i < line->size(); i += 2)
    argument.cue.line.push_back({(*line)[i], (*line)[i + 1]});
  return argument;
}

Status add_cues(const std::vector<CueArgument>& cues, Scene& scene) {
  for (const CueArgument& argument : cues) {
    const auto found = std::find_if(scene.parts.begin(), scene.parts.end(),
                                    [&](const Part& part) { return part.id == argument.part; });
    if (found == scene.parts.end())
      return Error{ErrorCode::usage, "no part has the id \"" + argument.part + "\"", "--cue"};
    scene.cues.push_back(argument.cue);
    scene.cues.back().part = static_cast<int>(found - scene.parts.begin());
  }
  return Done{};
}

std::vector<std::string> warnings_about_cues(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const Cue& cue : scene.cues) {
    const Part& part = scene.parts[cue.part];
    if (spans_inside(cue.line, part.outline).empty())
      warnings.push_back(std::string("a ") + name(cue.kind) + " of \"" + part.id +
                         "\" lies outside that part and has no effect");
  }
  return warnings;
}

}  // namespace relievo::cli
