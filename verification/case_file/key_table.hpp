// The tables of the keys of case and campaign files. A row says of a key where its value goes, what
// it must be, when it is needed and what it means. Reading and checking a file, the case-file
// reference (`slosh explain --keys`), the schemas and the comments of a new case come from these
// rows. A [[sweep]] takes the keys of [[run]] beside its own.
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

// What the value at a key must be. From one expression, such as
// `number("m").above(0).below(tank_height)`, come the words of the reference ("number > 0 and below
// the tank's height, m"), the JSON schema, the rule that a value must satisfy and the message of
// its refusal ("a number > 0 and below the tank's height (1), in m").

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
  std::function<std::vector<std::string>(const CaseDefinition&)> known = {};  // the texts of a case
  std::string heading = {};                                                   // of a table
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
inline KeyValue list(const std::string& words, const Rule<std::string>& each = any_text()) {
  return {.kind = KeyKind::list, .told = words, .text_rule = each};
}
inline KeyValue constant(const std::string& only) { return {KeyKind::constant, only, {only}}; }
KeyValue name();  // a file-safe one
KeyValue list_of(KeyValue number);
KeyValue increasing_list_of(KeyValue number);
KeyValue one_of(const std::vector<std::string>& texts, const std::string& what = "");
// One of the texts that the case knows, as its runs.
inline KeyValue known(const std::string& words, const std::string& what,
                      const std::function<std::vector<std::string>(const CaseDefinition&)>& texts) {
  return {.kind = KeyKind::text, .told = words, .what = what, .known = texts};
}
KeyValue table(const std::string& heading);   // [tank], [[gauge]]
KeyValue tables(const std::string& heading);  // the same, without "the table" in its words

}  // namespace key

// When a key is needed.
struct Needed {
  std::string words;  // "yes", "no", "with type = \"sine\""
  // Whether it is, in this table. Without it the section that reads the table decides.
  std::function<bool(const TomlTable&)> in = {};
  std::string key = {}, value = {};  // of "with KEY = VALUE"; empty elsewhere
  enum class Of { itself, one_of_several, at_least_one } of = Of::itself;

  // The same words, with the tables in which the key is needed.
  Needed when(std::function<bool(const TomlTable&)> is_needed) const;
};

namespace needed {

inline const Needed yes{"yes", [](const TomlTable&) { return true; }}, no{"no"};
Needed where(const std::string& words);  // the section decides
Needed beside(const std::string& key);   // "with KEY"
Needed with(const std::string& key, const std::string& value, const std::string& after = "");
// Exactly one of the keys of a table that have the same words, or one at least.
Needed one_of_three();
Needed one_of_three_with(const std::string& key, const std::string& value);
Needed at_least_one(const std::string& of = "");

}  // namespace needed

struct KeyEntry {
  std::string name;
  KeyValue value;
  Needed needed;
  std::string meaning = {};

  bool is_read(const TomlTable& table) const {
    return table.has(name) || (needed.in && needed.in(table));
  }
};

// A table of the file, or the keys that a solver adds to [[run]].
struct KeyTable {
  std::string id;       // "tank", "run", "run.sph"
  std::string heading;  // "[tank]", "[[run]] with solver = \"sph\""
  std::string needed;   // as for a key
  std::string meaning;
  std::vector<KeyEntry> keys = {};
  std::vector<std::string> solvers = {};  // whose runs have these keys, beside those of all runs

  std::vector<std::string> names() const;  // of all keys that may stand in the table
};

// A key whose value becomes part of a struct S, or is read with the whole table without `read`.
template <class S>
struct Field : KeyEntry {
  using Read = std::function<void(const KeyEntry&, const TomlTable&, const CaseDefinition&, S&)>;
  Read read;

  Field(KeyEntry entry, Read reads = nullptr)
      : KeyEntry(std::move(entry)), read(std::move(reads)) {}
};

// The type of a value whose member may be optional.
template <class T>
struct Held {
  using type = T;
};
template <class T>
struct Held<std::optional<T>> {
  using type = T;
};

