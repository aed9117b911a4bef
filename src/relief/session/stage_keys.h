#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/session/build_relief.h"
#include "relievo/point.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The inputs of a computation as bytes. Two keys of one computation are equal exactly if all
/// inputs are.
class Key {
 public:
  /// Appends numbers, enumerations, points, texts, keys and vectors of these.
  template <class... T>
  Key& add(const T&... values) {
    (append(values), ...);
    return *this;
  }

  friend bool operator==(const Key&, const Key&) = default;

 private:
  template <class T>
  void append(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);  // types without padding
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    bytes_.append(bytes, sizeof(T));
  }
  void append(Point2 p) { add(p.x, p.y); }
  void append(const std::string& text) {
    append(text.size());
    bytes_.append(text);
  }
  void append(const Key& other) { append(other.bytes_); }
  template <class T>
  void append(const std::vector<T>& values) {
    append(values.size());
    for (const T& value : values) append(value);
  }

  std::string bytes_;
};

// Each key holds what its stage reads, except values of earlier stages.

/// Returns the key of join_sheets: geometry, joins, ends of ranges, and lines of creases.
Key sheets_key(const Scene& scene, const LayerOptions& options);

/// Returns the key of constrain_sheets: relations and the values of Robin ranges.
Key layers_key(const Scene& scene, const LayerOptions& options);

/// Returns what inflate reads of the mesh besides its triangulation.
Key boundary_key(const LayeredMesh& mesh);

/// Returns the key of inflate: c, d, flat, and bulges.
Key inflation_key(const Scene& scene, const InflationOptions& options);

/// Returns the key of order_depth: constraints, relations, leans, slopes and creases.
Key ordering_key(const LayeredMesh& mesh, const Scene& scene, const OrderingOptions& options);

/// Returns what solve_nonlinear reads besides the inputs of order_depth.
Key nonlinear_key(const NonlinearOptions& options);

}  // namespace relievo::relief
