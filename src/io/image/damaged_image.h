#pragma once

#include <string>

#include "relievo/result.h"

namespace relievo {

/// format: "PNG", say. reason: what is wrong in the file.
inline Error damaged_image(const std::string& format, const std::string& reason) {
  return {ErrorCode::bad_input, "the " + format + " file is damaged: " + reason, ""};
}

}  // namespace relievo
