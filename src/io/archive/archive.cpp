#include "io/archive/archive.h"

#include <zlib.h>

#include <cstdint>
#include <limits>

#include "io/files/byte_writer.h"

namespace relievo {
namespace {

constexpr size_t alignment = 64;
constexpr size_t local_header = 30;
constexpr size_t extra_header = 4;
/// Id of an extra field for padding, as the tools of the format's authors write it.
constexpr uint16_t padding_field = 0x1986;
constexpr uint16_t version = 20;
constexpr uint16_t first_of_1980 = (1 << 5) | 1;

uint32_t checksum(const Bytes& bytes) {
  uLong crc = crc32(0, nullptr, 0);
  return static_cast<uint32_t>(crc32_z(crc, bytes.data(), bytes.size()));
}

/// Appends the fields that both headers of an entry have.
void append_facts(Bytes& zip, const ArchiveEntry& entry, size_t padding) {
  append_u16(zip, version);
  append_u16(zip, 0);  // flags
  append_u16(zip, 0);  // stored
  append_u16(zip, 0);  // midnight
  append_u16(zip, first_of_1980);
  append_u32(zip, checksum(entry.bytes));
  append_u32(zip, static_cast<uint32_t>(entry.bytes.size()));
  append_u32(zip, static_cast<uint32_t>(entry.bytes.size()));
  append_u16(zip, static_cast<uint16_t>(entry.name.size()));
  append_u16(zip, static_cast<uint16_t>(padding));
}

void append_entry(Bytes& zip, const ArchiveEntry& entry) {
  const size_t used = zip.size() + local_header + entry.name.size() + extra_header;
  const size_t fill = (alignment - used % alignment) % alignment;
  append_text(zip, "PK\3\4");
  append_facts(zip, entry, extra_header + fill);
  append_text(zip, entry.name);
  append_u16(zip, padding_field);
  append_u16(zip, static_cast<uint16_t>(fill));
  zip.insert(zip.end(), fill, 0);
  zip.insert(zip.end(), entry.bytes.begin(), entry.bytes.end());
}

void append_directory(Bytes& zip, const ArchiveEntry& entry, size_t offset) {
  append_text(zip, "PK\1\2");
  append_u16(zip, version);
  append_facts(zip, entry, 0);
  append_u16(zip, 0);  // comment
  append_u16(zip, 0);  // disk
  append_u16(zip, 0);  // internal attributes
  append_u32(zip, 0);  // external attributes
  append_u32(zip, static_cast<uint32_t>(offset));
  append_text(zip, entry.name);
}

}  // namespace

Result<Bytes> pack_aligned(const std::vector<ArchiveEntry>& entries) {
  size_t total = 0;
  for (const ArchiveEntry& entry : entries) total += entry.bytes.size() + 1000;
  if (total > std::numeric_limits<uint32_t>::max())
    return Error{ErrorCode::limit, "the archive would be larger than 4 GB", ""};
  Bytes zip;
  zip.reserve(total);
  std::vector<size_t> offsets;
  for (const ArchiveEntry& entry : entries) {
    offsets.push_back(zip.size());
    append_entry(zip, entry);
  }
  const size_t directory = zip.size();
  for (size_t i = 0; i < entries.size(); ++i) append_directory(zip, entries[i], offsets[i]);
  const size_t length = zip.size() - directory;
  append_text(zip, "PK\5\6");
  append_u32(zip, 0);  // disks
  append_u16(zip, static_cast<uint16_t>(entries.size()));
  append_u16(zip, static_cast<uint16_t>(entries.size()));
  append_u32(zip, static_cast<uint32_t>(length));
  append_u32(zip, static_cast<uint32_t>(directory));
  append_u16(zip, 0);  // comment
  return zip;
}

}  // namespace relievo
