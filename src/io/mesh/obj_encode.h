#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

struct ObjOptions {
  double size_mm = 100;        ///< longest side
  std::string name = "model";  ///< of the .mtl and .png files beside the .obj, no extension
};

/// The three files of a model; `png` is empty where there is no drawing.
struct ObjFiles {
  Bytes obj;
  Bytes mtl;
  Bytes png;
};

/// The model as Wavefront OBJ: mm, right-handed, Y up, front towards +Z, middle at x = y = 0;
/// every position once, shared by all parts, one `o` a part, texture coordinates with v up. It
/// refers to the other files as "<name>.mtl" and "<name>.png", where <name> is
/// obj_file_name(options.name). Numbers do not depend on the locale. Errors: as check_exportable.
Result<ObjFiles> encode_obj(const Model& model, const Drawing* drawing,
                            const ObjOptions& options = {});

/// `name` with every character that breaks an OBJ statement (spaces, controls, '#', '\\')
/// replaced by '_'; "_" where it is empty.
std::string obj_file_name(const std::string& name);

}  // namespace relievo