// Reads the value at the key into what `part` returns, in the member's own unit.
template <class S, class Part>
Field<S> field_of_part(const char* name, Part part, const KeyValue& value, const Needed& needed,
                       const std::string& meaning, double per_unit = 1) {
  using T = typename Held<std::remove_cvref_t<std::invoke_result_t<Part, S&>>>::type;
  return {
      {name, value, needed, meaning},
      [=](const KeyEntry& key, const TomlTable& table, const CaseDefinition& definition, S& made) {
        if (!key.is_read(table)) return;
        T read = read_value<T>(key.value, table, key.name, definition);
        if constexpr (std::is_same_v<T, double>) read *= per_unit;
        part(made) = std::move(read);
      }};
}

// A member, one of a part that is made when one of its keys is read, and one of an enumeration.
template <class S, class M>
Field<S> field(const char* name, M S::*member, const KeyValue& value, const Needed& needed,
               const std::string& meaning = "", double per_unit = 1) {
  const auto part = [member](S& made) -> M& { return made.*member; };
  return field_of_part<S>(name, part, value, needed, meaning, per_unit);
}
template <class S, class Whole, class M>
Field<S> field(const char* name, std::optional<Whole> S::*whole, M Whole::*member,
               const KeyValue& value, const Needed& needed, const std::string& meaning = "") {
  const auto part = [=](S& made) -> M& {
    std::optional<Whole>& held = made.*whole;
    return (held ? *held : held.emplace()).*member;
  };
  return field_of_part<S>(name, part, value, needed, meaning);
}
template <class S, class Enum, std::size_t n>
Field<S> field(const char* name, Enum S::*member, const EnumName<Enum> (&names)[n],
               const std::string& what, const Needed& needed, const std::string& meaning = "") {
  return {{name, key::one_of(all_names(names), what), needed, meaning},
          [member, &names](const KeyEntry& key, const TomlTable& table, const CaseDefinition&,
                           S& made) {
            if (key.is_read(table)) made.*member = table.choice(key.name, key.value.what, names);
          }};
}

// The table of the keys of a struct.
template <class S>
struct FieldTable : KeyTable {
  // What the rows do not say, as of one value beside another.
  using Finish = std::function<void(const TomlTable&, const CaseDefinition&, S&)>;

  std::vector<Field<S>> fields;
  Finish finish;
  S defaults;

  FieldTable(KeyTable head, std::vector<Field<S>> rows, Finish and_then = {}, S otherwise = {})
      : KeyTable(std::move(head)),
        fields(std::move(rows)),
        finish(std::move(and_then)),
        defaults(std::move(otherwise)) {
    keys.assign(fields.begin(), fields.end());
  }
  // Reads the table into `made`, in the order of the rows. Refuses unknown keys first. Throws
  // CaseFileError.
  void read_into(const TomlTable& table, const CaseDefinition& definition, S& made) const {
    table.allow_only(names());
    for (const Field<S>& one : fields)
      if (one.read) one.read(one, table, definition, made);
    if (finish) finish(table, definition, made);
  }
  S operator()(const TomlTable& table, const CaseDefinition& definition) const {
    S made = defaults;
    read_into(table, definition, made);
    return made;
  }
};

// As one call, for lists of tables.
inline KeyTable key_table(const std::string& id, const std::string& heading,
                          const std::string& needed, const std::string& meaning,
                          std::vector<KeyEntry> keys, std::vector<std::string> solvers = {}) {
  return {id, heading, needed, meaning, std::move(keys), std::move(solvers)};
}

// Both in the order of the reference.
const std::vector<KeyTable>& case_key_tables();
const std::vector<KeyTable>& campaign_key_tables();

// Returns the names of the keys of the table with this id. Throws std::logic_error for an unknown
// id.
std::vector<std::string> keys_of(const std::string& id);

// Returns the keys of [[run]] whose value is a list by itself, of all solvers.
std::vector<std::string> list_keys_of_runs();

// Returns the reference of both kinds of file as Markdown.
std::string key_reference();

// Return the JSON Schema (draft 7) of case and campaign files, for editors that complete and check
// TOML by a schema. It states the tables, their keys, which are required, the types, and the bounds
// that are numbers. The parser knows more: what one value means for another.
std::string case_schema();
std::string campaign_schema();

}  // namespace slosh
