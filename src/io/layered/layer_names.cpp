#include <algorithm>
#include <cctype>
#include <utility>

#include "io/layered/packed_layers.h"

namespace relievo {
namespace {

/// Compares names so that numbers in them count as numbers: leg2 before leg10.
bool natural_less(const std::string& p, const std::string& q) {
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

std::string stem(const std::string& name) {
  const size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace

Result<std::vector<LayerRow>> rows_of_names(std::vector<std::string> names) {
  if (names.size() > max_layers)
    return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers", ""};
  std::sort(names.begin(), names.end(), natural_less);
  std::vector<LayerRow> rows;
  for (std::string& name : names) {
    LayerRow row;
    row.layer.name = stem(name);
    row.file = std::move(name);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace relievo
