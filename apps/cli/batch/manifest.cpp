#include "apps/cli/batch/manifest.h"

#include <algorithm>
#include <sstream>

#include "kernel/base/text_rules.h"
#include "relievo/files.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

Result<std::vector<ListedDrawing>> read_manifest(const fs::path& path) {
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

}  // namespace relievo::cli
