#include "relief/cues/bulge_field.h"

#include <Eigen/Core>

#include "relief/cues/harmonic.h"
#include "relief/cues/part_sheet.h"
#include "relief/cues/strokes.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// b at the vertices of the sheet.
VectorXd bulge_of(const PartSheet& sheet, const std::vector<StrokeContact>& contacts) {
  const auto vertices = static_cast<Eigen::Index>(sheet.positions.size());
  VectorXd sum = VectorXd::Zero(vertices);
  VectorXd weight = VectorXd::Zero(vertices);
  for (const StrokeContact& contact : contacts)
    for (const int v : sheet.triangles[contact.triangle]) {
      sum[v] += contact.cue->value;
      weight[v] += 1;
    }
  std::vector<uint8_t> fixed = sheet.rim;
  VectorXd values = VectorXd::Ones(vertices);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    if (weight[v] == 0 || fixed[v] != 0) continue;
    values[v] = sum[v] / weight[v];
    fixed[v] = 1;
  }
  return harmonic_extension({sheet.positions, sheet.triangles}, std::move(fixed), values, 1);
}

/// The mean over a triangle of the square of a linear function.
double mean_square(double a, double b, double c) {
  return (a * a + b * b + c * c + a * b + b * c + c * a) / 6;
}

}  // namespace

std::vector<double> bulge_factors(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<bool> wanted = parts_with(scene, {CueKind::bulge});
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return {};
  std::vector<double> factors(mesh.faces.size(), 1);
  const std::vector<PartSheet> sheets = part_sheets(mesh, wanted, AcrossCreases::whole, 1);
  for (size_t part = 0; part < sheets.size(); ++part) {
    const PartSheet& sheet = sheets[part];
    if (sheet.faces.empty()) continue;
    const VectorXd b =
        bulge_of(sheet, stroke_contacts(sheet, scene, static_cast<int>(part), CueKind::bulge, 1));
    for (size_t t = 0; t < sheet.faces.size(); ++t) {
      const auto [p, q, r] = sheet.triangles[t];
      factors[sheet.faces[t]] = mean_square(b[p], b[q], b[r]);
    }
  }
  return factors;
}

}  // namespace relievo
