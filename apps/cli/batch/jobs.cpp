#include "apps/cli/batch/jobs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "apps/cli/batch/passed_over.h"
#include "apps/cli/batch/sheet_page.h"
#include "apps/cli/build_arguments.h"
#include "apps/cli/outputs.h"
#include "kernel/base/text_rules.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// A drawing of a batch.
struct ListedDrawing {
  fs::path input;
  fs::path name;       ///< of its outputs: as in the table, or the input's with extension
  bool named = false;  ///< whether a table gives the name
  std::vector<std::string> words;  ///< options of `build` for this drawing
  std::string where;               ///< file and line of a table; empty: none
};

std::vector<std::string> split(const std::string& line, char between) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, between);) cells.push_back(cell);
  return cells;
}

std::vector<std::string> option_words(const std::string& column, const std::string& cell) {
  std::vector<std::string> words = {"--" + column};
  if (cell == "yes") return words;
  for (const std::string& value : split(cell, ' '))
    if (!value.empty()) words.push_back(value);
  return words;
}

Result<ListedDrawing> read_row(const std::vector<std::string>& columns, const std::string& line,
                               const fs::path& folder, const std::string& where) {
  const std::vector<std::string> cells = split(line, '\t');
  const auto bad = [&where](const std::string& what) {
    return Error{ErrorCode::bad_input, what, where};
  };
  if (cells.size() > columns.size()) return bad("has more cells than columns");
  ListedDrawing row;
  row.where = where;
  for (size_t k = 0; k < cells.size(); ++k) {
    if (cells[k].empty()) continue;
    if (columns[k] == "input") {
      row.input = folder / cells[k];
    } else if (columns[k] == "name") {
      if (!is_path_inside(cells[k]))
        return bad("\"" + cells[k] + "\" cannot be a name: it leads out of the output folder");
      row.name = cells[k];
      row.named = true;
    } else {
      const auto words = option_words(columns[k], cells[k]);
      row.words.insert(row.words.end(), words.begin(), words.end());
    }
  }
  if (row.input.empty()) return bad("has no input");
  if (!row.named) row.name = row.input.filename();
  return row;
}

/// Reads a table of drawings: lines of cells separated by tabs. The first line names the columns:
/// `input`, a path relative to the table's folder; `name`, that of the outputs; and options of
/// `build` without their dashes. An empty cell leaves an option out, `yes` sets an option without a
/// value, and several values are separated by blanks. Lines that are empty or begin with # are
/// ignored. Errors: `file`; `bad_input`, whose `where` is the file and the line.
Result<std::vector<ListedDrawing>> read_table(const fs::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  std::vector<ListedDrawing> rows;
  std::vector<std::string> columns;
  int number = 0;
  for (std::string line : split(text, '\n')) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::string where = path.string() + ":" + std::to_string(number);
    if (columns.empty()) {
      columns = split(line, '\t');
      if (std::find(columns.begin(), columns.end(), "input") == columns.end())
        return Error{ErrorCode::bad_input,
                     "the first line must name the columns, and one must be \"input\"", where};
      continue;
    }
    auto row = read_row(columns, line, path.parent_path(), where);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  if (rows.empty()) return Error{ErrorCode::bad_input, "lists no drawings", path.string()};
  return rows;
}

/// Checks for the extension of a drawing. Scene files must be named one by one, since other files
/// end in .json too.
bool is_drawing(const fs::path& path) {
  static const std::set<std::string> endings = {".svg",  ".ora",  ".psd",  ".kra",    ".procreate",
                                                ".png",  ".jpg",  ".jpeg", ".gif",    ".webp",
                                                ".avif", ".heic", ".heif", ".relievo"};
  return endings.count(lower_case(path.extension().string())) > 0;
}

bool is_layer_folder(const fs::path& path) {
  std::error_code code;
  return fs::is_directory(path, code) && fs::exists(path / "layers.tsv", code);
}

/// The drawings given to a batch, and the other files in its folders.
struct FoundFiles {
  std::vector<ListedDrawing> drawings;
  std::vector<fs::path> others;
};

/// Finds the files in a folder and below, sorted by name.
Status search_folder(const fs::path& folder, const fs::path& below, FoundFiles& found) {
  std::error_code code;
  std::vector<fs::path> entries;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code))
    entries.push_back(it->path());
  if (code) return Error{ErrorCode::file, "cannot be read: " + code.message(), folder.string()};
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    const fs::path name = below / entry.filename();
    if (entry.filename().string().starts_with('.')) continue;
    if (is_layer_folder(entry) || (!fs::is_directory(entry, code) && is_drawing(entry)))
      found.drawings.push_back({entry, name, false, {}, ""});
    else if (fs::is_regular_file(entry, code))
      found.others.push_back(entry);
    else if (fs::is_directory(entry, code))
      if (Status status = search_folder(entry, name, found); !status) return status;
  }
  return Done{};
}

