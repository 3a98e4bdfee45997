#include "verification/input/toml_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>
#include <type_traits>

#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/toml_letters.hpp"

namespace slosh {

struct TomlTable::Content {
  std::shared_ptr<const toml::table> root;  // keeps `table`, which is part of it, alive
  const toml::table* table;
  std::string file;
  std::string path;  // "" for the root, "tank." inside [tank]
  int line = 0;      // of a copy
  // The refusals of read_all() so far; null outside it.
  std::shared_ptr<std::vector<std::string>> kept = nullptr;
  // Of the values of a copy, whose nodes have no place: "file:line: path" where they were written.
  std::map<std::string, std::string, std::less<>> origins = {};

  SourceLocation where(const toml::node& node) const {
    const auto own = node.source().begin.line;
    return {file, own ? static_cast<int>(own) : line};
  }
  // A changed copy, in which the values that stay keep their places.
  Content copy(toml::table changed) const {
    const auto held = std::make_shared<const toml::table>(std::move(changed));
    Content copied{held, held.get(), file, path, where(*table).line, kept, origins};
    for (const auto& [key, node] : *table)
      copied.origins.try_emplace(std::string(key.str()), place_and_path(key.str()));
    return copied;
  }
  // A table that this one holds.
  std::shared_ptr<const Content> part(const toml::node& node, std::string_view key) const {
    return std::make_shared<const Content>(
        Content{root, node.as_table(), file, fmt::format("{}{}.", path, key), 0, kept});
  }
  std::string place(const toml::node& node) const {
    return fmt::format("{}:{}", file, where(node).line);
  }
  // Of the value at a key, or of the table where it is missing.
  std::string place_and_path(std::string_view key) const {
    const auto origin = origins.find(key);
    if (origin != origins.end()) return origin->second;
    const toml::node* node = table->get(key);
    return fmt::format("{}: {}{}", place(node ? *node : *table), path, key);
  }
  std::string refusal(std::string_view key, std::string_view expected) const;
  // The array at a key. Throws CaseFileError where there is none, an array of `what`.
  const toml::array& elements(std::string_view key, const std::string& what) const;
  // Throws CaseFileError, with the element's own line, where it breaks the rule.
  template <class T>
  T element(std::string_view key, const toml::node& node, const Rule<T>& rule) const;
};

namespace {

constexpr std::size_t most_combinations = 1000;

std::string as_written(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("\"{}\"", text->get());
  if (const auto* number = node.as_floating_point()) {
    const std::string digits = fmt::format("{}", number->get());
    return digits.find_first_not_of("-0123456789") == digits.npos ? digits + ".0" : digits;
  }
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* flag = node.as_boolean()) return fmt::format("{}", flag->get());
  if (node.is_table()) return "(a table)";
  if (node.is_array_of_tables()) return "(an array of tables)";
  return node.is_array() ? "(an array)" : "(a date or time)";
}

// An array within an array, whose elements tell which it is.
std::string element_as_written(const toml::node& node) {
  if (!node.is_array()) return as_written(node);
  std::vector<std::string> elements;
  for (const toml::node& element : *node.as_array()) elements.push_back(as_written(element));
  return fmt::format("[{}]", fmt::join(elements, ", "));
}

template <class T>
std::optional<T> converted(const toml::node& node) {
  if constexpr (std::is_same_v<T, double>) {
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    const auto* number = node.as_floating_point();
    return number && std::isfinite(number->get()) ? std::optional(number->get()) : std::nullopt;
  } else if constexpr (std::is_same_v<T, int>) {
    using Limits = std::numeric_limits<int>;
    const auto* integer = node.as_integer();
    const bool fits = integer && integer->get() >= Limits::min() && integer->get() <= Limits::max();
    return fits ? std::optional(static_cast<int>(integer->get())) : std::nullopt;
  } else {
    const auto* value = node.as<T>();
    return value ? std::optional<T>(value->get()) : std::nullopt;
  }
}

// Whether the text has a control character other than a line's end or a tab. A TOML file can hold
// them only as "\u001B"; in a title they would command a terminal and make an SVG malformed.
bool has_control_character(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool ends_line =
        byte == '\n' || (byte == '\r' && i + 1 < text.size() && text[i + 1] == '\n');
    const bool is_c1 =
        byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if ((byte < 0x20 && !ends_line && byte != '\t') || byte == 0x7f || is_c1) return true;
  }
  return false;
}

