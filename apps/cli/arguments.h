#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/image_size.h"
#include "relief/session/build_relief.h"
#include "relievo/export.h"
#include "relievo/scene.h"
#include "relievo/solid.h"
#include "rivals/rival.h"
#include "solid/check_print.h"

namespace relievo::cli {

/// What all commands take.
struct CommonArguments {
  std::string input;  ///< a file, or "-" for standard input
  bool quiet = false;
  double timeout = 0;   ///< s; 0: none
  int threads = 0;      ///< 0: as many as the machine has
  bool connect = true;  ///< guess how the parts of a layered drawing connect where it does not say
};

/// A cue for a part that has yet to be found in the scene.
struct CueArgument {
  std::string part;  ///< id
  Cue cue;
};

/// How a drawing is reconstructed.
struct ReliefArguments {
  relief::ReliefOptions options;
  std::optional<double> c;        ///< in place of every part's own
  std::optional<double> flat;     ///< likewise
  std::optional<Point2> lean;     ///< likewise
  std::vector<CueArgument> cues;  ///< besides those of the drawing
  bool as_in_paper = false;       ///< c, d, profile and lean of all parts as the paper has them
  std::optional<Visibility> visibility;  ///< orbit where nothing is said, relief in files to print
  Field field = Field::relief;
  bool solid = false;            ///< something to hold, in place of the surface
  SolidOptions solid_options;    ///< its size is that of the outputs
  double nozzle = usual_nozzle;  ///< mm, of the printer that a solid is checked for
};

struct BuildArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::vector<std::string> models;  ///< .glb, .obj, .ply, .stl, .3mf, .usdz, .html
  double size_mm = 100;             ///< longest side of the model
  int triangles = 0;                ///< that models have at most; 0: any
  int levels = 1;                   ///< files of each model, each with half of the triangles
  bool one_mesh = false;            ///< all parts as one
  int filaments = 4;                ///< colours that a .3mf is painted with at most
  Slicer slicer = Slicer::prusa;    ///< that it is painted for
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
  int map_size = 2048;        ///< longest side of the maps, px
  double px_per_mm = 10;      ///< of the carve map
  int preview_size = 1200;    ///< longest side, px
  bool print_report = false;  ///< on standard output
};

struct CheckArguments {
  CommonArguments common;
  std::string output;      ///< scene .json; empty: not wanted
  std::string overlay;     ///< file; empty: not wanted
  ReliefArguments relief;  ///< of which what is said of solids is used
};

struct RenderArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::string output;
  std::string view = "three-quarter";  ///< front, three-quarter, side or sheet
  std::optional<double> yaw;           ///< degrees, in place of the view's
  std::optional<double> pitch;         ///< likewise
  std::vector<double> light;           ///< azimuth to the right and elevation, degrees; or empty
  int size = 1200;                     ///< longest side, px
  bool clay = false;                   ///< without the drawing
  std::vector<double> window;          ///< middle x, y and width, canvas px; or empty
};

struct SegmentArguments {
  CommonArguments common;
  std::string labels;     ///< files; empty: found in the drawing, or those of the project
  std::string scribbles;  ///< .png or .json
  std::string figure;     ///< what of the drawing is the figure (.png); empty: found
  int parts = 0;          ///< so many are proposed; 0: as many as are found
  std::string output;     ///< project .relievo or scene .json
  std::string overlay;    ///< files; empty: not wanted
  std::string report;
};

/// A share of a batch: of every `count` drawings the one of this index, from 1.
struct Shard {
  int index = 1;
  int count = 1;
};

struct BatchArguments {
  CommonArguments common;
  std::vector<std::string> inputs;          ///< drawings, folders, tables
  std::string output;                       ///< folder
  std::vector<std::string> make = {"glb"};  ///< of each drawing
  std::vector<std::string> words;           ///< options of `build` for every drawing
  int jobs = 0;                             ///< at once; 0: as many as there are processors
  double memory_mb = 0;                     ///< for all of them; 0: most of what is free
  Shard shard;
  bool retry = false;  ///< build those again that failed
  bool sheet = false;  ///< make a contact sheet
  bool merge = false;  ///< the journals of shards, and build nothing
};

struct SequenceArguments {
  CommonArguments common;
  ReliefArguments relief;
  std::vector<std::string> inputs;  ///< drawings, or one sheet of sprites
  std::string output;               ///< folder
  std::vector<std::string> make = {"colour", "normal", "depth"};  ///< of each frame
  std::optional<ImageSize> grid;  ///< columns and rows of a sheet without a list
  int columns = 0;                ///< of the sheet that the frames are put on; 0: one file a frame
  int map_size = 1024;            ///< longest side of a drawing's maps, px
  bool normal_y_down = false;
};

struct CompareArguments {
  CommonArguments common;
  ReliefArguments relief;  ///< of which the mesh's options alone are used
  std::string method;      ///< name of a rival
  RivalOptions options;
  std::vector<std::string> models;  ///< .glb, .obj, .ply, .stl
  std::string graft_mask;           ///< file; empty: none
  std::string preview;              ///< files; empty: not wanted
  std::string normal_map;
  std::string depth_map;
  std::string report;
  int map_size = 1024;  ///< longest side of the maps, px
};

using Command = std::variant<BuildArguments, CheckArguments, CompareArguments, RenderArguments,
                             SegmentArguments, BatchArguments, SequenceArguments>;

/// The command, or the exit code where there is nothing more to do: help or the version was
/// printed on standard output, or what is wrong was told on standard error.
using ParsedArguments = std::variant<Command, int>;

ParsedArguments parse_arguments(int argc, const char* const* argv);

}  // namespace relievo::cli
