#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/file_kind.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"
#include "understanding/joins/join_proposals.h"
#include "understanding/marks/layered_drawing.h"

namespace relievo {

/// Returns a view of the content of a file as text.
inline std::string_view text_of(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct InputFile {
  std::string name;  ///< as given; "-" is standard input
  Bytes bytes;
  bool folder = false;  ///< it is a folder, and `bytes` is empty
};

/// A drawing that is ready for reconstruction.
struct SceneInput {
  Scene scene;
  Drawing drawing{};                           ///< empty if there is none
  std::future<Result<Drawing>> rendering{};    ///< of `drawing`, until finish_drawing
  std::string drawing_file{};                  ///< file of the picture; empty: none of its own
  std::vector<std::filesystem::path> files{};  ///< all files read, never to be overwritten
  std::vector<std::string> warnings{};
  std::vector<std::string> understood{};   ///< how a flat picture was understood, how to correct it
  bool proposed = false;                   ///< the parts were guessed, not annotated
  understanding::JoinProposals guesses{};  ///< the guessed connections among those of the scene
};

/// Renders an SVG, its longest side `longest` px.
Result<Drawing> rasterize(const understanding::PaintableSvg& svg, double longest);

/// Reads a file, or standard input if the name is "-". Of a folder only the name is kept.
Result<InputFile> read_input(const std::string& name);

/// Loads a scene as load_scene does, while another thread renders the pixels of an SVG.
Result<SceneInput> start_scene(const InputFile& input, bool connect,
                               const RunContext& context = {});

/// Waits for the drawing of start_scene.
Status finish_drawing(const InputFile& input, SceneInput& scene);

/// Loads a scene from a layered drawing (SVG, OpenRaster, Photoshop, a folder of pictures), from a
/// flat picture, or from a scene file and the drawing that it names. If `connect`, connections
/// between parts that the drawing does not state are guessed. Pixel art is recognised. The error's
/// `where` begins with the file's name.
Result<SceneInput> load_scene(const InputFile& input, bool connect, const RunContext& context = {});

}  // namespace relievo
