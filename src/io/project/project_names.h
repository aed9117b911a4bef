#pragma once

#include <array>
#include <cstddef>

#include "relief/completion/completion.h"

namespace relievo {

/// A value and its name in project files.
template <class Value>
struct Spelling {
  const char* name;
  Value value;
};

inline constexpr std::array<Spelling<CompletionKind>, 5> completion_names = {
    {{"whole", CompletionKind::whole},
     {"ellipse", CompletionKind::ellipse},
     {"continuation", CompletionKind::continuation},
     {"membrane", CompletionKind::membrane},
     {"given", CompletionKind::given}}};

/// The name of a value.
template <class Value, size_t size>
const char* spelling(const std::array<Spelling<Value>, size>& names, Value value) {
  for (const auto& spelling : names)
    if (spelling.value == value) return spelling.name;
  return "";
}

}  // namespace relievo