void require_printable(const toml::node& node, const std::string& file) {
  const auto require = [&](std::string_view text) {
    if (has_control_character(text))
      throw CaseFileError(fmt::format(
          "{}:{}: a text with a control character: expected only those that can be printed, line "
          "breaks and tabs",
          file, node.source().begin.line));
  };
  if (const auto* text = node.as_string()) require(text->get());
  if (const auto* array = node.as_array())
    for (const toml::node& element : *array) require_printable(element, file);
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table) {
      require(key.str());
      require_printable(value, file);
    }
}

toml::table parsed(std::string_view text, const std::filesystem::path& file) {
  if (const auto letter = letter_outside_strings(text))
    throw CaseFileError(fmt::format(
        "{}:{}:{}: not TOML: a letter beyond ASCII; expected such letters only in strings and "
        "comments",
        file.string(), letter->line, letter->column));
  if (const auto key = end_of_deep_key(text))
    throw CaseFileError(fmt::format("{}:{}:{}: a key nested too deep: expected at most 100 dots",
                                    file.string(), key->line, key->column));
  try {
    toml::table table = toml::parse(text, file.string());
    require_printable(table, file.string());
    return table;
  } catch (const toml::parse_error& error) {
    const auto& place = error.source().begin;
    throw CaseFileError(fmt::format("{}:{}:{}: not TOML: {}", file.string(), place.line,
                                    place.column, error.description()));
  }
}

}  // namespace

std::string TomlTable::Content::refusal(std::string_view key, std::string_view expected) const {
  const toml::node* node = table->get(key);
  const std::string at = place_and_path(key);
  return node ? fmt::format("{} = {}: expected {}", at, as_written(*node), expected)
              : fmt::format("{} is missing: expected {}", at, expected);
}

const toml::array& TomlTable::Content::elements(std::string_view key,
                                                const std::string& what) const {
  const toml::node* node = table->get(key);
  if (!node || !node->is_array()) throw CaseFileError(refusal(key, "an array of " + what));
  return *node->as_array();
}

template <class T>
T TomlTable::Content::element(std::string_view key, const toml::node& node,
                              const Rule<T>& rule) const {
  const std::optional<T> value = converted<T>(node);
  if (value && rule.holds(*value)) return *value;
  throw CaseFileError(fmt::format("{}: {}{} = {}: expected {}", place(node), path, key,
                                  as_written(node), rule.expected));
}

TomlTable::TomlTable(std::string_view text, const std::filesystem::path& file) {
  const auto root = std::make_shared<const toml::table>(parsed(text, file));
  content_ = std::make_shared<const Content>(Content{root, root.get(), file.string(), ""});
}

void TomlTable::allow_only(const std::vector<std::string>& keys) const {
  std::vector<std::string> unknown;
  for (const auto& [key, node] : *content_->table) {
    if (unknown.size() == Complaints::most) break;
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    unknown.push_back(
        fmt::format("{}: {}{} = {}: expected only these keys here: {}; nearest known key: {}",
                    content_->place(node), content_->path, key.str(), as_written(node),
                    fmt::join(keys, ", "), nearest_names(key.str(), keys, 1).front()));
  }
  if (!unknown.empty()) throw CaseFileErrors(std::move(unknown));
}

template <class T>
T TomlTable::refused(std::string_view key, const Rule<T>& rule) const {
  if (!content_->kept || !rule.stand_in) refuse(key, rule.expected);
  content_->kept->push_back(refusal(key, rule.expected));
  return *rule.stand_in;
}

template <class T>
std::optional<T> TomlTable::find(std::string_view key, const Rule<T>& rule) const {
  const toml::node* node = content_->table->get(key);
  if (!node) return std::nullopt;
  const std::optional<T> value = converted<T>(*node);
  return value && rule.holds(*value) ? value : refused(key, rule);
}

template <class T>
T TomlTable::get(std::string_view key, const Rule<T>& rule) const {
  const std::optional<T> value = find(key, rule);
  return value ? *value : refused(key, rule);
}

