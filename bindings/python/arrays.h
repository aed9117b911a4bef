#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo::python {

/// Returns a view of `values` as an array of the given shape, which keeps `owner` alive.
template <class Number, class Value>
pybind11::array view(std::vector<Value>& values, std::vector<pybind11::ssize_t> shape,
                     const pybind11::handle& owner) {
  return pybind11::array_t<Number>(std::move(shape), reinterpret_cast<Number*>(values.data()),
                                   owner);
}

/// Returns a view of a list, with a row of numbers for each item.
template <class Number, class Value>
pybind11::array view_rows(std::vector<Value>& rows, const pybind11::handle& owner) {
  static_assert(sizeof(Value) % sizeof(Number) == 0);
  constexpr pybind11::ssize_t columns = sizeof(Value) / sizeof(Number);
  return view<Number>(rows, {static_cast<pybind11::ssize_t>(rows.size()), columns}, owner);
}

/// Returns a view of an image: height x width, or height x width x channels if there are several.
template <class T>
pybind11::array view_image(Image<T>& image, const pybind11::handle& owner) {
  std::vector<pybind11::ssize_t> shape = {image.height, image.width};
  if (image.channels > 1) shape.push_back(image.channels);
  return view<T>(image.pixels, std::move(shape), owner);
}

/// Moves an image into an array.
pybind11::array to_array(Image8 image);

/// Copies an array of height x width or height x width x 3 or 4 bytes to an image. Raises
/// UsageError for other arrays, which `what` names.
Image8 to_image(const pybind11::array& array, const char* what);

/// Copies an array to a drawing with four channels; empty for None.
Drawing to_drawing(const pybind11::object& array);

/// Convert points from and to an array of n x 2 numbers, which is read-only. Raise BadInputError
/// for other shapes, with the path `where`.
std::vector<Point2> to_points(const pybind11::handle& array, const std::string& where);
pybind11::array to_array(const std::vector<Point2>& points);

}  // namespace relievo::python
