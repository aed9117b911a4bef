#include "io/archive/archive.h"
#include "io/mesh/encode_models.h"

namespace relievo {

Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing, const ExportOptions& options) {
  const auto entries = threemf_entries(model, drawing, options);
  if (!entries) return entries.error();
  return pack_archive(*entries);
}

}  // namespace relievo
