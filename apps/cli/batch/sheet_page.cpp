#include "apps/cli/batch/sheet_page.h"

#include <glib.h>

#include <algorithm>
#include <memory>

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Contact sheet</title>
<style>
  body { margin: 2rem; font: 15px/1.4 system-ui, sans-serif; color: #222; background: #f6f5f2; }
  main { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(200px, 1fr)); }
  figure { margin: 0; padding: .6rem; border-radius: 8px; background: #fff; }
  img { width: 100%; aspect-ratio: 1; object-fit: contain; }
  figcaption { overflow-wrap: anywhere; }
  .failed { background: #fbe9e7; }
  .failed p { color: #8c1d10; }
  a { color: inherit; }
</style>
)";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string address(const fs::path& path) {
  const std::unique_ptr<char, decltype(&g_free)> encoded(
      g_uri_escape_string(path.generic_string().c_str(), "/", FALSE), g_free);
  return encoded.get();
}

/// Returns the part of a file's path that follows the name of its drawing.
std::string label(const fs::path& path, const std::string& name) {
  const std::string text = path.generic_string();
  return text.starts_with(name) ? text.substr(name.size() + 1) : text;
}

std::string figure(const JournalEntry& entry, const fs::path& folder) {
  const std::string name = escaped(entry.name);
  if (entry.code != 0)
    return "<figure class=\"failed\"><figcaption>" + name + "<p>" + escaped(entry.message) +
           "</p></figcaption></figure>\n";
  std::string picture;
  std::string links;
  for (const std::string& file : entry.files) {
    const fs::path path = fs::path(file).lexically_relative(folder);
    if (path == sheet_picture(entry.name) || path == entry.name + "-preview.png")
      picture = "<img loading=\"lazy\" alt=\"" + name + "\" src=\"" + address(path) + "\">";
    else
      links += " <a href=\"" + address(path) + "\">" + escaped(label(path, entry.name)) + "</a>";
  }
  return "<figure>" + picture + "<figcaption>" + name + links + "</figcaption></figure>\n";
}

}  // namespace

fs::path sheet_picture(const std::string& name) { return fs::path("sheet") / (name + ".png"); }

std::string write_sheet(const JournalEntries& entries, const fs::path& folder) {
  const auto failed = std::count_if(entries.begin(), entries.end(),
                                    [](const auto& entry) { return entry.second.code != 0; });
  std::string page = page_head;
  page += "<h1>" + std::to_string(entries.size()) + " drawings</h1>\n";
  if (failed > 0) page += "<p>" + std::to_string(failed) + " failed; they come first.</p>\n";
  page += "<main>\n";
  for (const bool failures : {true, false})
    for (const auto& [name, entry] : entries)
      if ((entry.code != 0) == failures) page += figure(entry, folder);
  return page + "</main>\n</html>\n";
}

}  // namespace relievo::cli
