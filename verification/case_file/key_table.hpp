// The tables of the keys of case and campaign files. A row says of a key where its value goes, what
// it must be, when it is needed and what it means. Reading and checking a file, the case-file
// reference (`slosh explain --keys`), the schemas (key_schema.hpp) and the comments of a new case
// (commented_case.hpp) come from these rows. A [[sweep]] takes the keys of [[run]] beside its own.
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "verification/case_file/key_value.hpp"

namespace slosh {

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
};

// A table of the file, or the keys that a solver adds to [[run]].
struct KeyTable {
  std::string id;       // "tank", "run", "run.sph"
  std::string heading;  // "[tank]", "[[run]] with solver = \"sph\""
  std::string needed;   // as for a key
  std::string meaning;
  std::vector<KeyEntry> keys = {};
  std::vector<std::string> solvers = {};  // whose runs have these keys

  std::vector<std::string> names() const;
};

// A key whose value becomes part of a struct S, or is read by the section without `read`.
template <class S>
struct Field : KeyEntry {
  std::function<void(const TomlTable&, const CaseDefinition&, S&)> read = {};
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
  return {{name, value, needed, meaning},
          [=, at = std::string(name)](const TomlTable& table, const CaseDefinition& definition,
                                      S& made) {
            if (!table.has(at) && !(needed.in && needed.in(table))) return;
            T read = read_value<T>(value, table, at, definition);
            if constexpr (std::is_same_v<T, double>) read *= per_unit;
            part(made) = std::move(read);
          }};
}

// A member, and one of a part that is made when one of its keys is read.
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

// The table of the keys of a struct.
template <class S>
struct FieldTable : KeyTable {
  std::vector<Field<S>> fields;

  FieldTable(KeyTable head, std::vector<Field<S>> rows)
      : KeyTable(std::move(head)), fields(std::move(rows)) {
    keys.assign(fields.begin(), fields.end());
  }
  // Reads the fields into `made`, in the order of the rows. Throws CaseFileError.
  void read_into(const TomlTable& table, const CaseDefinition& definition, S& made) const {
    for (const Field<S>& one : fields)
      if (one.read) one.read(table, definition, made);
  }
  // Refuses unknown keys first.
  S read_all(const TomlTable& table, const CaseDefinition& definition, S made = {}) const {
    table.allow_only(names());
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

}  // namespace slosh
