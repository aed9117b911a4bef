#include "io/mesh/stl_encode.h"

#include <string>

#include "io/files/byte_writer.h"
#include "io/mesh/placement.h"

namespace relievo {
namespace {

constexpr size_t header_size = 80;
constexpr size_t triangle_size = 50;

}  // namespace

Result<Bytes> encode_stl(const Model& model, double size_mm, bool standing) {
  if (Status status = check_exportable(model, size_mm); !status) return status.error();
  const Placement placement = octant_placement(model, size_mm, standing);
  Bytes stl;
  stl.reserve(header_size + 4 + triangle_size * model.triangles.size());
  append_text(stl, "relievo " RELIEVO_VERSION ", binary STL, millimetres");
  stl.resize(header_size, ' ');
  append_u32(stl, static_cast<uint32_t>(model.triangles.size()));
  for (const std::array<int, 3>& triangle : model.triangles) {
    const Point3 a = place(placement, model.positions[triangle[0]]);
    const Point3 b = place(placement, model.positions[triangle[1]]);
    const Point3 c = place(placement, model.positions[triangle[2]]);
    for (const Point3 p : {normalized(cross(b - a, c - a)), a, b, c})
      append_f32s(stl, {p.x, p.y, p.z});
    append_u16(stl, 0);
  }
  return stl;
}

}  // namespace relievo
