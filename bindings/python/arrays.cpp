#include "bindings/python/arrays.h"

#include <algorithm>
#include <limits>
#include <string>

#include "bindings/python/errors.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

bool fits(py::ssize_t side) { return side > 0 && side <= std::numeric_limits<int>::max(); }

}  // namespace

py::array to_array(Image8 image) {
  auto owned = std::make_unique<Image8>(std::move(image));
  Image8& content = *owned;
  const py::capsule owner(owned.release(), [](void* p) { delete static_cast<Image8*>(p); });
  return view_image(content, owner);
}

Image8 to_image(const py::array& array, const char* what) {
  const py::ssize_t channels = array.ndim() == 3 ? array.shape(2) : 1;
  const bool is_picture = py::isinstance<py::array_t<uint8_t>>(array) &&
                          (array.ndim() == 2 || array.ndim() == 3) && fits(array.shape(0)) &&
                          fits(array.shape(1)) && (channels == 1 || channels == 3 || channels == 4);
  if (!is_picture)
    raise({ErrorCode::usage, "must be an array of height x width x 1, 3 or 4 bytes", what});
  const auto bytes = py::array_t<uint8_t, py::array::c_style>::ensure(array);
  Image8 image;
  image.width = static_cast<int>(array.shape(1));
  image.height = static_cast<int>(array.shape(0));
  image.channels = static_cast<int>(channels);
  image.pixels.assign(bytes.data(), bytes.data() + bytes.size());
  return image;
}

Drawing to_drawing(const py::object& array) {
  if (array.is_none()) return {};
  Image8 image = to_image(py::array::ensure(array), "drawing");
  if (image.channels == 4) return {std::move(image)};
  Drawing drawing{Image8(image.width, image.height, 4, 255)};
  const int step = image.channels == 3 ? 1 : 0;
  const size_t pixels = static_cast<size_t>(image.width) * image.height;
  for (size_t i = 0; i < pixels; ++i)
    for (int c = 0; c < 3; ++c)
      drawing.rgba.pixels[4 * i + c] = image.pixels[image.channels * i + step * c];
  return drawing;
}

std::vector<Point2> to_points(const py::handle& array, const std::string& where) {
  const auto numbers =
      py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!numbers) PyErr_Clear();
  if (!numbers || numbers.ndim() != 2 || numbers.shape(1) != 2)
    raise({ErrorCode::bad_input, "must be an array of n x 2 numbers", where});
  std::vector<Point2> points(numbers.shape(0));
  for (size_t i = 0; i < points.size(); ++i)
    points[i] = {numbers.data()[2 * i], numbers.data()[2 * i + 1]};
  return points;
}

py::array to_array(const std::vector<Point2>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  for (size_t i = 0; i < points.size(); ++i) {
    array.mutable_data()[2 * i] = points[i].x;
    array.mutable_data()[2 * i + 1] = points[i].y;
  }
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace relievo::python
