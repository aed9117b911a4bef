#include "io/archive/zip_archive.h"

#include <algorithm>
#include <set>
#include <utility>

#include "io/archive/archive.h"
#include "io/archive/zip_handles.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

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

/// Returns the checked directory entries of all files.
Result<std::vector<zip_stat_t>> list_files(zip_t* archive, const ArchiveLimits& limits) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  if (count > static_cast<zip_int64_t>(limits.max_entries))
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
    if (!names.insert(name).second)
      return Error{ErrorCode::bad_input, "is in the archive twice", name};
    if (Status status = check_entry(stat, limits, room); !status) return status.error();
    files.push_back(stat);
  }
  return files;
}

}  // namespace

bool is_archive(ByteView bytes) {
  return bytes.size() >= 4 && bytes[0] == 'P' && bytes[1] == 'K' && bytes[2] == 3 && bytes[3] == 4;
}

Result<std::vector<ArchiveEntry>> unpack_archive(ByteView bytes, const ArchiveLimits& limits) {
  if (!is_archive(bytes)) return damaged("it does not begin like one");
  const auto archive = open_archive(bytes);
  if (!archive) return archive.error();
  const auto files = list_files(archive->get(), limits);
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
