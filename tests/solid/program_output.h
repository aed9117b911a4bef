#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace relievo::testing {

/// What a program prints; begins with "failed:" where it cannot be run or fails.
inline std::string output_of(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return "failed: cannot be run";
  std::string text;
  std::array<char, 4096> buffer{};
  for (size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), n);
  const bool done = pclose(pipe) == 0;
  return done ? text : "failed: " + text;
}

}  // namespace relievo::testing