Status find_inputs(const std::string& input, FoundFiles& found) {
  const fs::path path(input);
  std::error_code code;
  if (path.extension() == ".tsv") {
    const auto rows = read_table(path);
    if (!rows) return rows.error();
    found.drawings.insert(found.drawings.end(), rows->begin(), rows->end());
    return Done{};
  }
  if (fs::is_directory(path, code) && !is_layer_folder(path)) return search_folder(path, "", found);
  const fs::path name = path.filename().empty() ? path.parent_path().filename() : path.filename();
  found.drawings.push_back({path, name, false, {}, ""});
  return Done{};
}

std::string plain_name(const ListedDrawing& found) {
  if (found.named) return found.name.generic_string();
  return fs::path(found.name).replace_extension().generic_string();
}

/// Returns the name of a drawing, with its extension only if others have the same name.
std::string job_name(const ListedDrawing& found, const std::map<std::string, int>& uses) {
  const std::string name = plain_name(found);
  if (uses.at(name) == 1 || found.named || !found.name.has_extension()) return name;
  return name + "-" + found.name.extension().string().substr(1);
}

bool has(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Returns the options of `build` that name the outputs of a drawing.
std::vector<std::string> output_words(const BatchArguments& batch, const std::string& name) {
  const fs::path folder = batch.output;
  const std::string stem = (folder / name).string();
  std::vector<std::string> words;
  if (batch.sheet && !has(batch.make, "preview")) {
    words = {"--preview", (folder / sheet_picture(name)).string()};
    if (!has(batch.words, "--preview-size"))
      words.insert(words.end(), {"--preview-size", std::to_string(sheet_size)});
  }
  static const std::set<std::string> maps = {"normal", "depth", "part", "occlusion"};
  for (const std::string& what : batch.make) {
    if (maps.count(what) > 0)
      words.insert(words.end(), {"--" + what + "-map", stem + "-" + what + ".png"});
    else if (what == "preview" || what == "overlay")
      words.insert(words.end(), {"--" + what, stem + "-" + what + ".png"});
    else if (what == "report")
      words.insert(words.end(), {"--report", stem + "-report.json"});
    else
      words.insert(words.end(), {"-o", stem + "." + what});
  }
  return words;
}

Result<BatchJob> job_of(const ListedDrawing& found, const std::string& name,
                        const BatchArguments& batch) {
  JournalEntry entry;
  entry.name = name;
  entry.input = found.input.string();
  entry.version = RELIEVO_VERSION;
  entry.options = batch.words;
  for (const auto& words : {found.words, output_words(batch, name)})
    entry.options.insert(entry.options.end(), words.begin(), words.end());
  const auto build = parse_build(entry.input, entry.options);
  if (!build) return Error{build.error().code, build.error().message, found.where};
  for (const fs::path& file : planned_outputs(*build)) entry.files.push_back(file.string());
  return BatchJob{std::move(entry), build->relief.options.layers.vertex_budget};
}

}  // namespace

Result<BatchWork> collect_jobs(const BatchArguments& batch) {
  FoundFiles found;
  for (const std::string& input : batch.inputs)
    if (Status status = find_inputs(input, found); !status) return status.error();
  if (found.drawings.empty()) {
    std::string message = "contains no drawings";
    for (const std::string& line : describe_passed_over(found.others)) message += "; " + line;
    return Error{ErrorCode::bad_input, message, batch.inputs.front()};
  }
  std::map<std::string, int> uses;
  for (const ListedDrawing& one : found.drawings) ++uses[plain_name(one)];
  std::map<std::string, BatchJob> jobs;
  for (const ListedDrawing& one : found.drawings) {
    const std::string name = job_name(one, uses);
    auto job = job_of(one, name, batch);
    if (!job) return job.error();
    const auto [same, added] = jobs.emplace(name, std::move(*job));
    if (!added)
      return Error{
          ErrorCode::usage,
          "would have the same outputs as " + same->second.entry.input + "; name them in a table",
          one.input.string()};
  }
  BatchWork work{{}, std::move(found.others)};
  for (auto& [name, job] : jobs) work.jobs.push_back(std::move(job));
  return work;
}

}  // namespace relievo::cli
