// What the value at a key must be. From one expression, such as
// `number("m").above(0).below(tank_height)`, come the words of the reference ("number > 0 and below
// the tank's height, m"), the JSON schema, the rule that a value must satisfy and the message of
// its refusal ("a number > 0 and below the tank's height (1), in m").
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

enum class KeyKind {
  constant,  // of `texts`, as TOML
  flag,
  number,
  integer,
  text,
  name,
  choice,   // one of `texts`
  numbers,  // a list, each within the bounds
  increasing_numbers,
  list,           // of texts
  flag_or_texts,  // true or false, or a list of texts
  corners,
  limits,  // a table of metrics
  table,
  tables
};

// A bound of a number: another number, or one that has a name.
struct Bound {
  Bound(double number) : value(number) {}
  // Of the case, as far as it has been read.
  Bound(std::string its_name, std::function<double(const CaseDefinition&)> of)
      : name(std::move(its_name)), of_case(std::move(of)) {}
  // The number at another key of the table, which stands before.
  explicit Bound(std::string key) : name(std::move(key)) {}

  double value = 0;
  std::string name = {};
  std::function<double(const CaseDefinition&)> of_case = {};
};

inline const Bound tank_length{"the tank's length", [](const auto&it) { return it.tank.length; }},
    tank_height{"the tank's height", [](const auto&it) { return it.tank.height; }},
    fill_depth{"the fill depth", [](const auto&it) { return it.liquid.fill_depth; }},
    liquid_density{"the liquid's density", [](const auto&it) { return it.liquid.density; }},
    case_duration{"duration_s", [](const auto&it) { return it.duration; }};

struct KeyValue {
  struct End {
    Bound bound;
    bool included;
  };

  KeyKind kind;
  std::string told = {};                // its words, of a value that is no number
  std::vector<std::string> texts = {};  // of a choice
  std::string what = {};                // what a refusal calls the choice
  std::string heading = {};             // of a table
  Rule<std::string> text_rule = any_text();
  std::string unit = "1";  // of a number; "1" without one
  std::optional<End> lower = {}, upper = {};
  bool is_not_zero = false;
  std::string note = {};  // after the unit, in the message alone
  std::function<Rule<double>(const CaseDefinition&)> own_rule = {};

  KeyValue above(const Bound& bound) const { return with(&KeyValue::lower, End{bound, false}); }
  KeyValue at_least(const Bound& bound) const { return with(&KeyValue::lower, End{bound, true}); }
  KeyValue below(const Bound& bound) const { return with(&KeyValue::upper, End{bound, false}); }
  KeyValue at_most(const Bound& bound) const { return with(&KeyValue::upper, End{bound, true}); }
  KeyValue from(const Bound& a, const Bound& b) const { return at_least(a).at_most(b); }
  KeyValue other_than_zero() const { return with(&KeyValue::is_not_zero, true); }
  KeyValue noting(const std::string& words) const { return with(&KeyValue::note, words); }
  // With a rule of the case in place of the bounds, which are those of the reference.
  KeyValue by(Rule<double> (*rule)(const CaseDefinition&)) const {
    return with(&KeyValue::own_rule, rule);
  }

  std::string words() const;
  bool is_list() const;
  bool is_table() const { return kind == KeyKind::table || kind == KeyKind::tables; }
  Rule<double> rule(const TomlTable& table, const CaseDefinition& definition) const;

 private:
  template <class M, class Part>
  KeyValue with(M KeyValue::*part, const Part& value) const {
    KeyValue changed = *this;
    changed.*part = value;
    return changed;
  }
};

// Reads a value and checks it. T: double, int, bool, std::string, lists of numbers and texts.
template <class T>
T read_value(const KeyValue& value, const TomlTable& table, const std::string& key,
             const CaseDefinition& definition);

namespace key {

inline KeyValue number(const std::string& unit = "1") {
  return {.kind = KeyKind::number, .unit = unit};
}
inline KeyValue integer() { return {.kind = KeyKind::integer}; }
inline KeyValue flag() { return {KeyKind::flag, "true or false"}; }
inline KeyValue text(const std::string& words = "text") { return {KeyKind::text, words}; }
inline KeyValue list(const std::string& words) { return {KeyKind::list, words}; }
inline KeyValue constant(const std::string& only) { return {KeyKind::constant, only, {only}}; }
KeyValue name();  // a file-safe one
KeyValue list_of(KeyValue number);
KeyValue increasing_list_of(KeyValue number);
KeyValue one_of(const std::vector<std::string>& texts, const std::string& what = "");
KeyValue table(const std::string& heading);   // [tank], [[gauge]]
KeyValue tables(const std::string& heading);  // the same, without "the table" in its words

}  // namespace key
}  // namespace slosh
