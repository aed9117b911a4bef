#include "io/mesh/threemf_pack.h"

#include "io/archive/pack_archive.h"
#include "io/mesh/threemf_encode.h"

namespace relievo {

Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing, const ExportOptions& options) {
  const auto entries = threemf_entries(model, drawing, options);
  if (!entries) return entries.error();
  return pack_archive(*entries);
}

}  // namespace relievo
