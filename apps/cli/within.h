#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace relievo::cli {

/// Requires a number in [least, most]. Unlike CLI::Range, rejects "nan".
inline CLI::Validator within(double least, double most) {
  const CLI::Range range(least, most);
  const auto check = [=](std::string& value) -> std::string {
    double number = 0;
    if (CLI::detail::lexical_cast(value, number) && std::isnan(number))
      return value + " is not a number";
    return range(value);
  };
  return {check, range.get_description(), "range"};
}

}  // namespace relievo::cli
