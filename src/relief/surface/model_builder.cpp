#include "relief/surface/model_builder.h"

#include <utility>

namespace relievo::relief {

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

void ModelBuilder::add_triangle(int part, bool hidden, int a, int b, int c) {
  model_.triangles.push_back({a, b, c});
  run_.push_back(2 * part + (hidden ? 1 : 0));
}

void ModelBuilder::reserve(size_t vertices, size_t triangles) {
  model_.positions.reserve(vertices);
  model_.normals.reserve(vertices);
  model_.uvs.reserve(vertices);
  model_.triangles.reserve(triangles);
  run_.reserve(triangles);
}

Model ModelBuilder::build() && {
  model_.width = scene_.width;
  model_.height = scene_.height;
  for (const Part& part : scene_.parts)
    model_.parts.push_back({part.id, part.c, part.d, part.flat, part.lean, 0, 0});
  for (const int run : run_) {
    ++model_.parts[run / 2].triangle_count;
    model_.parts[run / 2].hidden_count += run % 2;
  }
  std::vector<int> next;  // by run
  int first = 0;
  for (ModelPart& part : model_.parts) {
    part.first_triangle = first;
    first += part.triangle_count;
    next.insert(next.end(), {part.first_triangle, part.seen_end()});
  }
  std::vector<std::array<int, 3>> grouped(model_.triangles.size());
  for (size_t t = 0; t < grouped.size(); ++t) grouped[next[run_[t]]++] = model_.triangles[t];
  model_.triangles = std::move(grouped);
  return std::move(model_);
}

void drop_unused_vertices(Model& model) {
  std::vector<int> number(model.positions.size(), -1);
  for (const std::array<int, 3>& triangle : model.triangles)
    for (const int v : triangle) number[v] = 0;
  int count = 0;
  for (size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    model.positions[count] = model.positions[v];
    model.normals[count] = model.normals[v];
    model.uvs[count] = model.uvs[v];
    number[v] = count++;
  }
  model.positions.resize(count);
  model.normals.resize(count);
  model.uvs.resize(count);
  for (std::array<int, 3>& triangle : model.triangles)
    for (int& v : triangle) v = number[v];
}

}  // namespace relievo::relief
