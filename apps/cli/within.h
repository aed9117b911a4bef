#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace relievo::cli {

/// A usage error where the number is not in the range: CLI::Range lets "nan" pass.
inline CLI::Validator within(double least, double most) {
  const CLI::Range range(least, most);
  const auto check = [=](std::string& value) -> std::string {
    double number = 0;
    if (CLI::detail::lexical_cast(value, number) && std::isnan(number))
      return value + " is no number";
    return range(value);
  };
  return {check, range.get_description(), "range"};
}

}  // namespace relievo::cli
