#include "research/rivals/entem.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/geometry/triangles.h"
#include "research/rivals/contour.h"
#include "research/rivals/medial_axis.h"
#include "research/rivals/rival.h"

namespace relievo::research {
namespace {

/// Spacing of the samples of outlines / the diagonal of the drawing.
constexpr double sample_spacing = 1.0 / 500;
/// Minimum size of cells, as a share of the diagonal.
constexpr double smallest_cell = 1.0 / 400;
/// Depth to which a part is sunk into the part below / its radius.
constexpr double sinking = 0.3;

/// Length by which axes are extended / their last radius, so that the surface ends at the outline:
/// otherwise half of the kernel's line would be missing. Our reading.
constexpr double end_length = 0.75;

/// A place where two parts hold on to each other.
struct Link {
  int near = -1;  ///< the part in front
  int far = -1;
  bool joined = false;
  double area = 0;  ///< of the overlap, px^2; 0 for a join
  Point2 at;
};

/// Lists the joins and overlaps of parts.
std::vector<Link> find_links(const Scene& scene, const relief::LayeredMesh& mesh) {
  std::vector<Link> links;
  for (const Join& join : scene.joins)
    links.push_back({join.upper, join.lower, true, 0, join.line[join.line.size() / 2]});
  const std::vector<double> areas = triangle_areas({mesh.vertices, mesh.triangles});
  std::map<std::pair<int, int>, Link> overlaps;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point2 middle = (1.0 / 3) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f)
      for (int g = f + 1; g < mesh.stack_begin[t + 1]; ++g) {
        Link& link = overlaps[{mesh.face_part[f], mesh.face_part[g]}];
        link.area += areas[t];
        link.at = link.at + areas[t] * middle;
      }
  }
  for (const auto& [parts, link] : overlaps)
    links.push_back({parts.second, parts.first, false, link.area, (1 / link.area) * link.at});
  return links;
}

/// Computes half of the thickness that the discs of an axis give at a point.
double half_thickness(const MedialAxis& axis, Point2 p) {
  double most = 0;
  for (size_t i = 0; i < axis.centre.size(); ++i) {
    const double away = distance(axis.centre[i], p);
    const double square = axis.radius[i] * axis.radius[i] - away * away;
    most = std::max(most, std::sqrt(std::max(0.0, square)));
  }
  return most;
}

/// Returns the radius of the disc nearest to a point.
double radius_near(const MedialAxis& axis, Point2 p) {
  double nearest = Box2::infinity;
  double radius = 0;
  for (size_t i = 0; i < axis.centre.size(); ++i) {
    const double away = distance(axis.centre[i], p);
    if (away >= nearest) continue;
    nearest = away;
    radius = axis.radius[i];
  }
  return radius;
}

double largest_radius(const MedialAxis& axis) {
  return axis.radius.empty() ? 0 : *std::max_element(axis.radius.begin(), axis.radius.end());
}

/// Computes the depths of the axes. The thickest part is the trunk, at 0. The others follow from
/// part to part, by joins first and large overlaps next, and lie on the flank of the part that they
/// hold on to.
class Placement {
 public:
  Placement(const std::vector<MedialAxis>& axes, std::vector<Link> links)
      : axes_(axes), links_(std::move(links)), z_(axes.size(), 0), placed_(axes.size(), false) {}

  std::vector<double> run() {
    for (size_t i = 0; i < axes_.size(); ++i) {
      const int next = best_link();
      if (next < 0)
        placed_[thickest_left()] = true;
      else
        place_over(links_[next]);
    }
    return std::move(z_);
  }

 private:
  int best_link() const {
    int best = -1;
    for (size_t i = 0; i < links_.size(); ++i) {
      const Link& link = links_[i];
      if (placed_[link.near] == placed_[link.far]) continue;
      const auto rank = [](const Link& l) { return std::pair(l.joined, l.area); };
      if (best < 0 || rank(link) > rank(links_[best])) best = static_cast<int>(i);
    }
    return best;
  }

