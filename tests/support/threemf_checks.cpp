#include "support/threemf_checks.h"

#include <Model/COM/NMR_DLLInterfaces.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <array>
#include <memory>

namespace relievo {
namespace {

using namespace NMR;

struct Release {
  void operator()(PLib3MFBase* object) const { lib3mf_release(object); }
};
template <class T>
using Held = std::unique_ptr<T, Release>;

std::vector<std::string> warnings_of(PLib3MFModelReader* reader) {
  DWORD count = 0;
  lib3mf_reader_getwarningcount(reader, &count);
  std::vector<std::string> warnings;
  for (DWORD i = 0; i < count; ++i) {
    std::array<char, 1024> text{};
    DWORD code = 0;
    ULONG needed = 0;
    lib3mf_reader_getwarningutf8(reader, i, &code, text.data(), text.size(), &needed);
    warnings.emplace_back(text.data());
  }
  return warnings;
}

void count_object(PLib3MFModelMeshObject* mesh, ThreemfCensus& census) {
  DWORD triangles = 0;
  BOOL sound = 0;
  lib3mf_meshobject_gettrianglecount(mesh, &triangles);
  lib3mf_meshobject_ismanifoldandoriented(mesh, &sound);
  ++census.objects;
  census.triangles += static_cast<int>(triangles);
  census.manifold = census.manifold && sound != 0;
}

}  // namespace

ThreemfCensus census_of_3mf(const Bytes& package) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler the_library_leaks;
#endif
  ThreemfCensus census;
  PLib3MFModel* model = nullptr;
  if (lib3mf_createmodel(&model) != 0) return census;
  const Held<PLib3MFModel> held_model(model);
  PLib3MFModelReader* reader = nullptr;
  if (lib3mf_model_queryreader(model, "3mf", &reader) != 0) return census;
  const Held<PLib3MFModelReader> held_reader(reader);
  Bytes copy = package;
  census.readable = lib3mf_reader_readfrombuffer(reader, copy.data(), copy.size()) == 0;
  census.warnings = warnings_of(reader);
  PLib3MFModelResourceIterator* objects = nullptr;
  if (lib3mf_model_getmeshobjects(model, &objects) != 0) return census;
  const Held<PLib3MFModelResourceIterator> held_objects(objects);
  BOOL more = 0;
  while (lib3mf_resourceiterator_movenext(objects, &more) == 0 && more != 0) {
    PLib3MFModelResource* object = nullptr;
    if (lib3mf_resourceiterator_getcurrent(objects, &object) != 0) break;
    const Held<PLib3MFModelResource> held_object(object);
    count_object(object, census);
  }
  return census;
}

}  // namespace relievo
