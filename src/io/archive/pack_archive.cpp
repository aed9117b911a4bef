#include "io/archive/pack_archive.h"

#include <ctime>
#include <string>

#include "io/archive/archive.h"
#include "io/archive/zip_handles.h"
#include "io/image/jpeg_decode.h"
#include "io/image/png_decode.h"

namespace relievo {
namespace {

/// Takes half the time of the usual level 6, for files a twentieth larger.
constexpr zip_uint32_t level = 4;

Error failed(const std::string& reason) {
  return {ErrorCode::internal, "the archive cannot be made: " + reason, ""};
}

/// Returns the time that becomes the first of January 1980, since zip files hold local times.
std::time_t oldest_time() {
  std::tm date{};
  date.tm_year = 80;
  date.tm_mday = 1;
  date.tm_isdst = -1;
  return std::mktime(&date);
}

bool is_packed(const ArchiveEntry& entry) {
  return entry.name == "mimetype" || is_png(entry.bytes) || is_jpeg(entry.bytes);
}

Status add(zip_t* archive, const ArchiveEntry& entry) {
  zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
  if (source == nullptr) return failed(zip_strerror(archive));
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return failed(zip_strerror(archive));
  }
  const auto at = static_cast<zip_uint64_t>(index);
  const zip_int32_t method = is_packed(entry) ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
  if (zip_set_file_compression(archive, at, method, level) != 0 ||
      zip_file_set_mtime(archive, at, oldest_time(), 0) != 0)
    return failed(zip_strerror(archive));
  return Done{};
}

Result<Bytes> content(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0 ||
      zip_source_open(source) != 0)
    return failed("it cannot be read back");
  Bytes bytes(stat.size);
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (count != static_cast<zip_int64_t>(bytes.size())) return failed("it cannot be read back");
  return bytes;
}

}  // namespace

Result<Bytes> pack_archive(const std::vector<ArchiveEntry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  const OwnedZip<zip_source_t> buffer(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!buffer) return failed(zip_error_strerror(&error));
  // Closing the archive gives up its own hold on the source only.
  zip_source_keep(buffer.get());
  OwnedZip<zip_t> archive(zip_open_from_source(buffer.get(), ZIP_TRUNCATE, &error));
  if (!archive) {
    zip_source_free(buffer.get());
    return failed(zip_error_strerror(&error));
  }
  for (const ArchiveEntry& entry : entries)
    if (Status status = add(archive.get(), entry); !status) return status.error();
  if (zip_close(archive.get()) != 0) return failed(zip_strerror(archive.get()));
  // zip_close has freed it.
  static_cast<void>(archive.release());
  return content(buffer.get());
}

}  // namespace relievo
