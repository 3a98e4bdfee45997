#include "verification/case_file/key_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <tuple>

namespace slosh {
namespace {

using ValueOf = std::function<std::optional<double>(const Bound&)>;

// "number > 0 and below the tank's height", of bounds with a known value "... height (1)".
std::string with_bounds(const std::string& noun, const KeyValue& value, const ValueOf& known) {
  if (value.is_not_zero) return noun + " other than 0";
  const auto text = [&](const KeyValue::End& end) {
    if (end.bound.name.empty()) return fmt::format("{}", end.bound.value);
    const auto number = known(end.bound);
    return number ? fmt::format("{} ({:.6g})", end.bound.name, *number) : end.bound.name;
  };
  const auto& [lower, upper] = std::tie(value.lower, value.upper);
  if (lower && upper && lower->included && upper->included)
    return fmt::format("{} from {} to {}", noun, text(*lower), text(*upper));
  std::vector<std::string> parts;
  const auto add = [&](const KeyValue::End& end, const char* included, const char* sign,
                       const char* word) {
    const char* relation = end.included ? included : end.bound.name.empty() ? sign : word;
    parts.push_back(fmt::format(" {} {}", relation, text(end)));
  };
  if (lower) add(*lower, ">=", ">", "above");
  if (upper) add(*upper, "<=", "<", "below");
  return noun + fmt::format("{}", fmt::join(parts, " and"));
}

bool is_of_table(const std::optional<KeyValue::End>& end) {
  return end && !end->bound.name.empty() && !end->bound.of_case;
}

}  // namespace

bool KeyValue::is_list() const {
  return kind == KeyKind::numbers || kind == KeyKind::increasing_numbers || kind == KeyKind::list;
}

std::string KeyValue::words() const {
  if (!told.empty()) return told;
  const char* noun = kind == KeyKind::number    ? "number"
                     : kind == KeyKind::integer ? "integer"
                     : kind == KeyKind::numbers ? "list of numbers"
                                                : "increasing list of numbers";
  return with_bounds(noun, *this, [](const auto&) { return std::nullopt; }) +
         (unit == "1" ? "" : ", " + unit);
}

// Another key of the table that holds no number is refused by itself.
Rule<double> KeyValue::rule(const TomlTable& table, const CaseDefinition& definition) const {
  if (own_rule) return own_rule(definition);
  const ValueOf known = [&](const Bound& bound) -> std::optional<double> {
    if (bound.name.empty()) return bound.value;
    return bound.of_case ? bound.of_case(definition) : table.number(bound.name);
  };
  const bool is_integer = kind == KeyKind::integer;
  const auto low = lower ? known(lower->bound) : std::nullopt,
             high = upper ? known(upper->bound) : std::nullopt;
  Rule<double> rule{with_bounds(is_integer ? "an integer" : "a number", *this, known) +
                        (is_integer ? "" : ", " + in(unit)) + note,
                    [this, low, high](double given) {
                      return (!low || given > *low || (lower->included && given == *low)) &&
                             (!high || given < *high || (upper->included && given == *high)) &&
                             !(is_not_zero && given == 0);
                    }};
  if (is_of_table(lower) || is_of_table(upper)) return rule;
  const double least = low.value_or(0), greatest = high.value_or(least + 2);
  for (const double any : {least, greatest, (least + greatest) / 2})
    if (!rule.stand_in && rule.holds(any)) rule.stand_in = any;
  return rule;
}

template <>
double read_value(const KeyValue& value, const TomlTable& table, const std::string& key,
                  const CaseDefinition& definition) {
  return table.get(key, value.rule(table, definition));
}

template <>
int read_value(const KeyValue& value, const TomlTable& table, const std::string& key,
               const CaseDefinition& definition) {
  const Rule<double> rule = value.rule(table, definition);
  Rule<int> whole{rule.expected, [&](int given) { return rule.holds(given); }};
  if (rule.stand_in) whole.stand_in = static_cast<int>(*rule.stand_in);
  return table.get(key, whole);
}

template <>
std::vector<double> read_value(const KeyValue& value, const TomlTable& table,
                               const std::string& key, const CaseDefinition& definition) {
  const Rule<double> rule = value.rule(table, definition);
  return value.kind == KeyKind::increasing_numbers ? table.increasing_numbers(key, rule)
                                                   : table.numbers(key, rule);
}

template <>
bool read_value(const KeyValue&, const TomlTable& table, const std::string& key,
                const CaseDefinition&) {
  return table.flag(key);
}

template <>
std::string read_value(const KeyValue& value, const TomlTable& table, const std::string& key,
                       const CaseDefinition&) {
  return value.kind == KeyKind::choice ? table.choice(key, value.what, value.texts)
                                       : table.get(key, value.text_rule);
}

template <>
std::vector<std::string> read_value(const KeyValue& value, const TomlTable& table,
                                    const std::string& key, const CaseDefinition&) {
  std::vector<std::string> texts;
  for (const PlacedText& one : table.texts(key, value.text_rule)) texts.push_back(one.text);
  return texts;
}

namespace key {

KeyValue name() { return {.kind = KeyKind::name, .told = "name", .text_rule = file_safe_name()}; }

KeyValue list_of(KeyValue number) {
  number.kind = KeyKind::numbers;
  return number;
}

KeyValue increasing_list_of(KeyValue number) {
  number.kind = KeyKind::increasing_numbers;
  return number;
}

KeyValue one_of(const std::vector<std::string>& texts, const std::string& what) {
  std::string quoted;
  for (std::size_t i = 0; i < texts.size(); ++i)
    quoted += (i == 0 ? "\"" : i + 1 == texts.size() ? " or \"" : ", \"") + texts[i] + "\"";
  return {KeyKind::choice, quoted, texts, what};
}

KeyValue tables(const std::string& heading) {
  return {.kind = heading.starts_with("[[") ? KeyKind::tables : KeyKind::table,
          .told = heading,
          .heading = heading};
}

KeyValue table(const std::string& heading) {
  KeyValue value = tables(heading);
  value.told = "the table " + heading;
  return value;
}

}  // namespace key
}  // namespace slosh
