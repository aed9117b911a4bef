#include "apps/cli/version.h"

#include <CGAL/version.h>
#include <embree3/rtcore_config.h>
#include <png.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>

#define RELIEVO_TEXT_OF(name) #name
#define RELIEVO_TEXT(name) RELIEVO_TEXT_OF(name)

namespace relievo::cli {

std::string version_text() {
  const auto dotted = [](int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  std::string text = "relievo " RELIEVO_VERSION "\n";
  const std::string commit = RELIEVO_COMMIT;
  if (!commit.empty()) text += "revision: " + commit + "\n";
  text += "built: " RELIEVO_BUILD_TYPE ", C++ compiler " __VERSION__ "\n";
  text += "with: CGAL " RELIEVO_TEXT(CGAL_VERSION) ", Eigen " +
          dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) +
          ", Embree " RTC_VERSION_STRING ", CLI11 " CLI11_VERSION ", libpng " PNG_LIBPNG_VER_STRING;
  return text;
}

}  // namespace relievo::cli
