#pragma once

#include <filesystem>
#include <string>

#include "apps/cli/batch/journal.h"

namespace relievo::cli {

/// Longest side of the thumbnails, px.
constexpr int sheet_size = 320;

/// Returns the path of the thumbnail of a drawing, relative to the output folder.
std::filesystem::path sheet_picture(const std::string& name);

/// Returns a contact sheet, an HTML page for the output folder. Each drawing has its thumbnail and
/// links to its files, or its error. The files of `entries` begin with `folder`.
std::string write_sheet(const JournalEntries& entries, const std::filesystem::path& folder);

}  // namespace relievo::cli
