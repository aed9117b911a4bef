#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/interruption.h"
#include "kernel/image/image_size.h"
#include "relief/session/build_relief.h"
#include "relievo/export.h"
#include "relievo/render.h"
#include "relievo/scene.h"
#include "relievo/solid.h"
#include "solid/check_print.h"

namespace relievo::cli {

/// Arguments of every command.
struct CommonArguments {
  std::string input;  ///< a file, or "-" for standard input
  bool quiet = false;
  double timeout = 0;   ///< s; 0: none
  int threads = 0;      ///< 0: one per processor
  bool connect = true;  ///< guess how parts of a layered drawing connect if it does not say so
  std::optional<bool> pixel_art{};  ///< default: recognised by own_pixels
};

/// A cue on the part with the given id, which is looked up once the scene is known.
struct CueArgument {
  std::string part;
  Cue cue;
};

/// Arguments of the reconstruction.
struct ReliefArguments {
  relief::ReliefOptions options;
  std::optional<double> c;               ///< replaces the c of every part
  std::optional<double> flat;            ///< replaces the profile of every part
  std::optional<Point2> lean;            ///< replaces the tilt of every part
  std::vector<CueArgument> cues;         ///< added to those of the drawing
  bool as_in_paper = false;              ///< use the paper's c, d, profile and tilt for all parts
  std::optional<Visibility> visibility;  ///< of the surface; default: orbit
  Field field = Field::relief;
  std::optional<Ink> ink;  ///< default: usual_ink of files, shells in pictures
  double ink_width = 1;    ///< factor for the width of shells
  /// Make a closed solid in place of the surface; default: in files to print (prints_solids).
  std::optional<bool> solid;
  SolidOptions solid_options;    ///< their size is that of the outputs
  double nozzle = usual_nozzle;  ///< mm, of the printer that solids are checked for
};

/// Returns whether files to print hold closed solids.
inline bool prints_solids(const ReliefArguments& relief) {
  return relief.solid.value_or(!relief.visibility);
}

struct BuildArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::vector<std::string> models;  ///< .glb, .obj, .ply, .stl, .3mf, .usdz, .html
  double size_mm = 100;             ///< longest side of the model
  bool grounded = false;            ///< its lowest point is at height 0
  int texture_size = 0;             ///< longest side of the texture, px; 0: the drawing's own
  int triangles = 0;                ///< maximum in a model; 0: any number
  int levels = 1;                   ///< files of each model, each with half of the triangles
  bool one_mesh = false;            ///< write all parts as one mesh
  int filaments = 4;                ///< maximum number of colours of a .3mf
  Slicer slicer = Slicer::prusa;    ///< reads the paint of a .3mf
  std::string normal_map;           ///< files; empty: not wanted
  std::string depth_map;
  std::string part_map;
  std::string carve_map;
  std::string occlusion_map;
  std::string preview;
  std::string overlay;
  std::string convergence;
  std::string report;
  bool normal_y_down = false;
  int map_size = 0;           ///< longest side of the maps, px; 0: the default
  double px_per_mm = 10;      ///< of the carve map
  int preview_size = 1200;    ///< longest side, px
  bool print_report = false;  ///< on standard output
};

struct RenderArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::string output;
  std::optional<View> view = View::three_quarter;  ///< nothing: all views on a sheet
  std::optional<double> yaw;                       ///< degrees; replaces that of the view
  std::optional<double> pitch;                     ///< degrees; replaces that of the view
  std::vector<double> light;   ///< azimuth to the right and elevation, degrees; or empty
  int size = 1200;             ///< longest side, px
  bool clay = false;           ///< leave the drawing out
  std::vector<double> window;  ///< middle x, y and width, canvas px; or empty
};

struct BatchArguments {
  CommonArguments common;
  std::vector<std::string> inputs;          ///< drawings, folders, tables
  std::string output;                       ///< folder
  std::vector<std::string> make = {"glb"};  ///< outputs for each drawing
  std::vector<std::string> words;           ///< options of `build` for every drawing
  int jobs = 0;                             ///< drawings at once; 0: one per processor
  double memory_mb = 0;                     ///< for all of them; 0: most of the free memory
  int shard = 1;                            ///< number of the share to build, from 1
  int shards = 1;                           ///< into which the batch is divided
  bool retry = false;                       ///< build failed drawings again
  bool sheet = false;                       ///< make a contact sheet
  bool merge = false;                       ///< merge the journals of shards, and build nothing
};

struct SequenceArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::vector<std::string> inputs;                                ///< drawings, or one sprite sheet
  std::string output;                                             ///< folder
  std::vector<std::string> make = {"colour", "normal", "depth"};  ///< outputs for each frame
  std::optional<ImageSize> grid;  ///< columns and rows of a sheet without a list
  int columns = 0;                ///< of the sheet to write; 0: one file per frame
  int map_size = 0;               ///< longest side of a drawing's maps, px; 0: the default
  bool normal_y_down = false;
};

/// A command with its arguments. `run` returns the exit code.
struct Command {
  CommonArguments common;
  std::function<Result<int>(Interruption&)> run{};
};

/// A command, or an exit code if nothing is left to do: help, the version or a usage error has been
/// printed.
using ParsedArguments = std::variant<Command, int>;

ParsedArguments parse_arguments(int argc, const char* const* argv);

}  // namespace relievo::cli
