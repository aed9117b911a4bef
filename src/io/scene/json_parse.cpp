#include "io/scene/json_parse.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/scene/json_reader.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

std::string line_and_column(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const size_t last_break = before.rfind('\n');
  const size_t column =
      last_break == std::string_view::npos ? before.size() + 1 : before.size() - last_break;
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Returns the reason in a message of the parser, which follows its prefix and position.
std::string reason(const std::string& message) {
  const size_t colon = message.find(": ");
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// Receives the parser's events and builds the value. Every event returns whether parsing goes on.
class Builder {
 public:
  Builder(std::string_view text, const JsonLimits& limits) : text_(text), limits_(limits) {}

  bool null() { return add(nullptr) != nullptr; }
  bool boolean(bool value) { return add(value) != nullptr; }
  bool number_integer(Json::number_integer_t value) { return add(value) != nullptr; }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value) != nullptr; }
  bool number_float(Json::number_float_t value, const std::string&) {
    return add(value) != nullptr;
  }
  bool string(std::string& value) { return add(std::move(value)) != nullptr; }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(size_t) { return open(Json::object()); }
  bool start_array(size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Frame& frame = open_.back();
    frame.key = std::move(name);
    if (!frame.container->contains(frame.key)) return true;
    error_ = Error{ErrorCode::bad_input, "the key is given twice; remove one of them", path()};
    return false;
  }

  bool parse_error(size_t offset, const std::string&, const Json::exception& exception) {
    error_ = Error{ErrorCode::bad_input, "malformed JSON: " + reason(exception.what()),
                   line_and_column(text_, offset)};
    return false;
  }

  const std::optional<Error>& error() const { return error_; }
  Json take() { return std::move(root_); }

 private:
  struct Frame {
    Json* container;
    std::string key;  ///< of the member being read, in an object
  };

  std::string path() const {
    std::string path;
    for (const Frame& frame : open_) {
      if (frame.container->is_array())
        path += "[" + std::to_string(frame.container->size() - 1) + "]";
      else
        path += (path.empty() ? "" : ".") + frame.key;
    }
    return path;
  }

  Json* add(Json value) {
    if (++values_ > limits_.max_values) {
      error_ = Error{ErrorCode::limit,
                     "holds more than " + std::to_string(limits_.max_values) + " values", ""};
      return nullptr;
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Frame& frame = open_.back();
    if (frame.container->is_object()) return &((*frame.container)[frame.key] = std::move(value));
    frame.container->push_back(std::move(value));
    return &frame.container->back();
  }

  bool open(Json container) {
    if (open_.size() >= limits_.max_depth) {
      error_ = Error{ErrorCode::limit,
                     "is nested deeper than " + std::to_string(limits_.max_depth) + " levels", ""};
      return false;
    }
    Json* added = add(std::move(container));
    if (added == nullptr) return false;
    open_.push_back({added, {}});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const JsonLimits& limits_;
  Json root_;
  std::vector<Frame> open_;
  size_t values_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<Json> parse_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.max_bytes)
    return Error{ErrorCode::limit,
                 "is larger than " + std::to_string(limits.max_bytes >> 20U) + " MB", ""};
  // The parser takes a zero byte for the end of the text and would not look beyond it.
  if (const size_t zero = text.find('\0'); zero != std::string_view::npos)
    return Error{ErrorCode::bad_input, "malformed JSON: a zero byte", line_and_column(text, zero)};
  Builder builder(text, limits);
  const bool complete = Json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.error()) return *builder.error();
  if (!complete) return Error{ErrorCode::internal, "the JSON reader stopped without a reason", ""};
  return builder.take();
}

}  // namespace relievo
