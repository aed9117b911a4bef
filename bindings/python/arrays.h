#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo::python {

/// The memory of `values` as an array of the given shape, which keeps `owner` alive.
template <class Number, class Value>
pybind11::array view(std::vector<Value>& values, std::vector<pybind11::ssize_t> shape,
                     const pybind11::handle& owner) {
  return pybind11::array_t<Number>(std::move(shape), reinterpret_cast<Number*>(values.data()),
                                   owner);
}

/// Likewise of the rows of a list, each of `columns` numbers.
template <class Number, class Value>
pybind11::array view_rows(std::vector<Value>& rows, const pybind11::handle& owner) {
  static_assert(sizeof(Value) % sizeof(Number) == 0);
  constexpr pybind11::ssize_t columns = sizeof(Value) / sizeof(Number);
  return view<Number>(rows, {static_cast<pybind11::ssize_t>(rows.size()), columns}, owner);
}

/// Likewise of an image: height x width, and x channels where there are several.
template <class T>
pybind11::array view_image(Image<T>& image, const pybind11::handle& owner) {
  std::vector<pybind11::ssize_t> shape = {image.height, image.width};
  if (image.channels > 1) shape.push_back(image.channels);
  return view<T>(image.pixels, std::move(shape), owner);
}

/// An array that owns the image.
pybind11::array to_array(Image8 image);

/// The picture in an array of height x width or height x width x 3 or 4 bytes, copied once.
/// Raises UsageError for other arrays; `what` is its name.
Image8 to_image(const pybind11::array& array, const char* what);

/// The same with four channels; empty for None.
Drawing to_drawing(const pybind11::object& array);

/// Points from and to an array of n x 2 numbers, which cannot be written to. Raises BadInputError
/// where it has another shape; `where` is the path of the culprit.
std::vector<Point2> to_points(const pybind11::handle& array, const std::string& where);
pybind11::array to_array(const std::vector<Point2>& points);

}  // namespace relievo::python