  size_t thickest_left() const {
    size_t thickest = 0;
    double radius = -1;
    for (size_t p = 0; p < axes_.size(); ++p)
      if (!placed_[p] && largest_radius(axes_[p]) > radius) {
        thickest = p;
        radius = largest_radius(axes_[p]);
      }
    return thickest;
  }

  void place_over(const Link& link) {
    const bool in_front = placed_[link.far];
    const int parent = in_front ? link.far : link.near;
    const int child = in_front ? link.near : link.far;
    const double flank = half_thickness(axes_[parent], link.at);
    const double sunk = sinking * radius_near(axes_[child], link.at);
    const double away = std::max(0.0, flank - sunk);
    z_[child] = z_[parent] + (in_front ? away : -away);
    placed_[child] = true;
  }

  const std::vector<MedialAxis>& axes_;
  std::vector<Link> links_;
  std::vector<double> z_;
  std::vector<bool> placed_;
};

void add_bones(const MedialAxis& axis, double z, double height, std::vector<Bone>& bones) {
  const auto place = [&](int i) { return Point3{axis.centre[i].x, height - axis.centre[i].y, z}; };
  std::vector<int> degree(axis.centre.size(), 0);
  for (const auto& edge : axis.edges)
    for (const int end : edge) ++degree[end];
  for (const auto& [a, b] : axis.edges) {
    bones.push_back({place(a), place(b), axis.radius[a], axis.radius[b]});
    for (const auto& [end, from] : {std::pair(a, b), std::pair(b, a)}) {
      if (degree[end] != 1) continue;
      const Point3 away = normalized(place(end) - place(from));
      const double radius = axis.radius[end];
      bones.push_back({place(end), place(end) + end_length * radius * away, radius, radius});
    }
  }
  if (axis.edges.empty() && !axis.centre.empty())
    bones.push_back({place(0), place(0), axis.radius[0], axis.radius[0]});
}

Model model_of(const TriangleSurface& surface, const Convolution& convolution, const Scene& scene) {
  Model model;
  model.width = scene.width;
  model.height = scene.height;
  model.positions = surface.positions;
  model.triangles = surface.triangles;
  for (const Point3 p : surface.positions) {
    model.normals.push_back(normalized(-1 * convolution.gradient(p)));
    model.uvs.push_back(
        {std::clamp(p.x / scene.width, 0.0, 1.0), std::clamp(1 - p.y / scene.height, 0.0, 1.0)});
  }
  ModelPart whole;
  whole.id = "figure";
  whole.triangle_count = static_cast<int>(surface.triangles.size());
  model.parts.push_back(whole);
  return model;
}

}  // namespace

Result<Model> reconstruct_entem(const RivalInput& input, const RunContext& context) {
  const Scene& scene = input.scene;
  Box2 box;
  for (const Part& part : scene.parts) box.add(bounding_box(part.outline));
  std::vector<MedialAxis> axes;
  for (const Part& part : scene.parts) {
    if (context.cancelled()) return interrupted_error();
    auto axis = medial_axis(part.outline, sample_spacing * box.diagonal());
    if (!axis) return axis.error();
    axes.push_back(std::move(*axis));
  }
  const std::vector<double> z = Placement(axes, find_links(scene, input.joined)).run();
  std::vector<Bone> bones;
  // Hollow parts are left out, since convolution surfaces have no hollows.
  for (size_t p = 0; p < axes.size(); ++p)
    if (scene.parts[p].d > 0) add_bones(axes[p], z[p], scene.height, bones);
  const Convolution convolution(std::move(bones));
  const auto surface =
      contour(convolution, input.options.cell, smallest_cell * box.diagonal(), context);
  if (!surface) return surface.error();
  return model_of(*surface, convolution, scene);
}

}  // namespace relievo::research
