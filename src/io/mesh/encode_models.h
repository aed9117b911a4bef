#pragma once

#include <string>
#include <vector>

#include "io/archive/archive.h"
#include "relievo/bytes.h"
#include "relievo/export.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The model as binary glTF 2.0: metres, right-handed, Y up, front towards +Z, longest side
/// `size_mm`, middle at x = y = 0, drawing plane at z = 0. Every part with faces is a node named
/// by its id with its own compact vertices (equal, also in normals, along seams: readers drop or
/// copy vertices that a mesh shares with others) and extras {part, order, c, d}. The scene's extras
/// {canvas, origin, scale} lead back to canvas px: p_canvas = p / scale + origin.
///
/// The drawing (may be null) is embedded as an opaque PNG. The material is double-sided: a relief
/// is open at the back, and its inside must not vanish when it is turned. The same input always
/// gives the same bytes. Errors: as check_exportable; `limit` above 4 GB.
Result<Bytes> encode_glb(const Model& model, const Drawing* drawing, double size_mm = 100);

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

struct PlyOptions {
  double size_mm = 100;      ///< longest side
  std::string texture_file;  ///< named in a comment as TextureFile; none where empty
};

/// The model as binary little-endian PLY: mm, right-handed, Y up, front towards +Z, middle at
/// x = y = 0. Vertices have x y z nx ny nz s t (v up, as viewers of PLY expect) and, where there
/// is a drawing, the colour of its texture at that point. Errors: as check_exportable.
Result<Bytes> encode_ply(const Model& model, const Drawing* drawing,
                         const PlyOptions& options = {});

/// The model as binary STL: mm, longest side `size_mm`, lying on z = 0 with the height of the
/// relief as Z, or `standing` with the drawing's up as Z, in the positive octant. Errors: as
/// check_exportable.
Result<Bytes> encode_stl(const Model& model, double size_mm = 100, bool standing = false);

/// The model as the files of a 3MF package: mm, lying or standing as in an STL, one object whose
/// vertices at one place are one. With a drawing its triangles carry that as a texture (materials
/// extension), and are painted for several filaments, whose colours are listed in the package's
/// description. Precondition: the model is a closed manifold. Errors: as check_exportable;
/// `internal` where it cannot be packed.
Result<std::vector<ArchiveEntry>> threemf_entries(const Model& model, const Drawing* drawing,
                                                  const ExportOptions& options = {});

/// The same as the bytes of a file.
Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing,
                         const ExportOptions& options = {});

/// The model as a USDZ package, which phones show: one mesh with one material in USD's text form,
/// metres, Y up, front towards +Z, standing on y = 0, longest side `size_mm`. The drawing (may be
/// null) is its texture. Entries are stored, their data on multiples of 64 bytes, as the format
/// demands. The same input gives the same bytes. Errors: as check_exportable; `limit` above 4 GB.
Result<Bytes> encode_usdz(const Model& model, const Drawing* drawing, double size_mm = 100);

/// A page that shows the model in any browser with WebGL and needs nothing else, neither a network
/// nor a server: turned by dragging, nearer and farther by the wheel. The drawing (may be null) is
/// its texture. The same input gives the same bytes. Errors: as check_exportable.
Result<Bytes> encode_html(const Model& model, const Drawing* drawing, const std::string& title);

}  // namespace relievo