template std::optional<std::string> TomlTable::find(std::string_view,
                                                    const Rule<std::string>&) const;
template std::optional<double> TomlTable::find(std::string_view, const Rule<double>&) const;
template std::optional<int> TomlTable::find(std::string_view, const Rule<int>&) const;
template double TomlTable::get(std::string_view, const Rule<double>&) const;
template int TomlTable::get(std::string_view, const Rule<int>&) const;
template std::string TomlTable::get(std::string_view, const Rule<std::string>&) const;

bool TomlTable::flag(std::string_view key) const {
  return find<bool>(key, {"true or false", [](bool) { return true; }, false}).value_or(false);
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* node = content_->table->get(key);
  return node ? converted<double>(*node) : std::nullopt;
}

std::string TomlTable::choice(std::string_view key, std::string_view expected,
                              const std::vector<std::string>& known) const {
  const std::string one_of = one_of_text(expected, known);
  if (known.empty()) refuse(key, one_of);
  std::string value = get<std::string>(key, {one_of, [](const std::string&) { return true; }});
  if (std::find(known.begin(), known.end(), value) != known.end()) return value;
  throw CaseFileErrors({refusal(key, one_of + nearest_text(value, known))});
}

std::vector<PlacedText> TomlTable::texts(std::string_view key,
                                         const Rule<std::string>& each) const {
  std::vector<PlacedText> values;
  for (const toml::node& element : content_->elements(key, "texts, each " + each.expected))
    values.push_back({content_->element(key, element, each), content_->where(element)});
  return values;
}

std::vector<double> TomlTable::numbers(std::string_view key, const Rule<double>& each) const {
  std::vector<double> values;
  for (const toml::node& element : content_->elements(key, "numbers, each " + each.expected))
    values.push_back(content_->element(key, element, each));
  return values;
}

std::vector<std::pair<double, double>> TomlTable::pairs(std::string_view key,
                                                        std::string_view each) const {
  std::vector<std::pair<double, double>> values;
  for (const toml::node& element : content_->elements(key, fmt::format("pairs, each {}", each))) {
    const toml::array* pair = element.as_array();
    const bool is_pair = pair && pair->size() == 2;
    const auto first = is_pair ? converted<double>(*pair->get(0)) : std::nullopt,
               second = is_pair ? converted<double>(*pair->get(1)) : std::nullopt;
    if (!first || !second) refuse_element(key, values.size(), each);
    values.emplace_back(*first, *second);
  }
  return values;
}

