#include "relief/layers/flaps.h"

namespace relievo {

std::vector<uint8_t> find_flaps(const BaseMesh& base, const Sheets& sheets,
                                const Connection& connection, const Boundaries& boundaries,
                                const LocalOrder& order) {
  const auto lies_behind = [&](int face, int other) {
    return order.is_usual() || order.place[face] < order.place[other];
  };
  std::vector<uint8_t> flap(sheets.faces.size(), 0);
  std::vector<int> reached(sheets.faces.size(), -1);  // by the flap of which seam last
  std::vector<int> pending;
  for (size_t s = 0; s < connection.seams.size(); ++s) {
    const Seam& seam = connection.seams[s];
    const int number = static_cast<int>(s);
    if (boundaries.enclosed[s] != 0) continue;
    const auto take = [&](int face) {
      if (face < 0 || reached[face] == number || sheets.face_part[face] >= seam.upper) return;
      const int cover = sheets.face_of(sheets.face_triangle[face], seam.upper);
      if (cover < 0 || !lies_behind(face, cover)) return;
      reached[face] = number;
      flap[face] = 1;
      pending.push_back(face);
    };
    for (const int face : seam.covered) take(face);
    while (!pending.empty()) {
      const int face = pending.back();
      pending.pop_back();
      for (int k = 0; k < 3; ++k) take(face_across(base, sheets, face, k));
    }
  }
  return flap;
}

}  // namespace relievo
