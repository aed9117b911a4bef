#include "apps/cli/table.h"

#include <algorithm>
#include <cstdio>

#include "apps/cli/messages.h"

namespace relievo::cli {
namespace {

/// Characters of UTF-8 text: all bytes but those that continue one.
size_t length(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

}  // namespace

std::string Table::text() const {
  std::vector<size_t> widths(rows_[0].size());
  for (const auto& row : rows_)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length(row[i]));
  std::string text;
  for (const auto& row : rows_) {
    for (size_t i = 0; i + 1 < row.size(); ++i)
      text += printable(row[i]) + std::string(widths[i] - length(row[i]) + 2, ' ');
    text += printable(row.back()) + "\n";
  }
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace relievo::cli
