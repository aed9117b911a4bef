#include <cstdint>

#include "fuzz/readers.h"

/// One run of libFuzzer on the reader that RELIEVO_READER names.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const relievo::fuzz::Reader read = relievo::fuzz::reader_of(RELIEVO_READER);
  read({data, size});
  return 0;
}
