#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layer_parts.h"
#include "relief/session/build_relief.h"
#include "relievo/point.h"
#include "relievo/scene.h"

namespace relievo::relief {

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

// What each stage reads, besides values of earlier stages.

/// Of join_sheets: geometry, joins, where ranges begin and end, and where creases lie.
Key sheets_key(const Scene& scene, const LayerOptions& options);

/// Of constrain_sheets: relations and what Robin ranges say.
Key layers_key(const Scene& scene, const LayerOptions& options);

/// What inflate reads of the mesh besides its triangulation.
Key boundary_key(const LayeredMesh& mesh);

/// Of inflate: amounts of inflation, and bulges.
Key inflation_key(const Scene& scene, const InflationOptions& options);

/// Of order_depth: constraints, which faces may cross, leans, and the cues that slope.
Key ordering_key(const LayeredMesh& mesh, const Scene& scene, const OrderingOptions& options);

/// Of solve_nonlinear, besides what the ordering reads.
Key nonlinear_key(const NonlinearOptions& options);

}  // namespace relievo::relief
