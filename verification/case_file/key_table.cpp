#include "verification/case_file/key_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <tuple>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"

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

std::function<bool(const TomlTable&)> where_written(const std::string& key,
                                                    const std::string& value) {
  return [=](const TomlTable& table) { return table.written(key) == value; };
}

std::string section(const KeyTable& table) {
  const char* quote = table.heading.starts_with('[') ? "`" : "";
  std::string text = fmt::format("### {0}{1}{0}\n\nRequired: {2}.{3}{4}\n\n", quote, table.heading,
                                 table.needed, table.meaning.empty() ? "" : " ", table.meaning);
  text += "| key | value | required | meaning |\n|---|---|---|---|\n";
  for (const KeyEntry& key : table.keys)
    text += fmt::format("| `{}` | {} | {} | {} |\n", key.name, key.value.words(), key.needed.words,
                        key.meaning);
  return text + "\n";
}

constexpr EnumName<MeasuredOn> measured_on_names[] = {
    {MeasuredOn::any_mode, "the forced or a natural mode"},
    {MeasuredOn::natural_mode, "a natural mode"},
    {MeasuredOn::whole_window, "the whole window"},
    {MeasuredOn::oscillation, "the whole window of an oscillating quantity"},
    {MeasuredOn::front, "the whole window of a quantity without modes"},
    {MeasuredOn::own_series, "the candidate alone, over the whole run"},
    {MeasuredOn::own_mode, "a natural mode of the candidate alone"},
    {MeasuredOn::impact, "a published impact"},
    {MeasuredOn::repeated_impact, "a published impact, over an ensemble"},
    {MeasuredOn::plateau, "the published plateau"},
    {MeasuredOn::band, "the window of a record with a band"},
    {MeasuredOn::field, "the fields at the snapshot times"},
    {MeasuredOn::cost, "the candidate's method against the reference"}};

constexpr EnumName<BoundScale> scale_names[] = {
    {BoundScale::unit, ""},
    {BoundScale::window, " of the window"},
    {BoundScale::impact_period, " of the impacts' period"}};

std::string widest(const WidestBound& widest) {
  return widest.scale == BoundScale::tank
             ? "by the tank"
             : fmt::format("{:g}{}", widest.below, name_of(widest.scale, scale_names));
}

std::string metric_section() {
  std::string text =
      "## Metrics\n\nA limit lies below the widest bound: a wider one would let every candidate "
      "pass. No range holds\nwhat a candidate of nothing has, or of a lag a wave turned "
      "over.\n[Concepts](concepts.md) explains the metrics.\n\n"
      "| metric | unit | measured on | widest bound | because |\n|---|---|---|---|---|\n";
  for (const MetricEntry& metric : metric_table())
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", metric.name,
                        *metric.unit ? metric.unit : "the quantity's",
                        name_of(metric.measured_on, measured_on_names), widest(metric.widest),
                        metric.widest.because);
  return text + "\n";
}

std::string quantity_section() {
  std::string text =
      "## Compared quantities\n\nGAUGE stands for the name of a gauge, PROBE for that of a "
      "probe and WALL for left, right, bottom or roof. A pressure gauge with a "
      "cutoff has `wall_pressure@GAUGE/filtered` too.\n\n"
      "| quantity | unit | modes |\n|---|---|---|\n";
  for (const std::string& name : quantity_names())
    text += fmt::format("| `{}` | {} | {} |\n", name, unit_of(name),
                        has_modes(name) ? "forced and natural" : "none");
  return text;
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
                       const CaseDefinition& definition) {
  if (value.known) return table.choice(key, value.what, value.known(definition));
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

namespace needed {

Needed where(const std::string& words) { return {words}; }

Needed beside(const std::string& key) {
  return {"with " + key, [key](const TomlTable& table) { return table.has(key); }};
}

Needed with(const std::string& key, const std::string& value, const std::string& after) {
  return {fmt::format("with {} = \"{}\"{}", key, value, after), where_written(key, value), key,
          value};
}

Needed one_of_three() { return {"one of the three", {}, {}, {}, Needed::Of::one_of_several}; }

Needed one_of_three_with(const std::string& key, const std::string& value) {
  return {fmt::format("one of the three with {} = \"{}\"", key, value),
          {},
          key,
          value,
          Needed::Of::one_of_several};
}

Needed at_least_one(const std::string& of) {
  return {"at least one" + of, {}, {}, {}, Needed::Of::at_least_one};
}

}  // namespace needed

Needed Needed::when(std::function<bool(const TomlTable&)> is_needed) const {
  Needed same = *this;
  same.in = std::move(is_needed);
  return same;
}

std::vector<std::string> KeyTable::names() const {
  std::vector<std::string> names;
  if (!solvers.empty()) names = keys_of("run");
  for (const KeyEntry& key : keys) names.push_back(key.name);
  return names;
}

std::vector<std::string> keys_of(const std::string& id) {
  for (const std::vector<KeyTable>* tables : {&case_key_tables(), &campaign_key_tables()})
    for (const KeyTable& table : *tables)
      if (table.id == id) return table.names();
  throw std::logic_error("no table of keys has the id " + id);
}

std::vector<std::string> list_keys_of_runs() {
  std::vector<std::string> names;
  for (const KeyTable& table : case_key_tables())
    for (const KeyEntry& key : table.keys)
      if (table.id.starts_with("run") && key.value.is_list()) names.push_back(key.name);
  return names;
}

std::string key_reference() {
  std::string text = R"(# Case-file reference

This page lists every key of case and campaign files. `./slosh explain --keys` prints it from the tables that name the
parser's keys.

The files are TOML. The parser refuses an unknown or missing key, a wrong type and an impossible value with
`file:line: key = value: expected ...`, and names up to 20 mistakes at once. A name is made of letters, digits, `_` and
`-`, without a `-` in front. A number has its unit in its key or at `unit` beside it; a limit has that of its metric.

## Case files

)";
  for (const KeyTable& table : case_key_tables()) text += section(table);
  text += "## Campaign files\n\n";
  for (const KeyTable& table : campaign_key_tables()) text += section(table);
  return text + metric_section() + quantity_section();
}

}  // namespace slosh
