#include "render/ray_scene.h"

#include <algorithm>
#include <limits>

namespace relievo {
namespace {

/// Fills the geometry's own buffers; returns false if there is no memory for them.
bool set_triangles(RTCGeometry geometry, const std::vector<Point3>& positions,
                   const std::vector<std::array<int, 3>>& triangles) {
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), triangles.size()));
  if (vertices == nullptr || indices == nullptr) return false;
  for (const Point3 p : positions)
    for (const double coordinate : {p.x, p.y, p.z}) *vertices++ = static_cast<float>(coordinate);
  for (const std::array<int, 3>& triangle : triangles)
    for (const int v : triangle) *indices++ = static_cast<unsigned>(v);
  return true;
}

constexpr unsigned ink_geometry = 1;

/// Lets rays pass through ink that faces away from the viewer.
void pass_backs(const RTCFilterFunctionNArguments* query) {
  RTCRayN* ray = query->ray;
  RTCHitN* hit = query->hit;
  const float along = RTCRayN_dir_x(ray, query->N, 0) * RTCHitN_Ng_x(hit, query->N, 0) +
                      RTCRayN_dir_y(ray, query->N, 0) * RTCHitN_Ng_y(hit, query->N, 0) +
                      RTCRayN_dir_z(ray, query->N, 0) * RTCHitN_Ng_z(hit, query->N, 0);
  if (along >= 0) query->valid[0] = 0;
}

/// Lets all rays to the light pass.
void pass_all(const RTCFilterFunctionNArguments* query) { query->valid[0] = 0; }

bool keep_building(void* context, double) {
  return !static_cast<const RunContext*>(context)->cancelled();
}

/// Least cosine between the normals of a face and a vertex at which the surface counts as curved.
constexpr double least_agreement = 0.35;

RTCRay make_ray(Point3 origin, Point3 direction, float length) {
  RTCRay ray = {};
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tfar = length;
  ray.mask = std::numeric_limits<unsigned>::max();
  return ray;
}

/// Turns a normal until it just faces the viewer: a smooth normal can look away from a viewer who
/// still sees the flat triangle.
Point3 facing(Point3 normal, Point3 back) {
  constexpr double least = 0.02;
  const double cosine = dot(normal, back);
  return cosine >= least ? normal : normalized(normal + (least - cosine) * back);
}

}  // namespace

Result<RayScene> RayScene::build(const Model& model, const InkMesh& lines,
                                 const RunContext& context) {
  RayScene result;
  // One thread: the tree, and with it which of two coinciding faces is hit, must not depend on
  // the machine's number of cores.
  result.device_.reset(rtcNewDevice("threads=1"));
  // It fails without memory, or on a processor that is too old.
  if (!result.device_)
    return Error{ErrorCode::limit,
                 "the ray tracer cannot be started, most likely because there is too little memory",
                 ""};
  RTCDevice device = result.device_.get();
  result.scene_.reset(rtcNewScene(device));
  RTCScene scene = result.scene_.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  RTCGeometry ink = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const bool has_ink = !lines.triangles.empty();
  const bool filled = set_triangles(geometry, model.positions, model.triangles) &&
                      (!has_ink || set_triangles(ink, lines.positions, lines.triangles));
  if (filled) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    if (has_ink) {
      rtcSetGeometryIntersectFilterFunction(ink, pass_backs);
      rtcSetGeometryOccludedFilterFunction(ink, pass_all);
      rtcCommitGeometry(ink);
      rtcAttachGeometryByID(scene, ink, ink_geometry);
    }
    rtcSetSceneProgressMonitorFunction(scene, keep_building, const_cast<RunContext*>(&context));
    rtcCommitScene(scene);
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
  }
  rtcReleaseGeometry(geometry);
  rtcReleaseGeometry(ink);
  if (context.cancelled()) return interrupted_error();
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE || !filled)
    return Error{ErrorCode::limit, "there is not enough memory to trace rays", ""};
  return result;
}

std::optional<RayHit> RayScene::first_hit(Point3 origin, Point3 direction) const {
  RTCRayHit query = {};
  query.ray = make_ray(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{static_cast<int>(query.hit.primID), static_cast<double>(query.hit.u),
                static_cast<double>(query.hit.v), query.hit.geomID == ink_geometry};
}

bool RayScene::blocked(Point3 origin, Point3 direction, double length) const {
  RTCRay ray = make_ray(origin, direction, static_cast<float>(length));
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_.get(), &context, &ray);
  return ray.tfar < 0;
}

Point2 texture_place(const Model& model, const RayHit& hit) {
  const auto& triangles = hit.is_ink ? model.ink.triangles : model.triangles;
  const std::vector<Point2>& uvs = hit.is_ink ? model.ink.uvs : model.uvs;
  const auto [a, b, c] = triangles[hit.triangle];
  return (1 - hit.u - hit.v) * uvs[a] + hit.u * uvs[b] + hit.v * uvs[c];
}

SurfacePoint surface_point(const Model& model, const RayHit& hit, Point3 back, double lift) {
  const std::array<int, 3>& corners = model.triangles[hit.triangle];
  const std::array<double, 3> weights = {1 - hit.u - hit.v, hit.u, hit.v};
  Point3 position;
  Point3 smooth;
  SurfacePoint point;
  for (size_t k = 0; k < 3; ++k) {
    position = position + weights[k] * model.positions[corners[k]];
    smooth = smooth + weights[k] * model.normals[corners[k]];
    point.uv = point.uv + weights[k] * model.uvs[corners[k]];
  }
  const Point3 edge = model.positions[corners[1]] - model.positions[corners[0]];
  const Point3 other = model.positions[corners[2]] - model.positions[corners[0]];
  const Point3 face = normalized(cross(edge, other));
  const double side = dot(face, back) < 0 ? -1 : 1;

  Point3 bulge;
  for (size_t k = 0; k < 3; ++k) {
    const Point3 normal = side * model.normals[corners[k]];
    if (dot(normal, side * face) < least_agreement) continue;
    const double below = dot(position - model.positions[corners[k]], normal);
    bulge = bulge + weights[k] * std::max(0.0, -below) * normal;
  }
  smooth = normalized(side * smooth);
  point.normal = facing(smooth == Point3{} ? side * face : smooth, back);
  point.face = side * face;
  point.ray_origin = position + bulge + lift * (side * face);
  return point;
}

}  // namespace relievo
