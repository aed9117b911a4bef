#include "io/svg/resolve_styles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/svg/svg_attributes.h"
#include "io/svg/svg_values.h"

namespace relievo {
namespace {

constexpr size_t longest_value = size_t{1} << 16;  ///< of a custom property, bytes
constexpr int max_chain = 100;                     ///< of values that refer to each other

Error limit_error(const std::string& what) { return {ErrorCode::limit, what, "svg"}; }

/// Writes what rules declare into the style attributes of a tree.
class Cascade {
 public:
  Cascade(const Stylesheet& sheet, size_t max_bytes) : sheet_(sheet), max_bytes_(max_bytes) {}

  bool gave_up() const { return work_ > max_selector_work || written_ > max_bytes_; }

  void apply(pugi::xml_node element) {
    std::vector<Declaration> list;
    for (const StyleRule& rule : sheet_.rules)
      if (!gave_up() && matches(rule.selector, element, work_)) add(*rule.declarations, list);
    if (!list.empty()) {
      add(parse_declarations(element.attribute("style").value()), list);
      std::stable_partition(list.begin(), list.end(),
                            [](const Declaration& d) { return !d.important; });
      set_style(element, list);
    }
    for (pugi::xml_node child : element.children())
      if (child.type() == pugi::node_element && !gave_up()) apply(child);
  }

 private:
  /// Adds declarations that win over those in the list. Those stay, since a value that cannot be
  /// read wins over nothing.
  void add(const std::vector<Declaration>& declarations, std::vector<Declaration>& list) {
    for (const Declaration& d : declarations) {
      written_ += d.name.size() + d.value.size();
      if (written_ <= max_bytes_) list.push_back(d);
    }
  }

  const Stylesheet& sheet_;
  size_t max_bytes_ = 0;
  size_t written_ = 0;
  size_t work_ = 0;
};

/// The custom properties that an element states, and those around it.
struct Scope {
  Scope* around = nullptr;
  std::map<std::string, std::string, std::less<>> stated;  ///< not resolved yet
  /// Resolved; nothing where the value cannot be, as that of a property that refers to itself.
  std::map<std::string, std::optional<std::string>, std::less<>> known = {};
};

/// An item "var(--name, fallback)" of a value.
struct Reference {
  size_t begin = 0;  ///< in the value
  size_t end = 0;
  std::string_view name;
  std::optional<std::string_view> fallback;
};

/// Finds the first reference at or after `from`; nothing where there is none.
std::optional<Reference> find_reference(std::string_view text, size_t from) {
  constexpr std::string_view start = "var(";
  const size_t begin = text.find(start, from);
  if (begin == std::string_view::npos) return std::nullopt;
  size_t comma = std::string_view::npos;
  int depth = 1;
  size_t end = begin + start.size();
  for (; end < text.size() && depth > 0; ++end) {
    if (text[end] == '(') ++depth;
    if (text[end] == ')') --depth;
    if (text[end] == ',' && depth == 1 && comma == std::string_view::npos) comma = end;
  }
  const size_t close = depth == 0 ? end - 1 : end;
  const size_t name_end = std::min(comma, close);
  Reference found{begin, end,
                  trimmed_svg(text.substr(begin + start.size(), name_end - begin - start.size())),
                  std::nullopt};
  if (comma != std::string_view::npos)
    found.fallback = trimmed_svg(text.substr(comma + 1, close - comma - 1));
  return found;
}

bool has_reference(std::string_view text) { return text.find("var(") != std::string_view::npos; }

/// Replaces the references to custom properties in a tree.
class Substitution {
 public:
  Substitution(SvgDocument& document, const SvgOptions& options)
      : document_(document), options_(options) {}

  Status run() {
    copy_used_below(document_.root, 0);
    visit(document_.root, nullptr, 0);
    if (error_) return *error_;
    return Done{};
  }

 private:
  void visit(pugi::xml_node element, Scope* around, size_t depth) {
    if (depth > options_.max_depth) return fail("has elements nested too deeply");
    std::vector<Declaration> style = parse_declarations(element.attribute("style").value());
    Scope scope{around, {}};
    for (const Declaration& d : style)
      if (d.is_custom()) scope.stated[d.name] = d.value;
    replace_in_attributes(element, scope);
    replace_in_style(element, std::move(style), scope);
    for (pugi::xml_node child : element.children())
      if (child.type() == pugi::node_element && !error_) visit(child, &scope, depth + 1);
  }

  void copy_used_below(pugi::xml_node element, size_t depth) {
    if (depth > options_.max_depth) return fail("has elements nested too deeply");
    const bool opened = local_name(element.name()) == "use" && copy_used(element);
    for (pugi::xml_node child : element.children())
      if (child.type() == pugi::node_element && !error_) copy_used_below(child, depth + 1);
    if (opened) open_.pop_back();
  }

  void replace_in_attributes(pugi::xml_node element, Scope& scope) {
    for (pugi::xml_attribute attribute = element.first_attribute(); attribute;) {
      const pugi::xml_attribute next = attribute.next_attribute();
      const std::string_view name = attribute.name();
      if (name != "style" && name != "id" && has_reference(attribute.value())) {
        const auto value = replaced(attribute.value(), scope, 0);
        if (value)
          attribute.set_value(value->c_str());
        else
          element.remove_attribute(attribute);
      }
      attribute = next;
    }
  }

