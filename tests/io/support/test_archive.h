#pragma once

#include <gtest/gtest.h>
#include <zip.h>

#include <string>
#include <utility>
#include <vector>

#include "io/support/temporary_folder.h"

namespace relievo {

/// A zip archive of these entries, in order.
inline Bytes test_archive(const std::vector<std::pair<std::string, std::string>>& entries,
                          bool encrypted = false) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "test.zip").string();
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  for (const auto& [name, text] : entries) {
    zip_source_t* source = zip_source_buffer(archive, text.data(), text.size(), 0);
    const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    EXPECT_GE(index, 0) << name;
    if (encrypted)
      zip_file_set_encryption(archive, static_cast<zip_uint64_t>(index), ZIP_EM_AES_256, "key");
  }
  EXPECT_EQ(zip_close(archive), 0);
  return to_bytes(content(path));
}

}  // namespace relievo
