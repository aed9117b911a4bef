#pragma once

#include <string>

#include "relievo/result.h"

namespace relievo {

/// The error with a file's name in front of where it is, unless that begins with it already.
inline Error in_file(Error error, const std::string& name) {
  if (error.where.rfind(name, 0) != 0)
    error.where = error.where.empty() ? name : name + ": " + error.where;
  return error;
}

}  // namespace relievo
