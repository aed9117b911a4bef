#pragma once

#include <string>
#include <vector>

namespace relievo::cli {

/// Text in aligned columns, a heading above each.
class Table {
 public:
  explicit Table(std::vector<std::string> headings) : rows_{std::move(headings)} {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.size() == 1; }
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// At most six significant digits.
std::string number(double value);

}  // namespace relievo::cli