  /// A declaration without a value unsets its property, as CSS demands.
  void replace_in_style(pugi::xml_node element, std::vector<Declaration> style, Scope& scope) {
    if (std::none_of(style.begin(), style.end(),
                     [](const Declaration& d) { return d.is_custom() || has_reference(d.value); }))
      return;
    std::vector<Declaration> kept;
    for (Declaration& d : style) {
      if (d.is_custom()) continue;
      if (!has_reference(d.value)) {
        kept.push_back(std::move(d));
        continue;
      }
      std::erase_if(kept, [&](const Declaration& other) { return other.name == d.name; });
      const auto value = replaced(d.value, scope, 0);
      if (value)
        kept.push_back({d.name, *value});
      else
        element.remove_attribute(d.name.c_str());
    }
    set_style(element, kept);
  }

  std::optional<std::string> replaced(std::string_view text, Scope& scope, int depth) {
    std::string result;
    size_t done = 0;
    if (depth > max_chain) return std::nullopt;
    for (auto item = find_reference(text, 0); item; item = find_reference(text, done)) {
      result.append(text.substr(done, item->begin - done));
      auto value = value_of(item->name, &scope, depth + 1);
      if (!value && item->fallback) value = replaced(*item->fallback, scope, depth + 1);
      if (!value) return std::nullopt;
      result.append(*value);
      if (result.size() > longest_value) {
        fail("has a style that grows too large");
        return std::nullopt;
      }
      done = item->end;
    }
    result.append(text.substr(done));
    written_ += result.size();
    if (written_ > options_.max_bytes) fail("has styles that grow too large");
    return result;
  }

  std::optional<std::string> value_of(std::string_view name, Scope* scope, int depth) {
    for (; scope != nullptr; scope = scope->around) {
      if (const auto found = scope->known.find(name); found != scope->known.end())
        return found->second;
      const auto stated = scope->stated.find(name);
      if (stated == scope->stated.end() || stated->second == "inherit") continue;
      // Until it is known, a property that refers to itself has no value.
      auto& known = scope->known[std::string(name)];
      if (stated->second != "initial") known = replaced(stated->second, *scope, depth);
      return known;
    }
    return std::nullopt;
  }

  /// Returns whether what the element shows depends on custom properties.
  bool depends(const pugi::xml_node& element, size_t depth = 0) {
    const auto [known, is_new] = dependent_.emplace(element.hash_value(), false);
    if (!is_new || depth > options_.max_depth) return known->second;
    bool found = false;
    for (const pugi::xml_attribute& attribute : element.attributes())
      found = found || has_reference(attribute.value());
    if (!found && local_name(element.name()) == "use") {
      const pugi::xml_node target = referenced_element(document_, element);
      found = target && depends(target, depth + 1);
    }
    for (const pugi::xml_node& child : element.children())
      found = found || (child.type() == pugi::node_element && depends(child, depth + 1));
    return dependent_[element.hash_value()] = found;
  }

  /// Copies what the <use> shows into it, where custom properties tell its look; returns whether it
  /// did.
  bool copy_used(pugi::xml_node use) {
    const pugi::xml_node target = referenced_element(document_, use);
    const bool is_open = std::find(open_.begin(), open_.end(), target) != open_.end();
    if (!target || is_open || !depends(target)) return false;
    pugi::xml_node copy = use.prepend_copy(target);
    const std::string name = name_of(target);
    copied_ += rename_copy(copy, document_);
    if (copied_ > options_.max_elements) fail("has too many elements");
    if (!name.empty()) {
      set_attribute(copy, "inkscape:label", name);
      set_attribute(document_.root, "xmlns:inkscape",
                    "http://www.inkscape.org/namespaces/inkscape");
    }
    const std::string reference = std::string("#") + copy.attribute("id").value();
    for (pugi::xml_attribute attribute : use.attributes())
      if (local_name(attribute.name()) == "href") attribute.set_value(reference.c_str());
    open_.push_back(target);
    return true;
  }

  void fail(const std::string& what) {
    if (!error_) error_ = limit_error(what);
  }

  SvgDocument& document_;
  const SvgOptions& options_;
  std::vector<pugi::xml_node> open_;  ///< originals of the copies around the present element
  std::map<size_t, bool> dependent_;
  size_t copied_ = 0;   ///< elements
  size_t written_ = 0;  ///< bytes
  std::optional<Error> error_;
};

}  // namespace

Status resolve_styles(SvgDocument& document, const Stylesheet& sheet, const SvgOptions& options) {
  Cascade cascade(sheet, options.max_bytes);
  if (!sheet.rules.empty()) cascade.apply(document.root);
  if (cascade.gave_up() || sheet.rules.size() > max_style_rules)
    return limit_error("has too many style rules; export it with presentation attributes");
  return Substitution(document, options).run();
}

}  // namespace relievo
