#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// What a file holds, told by its content; or that it is a folder.
enum class InputKind { svg, json, image, psd, glb, zip, gzip, folder, unknown };

InputKind sniff(ByteView bytes);

struct InputFile {
  std::string name;  ///< as given; "-" is standard input
  Bytes bytes;
  bool folder = false;  ///< it is a folder, and `bytes` is empty
};

/// A drawing that is ready for reconstruction.
struct SceneInput {
  Scene scene;
  Drawing drawing;                           ///< empty where there is none
  std::future<Result<Drawing>> rendering;    ///< of `drawing`, while that is not finished
  std::string drawing_file;                  ///< whose picture it is; empty: no file of its own
  std::vector<std::filesystem::path> files;  ///< all that were read, never to be overwritten
  std::vector<std::string> warnings;
  std::vector<std::string> understood;  ///< what a flat picture was taken for, and what to correct
  bool proposed = false;                ///< the parts were guessed, not annotated
  bool connected = false;               ///< how they connect was guessed with them
  bool layered = false;                 ///< they are whole, and how they connect may be open
  understanding::PartColors colors;     ///< of the parts of layered drawings; may be empty
  std::vector<Point2> anchors;          ///< see LayeredDrawing; may be empty
  understanding::JoinProposals
      guesses;  ///< how they connect, where that was guessed; as in the scene
};

/// The picture of an SVG, its longest side `longest` px.
Result<Drawing> rasterize(const understanding::PaintableSvg& svg, double longest);

/// Reads the whole of a file, or of standard input where the name is "-". A folder is only named.
Result<InputFile> read_input(const std::string& name);

/// What load_scene gives, but for the pixels of an SVG: another thread renders them.
Result<SceneInput> start_scene(const InputFile& input, bool connect,
                               const RunContext& context = {});

/// Waits for the drawing.
Status finish_drawing(const InputFile& input, SceneInput& scene);

/// A scene from a layered drawing (SVG, OpenRaster, Photoshop, a folder of pictures), from a flat
/// picture, or from a scene file and the drawing that it names. Where `connect`, what a layered
/// drawing does not say of how its parts connect is guessed. The error's `where` begins with the
/// file's name.
Result<SceneInput> load_scene(const InputFile& input, bool connect, const RunContext& context = {});

}  // namespace relievo
