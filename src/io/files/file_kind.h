#pragma once

#include <string>
#include <string_view>

#include "relievo/bytes.h"
#include "relievo/result.h"

namespace relievo {

/// The ways to read a file. Files of the last three kinds are not read: of other programs, texts,
/// and those that nothing is known about.
enum class InputKind { svg, json, sprites, image, psd, zip, glb, foreign, text, unknown };

/// The kind of a file by its content, whatever its name says.
struct FileKind {
  InputKind kind;
  std::string_view name;    ///< such as "a PDF document"
  std::string_view remedy;  ///< what to do where the file is not read; empty for common kinds
};

/// Returns the kind of a file. O(size of the file).
FileKind file_kind(ByteView bytes);

/// Returns the way to read a file.
InputKind sniff(ByteView bytes);

/// Returns an error that says what a file is and what to do with it.
Error refused_file(ByteView bytes);

}  // namespace relievo
