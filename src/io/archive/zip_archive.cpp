#include "io/archive/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "io/image/jpeg_header.h"
#include "io/image/png.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

/// Frees what libzip hands out. An archive is dropped without being written.
struct ReleaseZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};

template <class T>
using OwnedZip = std::unique_ptr<T, ReleaseZip>;

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

Result<Bytes> content_of(zip_source_t* source) {
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

Error damaged(const std::string& reason, const std::string& entry = "") {
  return {ErrorCode::bad_input, "the archive is damaged: " + reason, entry};
}

Result<OwnedZip<zip_t>> open_archive(ByteView bytes) {
  zip_error_t error;
  zip_error_init(&error);
  const auto fail = [&error] {
    const Error result = damaged(zip_error_strerror(&error));
    zip_error_fini(&error);
    return result;
  };
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) return fail();
  OwnedZip<zip_t> archive(zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error));
  if (archive) return archive;
  zip_source_free(source);
  return fail();
}

Status check_entry(const zip_stat_t& stat, const ArchiveLimits& limits, uint64_t& room) {
  constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
  const std::string name = stat.name;
  if ((stat.valid & needed) != needed) return damaged("an entry has no size", name);
  if (stat.encryption_method != ZIP_EM_NONE)
    return Error{ErrorCode::bad_input, "is encrypted", name};
  if (!is_path_inside(name)) return Error{ErrorCode::bad_input, "leads out of the archive", name};
  if (stat.size > room || stat.size / limits.max_ratio > stat.comp_size)
    return Error{ErrorCode::limit, "is too large when unpacked", name};
  room -= stat.size;
  return Done{};
}

Result<Bytes> unpack(zip_t* archive, const zip_stat_t& stat) {
  const OwnedZip<zip_file_t> file(zip_fopen_index(archive, stat.index, 0));
  if (!file) return damaged(zip_strerror(archive), stat.name);
  Bytes bytes(stat.size);
  const zip_int64_t count = zip_fread(file.get(), bytes.data(), bytes.size());
  if (count != static_cast<zip_int64_t>(bytes.size())) return damaged("it ends early", stat.name);
  uint8_t beyond = 0;
  if (zip_fread(file.get(), &beyond, 1) != 0)
    return damaged("an entry does not agree with its directory", stat.name);
  return bytes;
}

/// Returns the checked directory entries of the files with these names, or of all.
Result<std::vector<zip_stat_t>> list_files(zip_t* archive, const ArchiveLimits& limits,
                                           const std::set<std::string>& wanted) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  if (wanted.empty() && count > static_cast<zip_int64_t>(limits.max_entries))
    return Error{ErrorCode::limit, "the archive has too many entries", ""};
  std::vector<zip_stat_t> files;
  std::set<std::string> names;
  uint64_t room = limits.max_bytes;
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &stat) != 0)
      return damaged(zip_strerror(archive));
    const std::string name = stat.name;
    if (!name.empty() && name.back() == '/') continue;
    if (!wanted.empty() && wanted.count(name) == 0) continue;
    if (!names.insert(name).second)
      return Error{ErrorCode::bad_input, "is in the archive twice", name};
    if (Status status = check_entry(stat, limits, room); !status) return status.error();
    files.push_back(stat);
  }
  return files;
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
  return content_of(buffer.get());
}

bool is_archive(ByteView bytes) {
  return bytes.size() >= 4 && bytes[0] == 'P' && bytes[1] == 'K' && bytes[2] == 3 && bytes[3] == 4;
}

Result<std::vector<ArchiveEntry>> unpack_archive(ByteView bytes, const ArchiveLimits& limits,
                                                 const std::set<std::string>& names) {
  if (!is_archive(bytes)) return damaged("it does not begin like one");
  const auto archive = open_archive(bytes);
  if (!archive) return archive.error();
  const auto files = list_files(archive->get(), limits, names);
  if (!files) return files.error();
  std::vector<ArchiveEntry> entries;
  for (const zip_stat_t& file : *files) {
    auto content = unpack(archive->get(), file);
    if (!content) return content.error();
    entries.push_back({file.name, std::move(*content)});
  }
  return entries;
}

}  // namespace relievo
