#pragma once

#include <string>

namespace relievo {

/// A scene file that uses every key.
inline std::string sample_scene() {
  return R"({
    "format": "relievo-scene", "version": 1,
    "canvas": { "width": 200, "height": 100.5 },
    "drawing": "art/figure.png",
    "parts": [
      { "id": "body", "outline": [ [[10,10],[90,10],[90,90],[10,90]], [[40,40],[60,40],[60,60],[40,60]] ] },
      { "id": "leg", "outline": [ [[20,70],[20,99],[35,99],[35,70]] ], "c": 2, "d": -0.5, "flat": 0.25,
        "lean": [0.5, -0.25] }
    ],
    "joins": [ { "upper": "leg", "lower": "body", "line": [[20,70],[35,70]] } ],
    "relations": [
      { "upper": "leg", "lower": "body", "relation": "equal", "range": [[20,72],[20,80]] },
      { "upper": "leg", "lower": "body", "relation": "above" },
      { "upper": "leg", "lower": "body", "relation": "free" },
      { "upper": "leg", "lower": "body", "relation": "below", "range": [[35,88],[35,72]] } ],
    "robin": [ { "upper": "leg", "lower": "body", "from": [35,70], "to": [35,90], "alpha0": 0.1, "rho": 0.25 } ],
    "cues": [
      { "part": "body", "kind": "bulge", "line": [[15,15],[30,30],[30,50]], "value": 1.5 },
      { "part": "leg", "kind": "slope", "line": [[25,75],[25,95]], "value": -30 },
      { "part": "leg", "kind": "crease", "line": [[22,80],[33,80.5]], "value": 45 } ]
  })";
}

/// `text` with the first `from` replaced by `to`; empty where `from` is not there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

}  // namespace relievo
