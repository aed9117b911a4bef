#pragma once

#include <zip.h>

#include <memory>

namespace relievo {

/// Frees what libzip hands out. An archive is dropped without being written.
struct ReleaseZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};

template <class T>
using OwnedZip = std::unique_ptr<T, ReleaseZip>;

}  // namespace relievo
