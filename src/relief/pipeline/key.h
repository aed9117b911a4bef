#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// The inputs of a computation, written one behind the other: two keys are equal exactly when all
/// inputs are.
class Key {
 public:
  /// Numbers and enumerations, which have no padding.
  template <class T>
  Key& add(T value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    bytes_.append(bytes, sizeof(T));
    return *this;
  }
  Key& add(Point2 p) { return add(p.x).add(p.y); }
  Key& add(std::string_view text) {
    add(text.size());
    bytes_.append(text);
    return *this;
  }
  Key& add(const Key& other) { return add(std::string_view(other.bytes_)); }
  template <class T>
  Key& add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
    return *this;
  }

  friend bool operator==(const Key&, const Key&) = default;

 private:
  std::string bytes_;
};

}  // namespace relievo
