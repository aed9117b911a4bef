#pragma once

#include <filesystem>
#include <string>

#include "apps/cli/batch/journal.h"

namespace relievo::cli {

/// Longest side of the small pictures, px.
constexpr int sheet_size = 320;

/// Where the small picture of a drawing lies, from the folder of results.
std::filesystem::path sheet_picture(const std::string& name);

/// A contact sheet: a page of HTML to lie in the folder of results, `folder` as the journal's files
/// begin. Each drawing has its picture, or why there is none, and links to its files.
std::string write_sheet(const JournalEntries& entries, const std::filesystem::path& folder);

}  // namespace relievo::cli
