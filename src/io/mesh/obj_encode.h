#pragma once

#include <string>

#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The three files of a model; `png` is empty where there is no drawing.
struct ObjFiles {
  Bytes obj;
  Bytes mtl;
  Bytes png;
};

/// Encodes the model as Wavefront OBJ: mm, longest side `options.size_mm`, right-handed, Y up,
/// front towards +Z, middle at x = y = 0 or grounded. Every position stands once, shared by all
/// parts; each part is one `o`; texture coordinates have v up. The file refers to the others as
/// "<name>.mtl" and
/// "<name>.png", where <name> is obj_file_name(file_name). Numbers do not depend on the locale.
/// Errors: as check_exportable.
Result<ObjFiles> encode_obj(const Model& model, const Drawing* drawing,
                            const ExportOptions& options = {},
                            const std::string& file_name = "model");

/// Returns `name` with '_' for every character that breaks an OBJ statement (spaces, controls, '#',
/// '\\'); "_" for an empty name.
std::string obj_file_name(const std::string& name);

}  // namespace relievo