std::vector<double> TomlTable::increasing_numbers(std::string_view key,
                                                  const Rule<double>& each) const {
  if (!has(key)) return {};
  std::vector<double> values = numbers(key, each);
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(values[i] > values[i - 1])) refuse_element(key, i, "a number above the one before it");
  return values;
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node* node = content_->table->get(key);
  if (!node || !node->is_table()) refuse(key, fmt::format("a table, [{}{}]", content_->path, key));
  return TomlTable(content_->part(*node, key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> tables;
  if (!has(key)) return tables;
  const std::string what = fmt::format("tables, [[{}{}]]", content_->path, key);
  for (const toml::node& element : content_->elements(key, what)) {
    if (!element.is_table()) refuse(key, "an array of " + what);
    tables.push_back(TomlTable(content_->part(element, key)));
  }
  return tables;
}

TomlTable TomlTable::of(Content content) {
  return TomlTable(std::make_shared<const Content>(std::move(content)));
}

TomlTable TomlTable::without(const std::vector<std::string>& keys) const {
  toml::table rest = *content_->table;
  for (const std::string& key : keys) rest.erase(key);
  Content copied = content_->copy(std::move(rest));
  for (const std::string& key : keys) copied.origins.erase(key);
  return of(std::move(copied));
}

TomlTable TomlTable::with(std::string_view key, const std::string& text) const {
  toml::table more = *content_->table;
  more.insert_or_assign(key, text);
  return of(content_->copy(std::move(more)));
}

TomlTable TomlTable::with_flag(std::string_view key, bool value) const {
  toml::table more = *content_->table;
  more.insert_or_assign(key, value);
  return of(content_->copy(std::move(more)));
}

TomlTable TomlTable::with(std::string_view key, const TomlTable& other,
                          std::string_view from) const {
  toml::table more = *content_->table;
  other.content_->table->get(from)->visit(
      [&](const auto& value) { more.insert_or_assign(key, value); });
  Content copied = content_->copy(std::move(more));
  copied.origins.insert_or_assign(std::string(key), other.content_->place_and_path(from));
  return of(std::move(copied));
}

TomlTable TomlTable::placed_at(const TomlTable& other, std::string_view key) const {
  Content copied = content_->copy(*content_->table);
  copied.line = other.content_->where(*other.content_->table->get(key)).line;
  return of(std::move(copied));
}

std::vector<TomlTable> TomlTable::combinations(const std::vector<std::string>& but_for) const {
  std::vector<toml::table> made{*content_->table};
  for (const auto& [key, node] : *content_->table) {
    const toml::array* axis = node.as_array();
    const std::string name(key.str());
    if (!axis || node.is_array_of_tables() ||
        std::find(but_for.begin(), but_for.end(), name) != but_for.end())
      continue;
    if (axis->empty()) refuse(name, "a value, or an array of at least one");
    if (made.size() * axis->size() > most_combinations)
      refuse(name, fmt::format("lists of at most {} combinations in one table", most_combinations));
    std::vector<toml::table> longer;
    for (const toml::table& table : made)
      for (const toml::node& element : *axis) {
        longer.push_back(table);
        element.visit([&](const auto& value) { longer.back().insert_or_assign(name, value); });
      }
    made = std::move(longer);
  }
  std::vector<TomlTable> tables;
  for (toml::table& table : made) tables.push_back(of(content_->copy(std::move(table))));
  return tables;
}

bool TomlTable::has_table(std::string_view key) const {
  const toml::node* node = content_->table->get(key);
  return node && node->is_table();
}

bool TomlTable::has_list(std::string_view key) const {
  const toml::node* node = content_->table->get(key);
  return node && node->is_array();
}

std::string TomlTable::as_toml() const {
  std::ostringstream text;
  text << *content_->table << "\n";
  return text.str();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::tuple<toml::source_index, toml::source_index, std::string>> placed;
  for (const auto& [key, node] : *content_->table) {
    const toml::source_position& begin = key.source().begin;
    placed.emplace_back(begin.line, begin.column, key.str());
  }
  std::sort(placed.begin(), placed.end());
  std::vector<std::string> names;
  for (const auto& one : placed) names.push_back(std::get<std::string>(one));
  return names;
}

std::string TomlTable::written(std::string_view key) const {
  const toml::node* node = content_->table->get(key);
  if (!node) return "";
  return node->is_string() ? node->as_string()->get() : as_written(*node);
}

bool TomlTable::has(std::string_view key) const { return content_->table->contains(key); }

SourceLocation TomlTable::where() const { return content_->where(*content_->table); }

void TomlTable::read_all(const std::function<void(const TomlTable&)>& read) const {
  Content keeping = *content_;
  const auto kept = keeping.kept = std::make_shared<std::vector<std::string>>();
  try {
    read(TomlTable(std::make_shared<const Content>(std::move(keeping))));
  } catch (const CaseFileErrors& errors) {
    kept->insert(kept->end(), errors.messages.begin(), errors.messages.end());
  } catch (const CaseFileError&) {
    if (kept->empty()) throw;
  }
  if (!kept->empty()) throw CaseFileErrors(*kept);
}

std::string TomlTable::refusal(std::string_view key, std::string_view expected) const {
  return content_->refusal(key, expected);
}

void TomlTable::refuse(std::string_view key, std::string_view expected) const {
  throw CaseFileError(refusal(key, expected));
}

void TomlTable::refuse_element(std::string_view key, std::size_t element,
                               std::string_view expected) const {
  const toml::node& node = *content_->table->get(key)->as_array()->get(element);
  throw CaseFileError(fmt::format("{}: {}{} = {}: expected {}", content_->place(node),
                                  content_->path, key, element_as_written(node), expected));
}

void TomlTable::refuse_table(std::string_view holds, std::string_view expected) const {
  const std::string name = content_->path.substr(0, content_->path.find_last_of('.'));
  throw CaseFileError(fmt::format("{}: {} = {}: expected {}", content_->place(*content_->table),
                                  name, holds, expected));
}

}  // namespace slosh
