#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace relievo {

/// Numbers the vertices of triangles in the order of their first use, from 0.
class VertexNumbering {
 public:
  /// `vertices`: number of vertices that triangles may have.
  explicit VertexNumbering(size_t vertices) : number_(vertices, -1) {}

  /// Returns a triangle with its vertices' numbers.
  std::array<int, 3> of(std::array<int, 3> triangle) {
    for (int& v : triangle) {
      if (number_[v] < 0) {
        number_[v] = static_cast<int>(given_.size());
        given_.push_back(v);
      }
      v = number_[v];
    }
    return triangle;
  }

  /// Returns the vertices, by number.
  const std::vector<int>& given() const { return given_; }

  /// Forgets all numbers. O(numbers given).
  void restart() {
    for (const int v : given_) number_[v] = -1;
    given_.clear();
  }

 private:
  std::vector<int> number_;  ///< by vertex, or -1
  std::vector<int> given_;
};

}  // namespace relievo
