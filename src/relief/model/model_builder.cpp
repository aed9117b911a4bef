#include "relief/model/model_builder.h"

#include <utility>

namespace relievo {

int ModelBuilder::add_vertex(Point2 canvas, double z, Point3 normal) {
  model_.positions.push_back({canvas.x, scene_.height - canvas.y, z});
  model_.normals.push_back(normal);
  model_.uvs.push_back({canvas.x / scene_.width, canvas.y / scene_.height});
  return static_cast<int>(model_.positions.size()) - 1;
}

int ModelBuilder::copy_vertex(int vertex, Point3 normal) {
  const Point3 position = model_.positions[vertex];
  const Point2 uv = model_.uvs[vertex];
  model_.positions.push_back(position);
  model_.normals.push_back(normal);
  model_.uvs.push_back(uv);
  return static_cast<int>(model_.positions.size()) - 1;
}

void ModelBuilder::add_triangle(int part, int a, int b, int c) {
  model_.triangles.push_back({a, b, c});
  triangle_part_.push_back(part);
}

void ModelBuilder::reserve(size_t vertices, size_t triangles) {
  model_.positions.reserve(vertices);
  model_.normals.reserve(vertices);
  model_.uvs.reserve(vertices);
  model_.triangles.reserve(triangles);
  triangle_part_.reserve(triangles);
}

Model ModelBuilder::build() && {
  model_.width = scene_.width;
  model_.height = scene_.height;
  for (const Part& part : scene_.parts)
    model_.parts.push_back({part.id, part.c, part.d, part.flat, 0, 0});
  for (const int part : triangle_part_) ++model_.parts[part].triangle_count;
  std::vector<int> next(model_.parts.size(), 0);
  for (size_t p = 1; p < model_.parts.size(); ++p) {
    const ModelPart& before = model_.parts[p - 1];
    next[p] = model_.parts[p].first_triangle = before.first_triangle + before.triangle_count;
  }
  std::vector<std::array<int, 3>> grouped(model_.triangles.size());
  for (size_t t = 0; t < grouped.size(); ++t)
    grouped[next[triangle_part_[t]]++] = model_.triangles[t];
  model_.triangles = std::move(grouped);
  return std::move(model_);
}

}  // namespace relievo
