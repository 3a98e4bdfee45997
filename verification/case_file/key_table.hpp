// The table of the keys of case and campaign files. The parser accepts only these keys, and the
// case-file reference (`slosh explain --keys`), the schemas (key_schema.hpp) and the comments of a
// new case (commented_case.hpp) are generated from the table. The rules for the values are the
// parser's; the table describes them in words. A [[sweep]] takes the keys of [[run]] beside its
// own.
#pragma once

#include <string>
#include <vector>

namespace slosh {

struct KeyEntry {
  std::string name;
  std::string value;   // what it must be: "number > 0, m"
  std::string needed;  // "yes", "no", or when: "with type = \"sine\""
  std::string meaning;
};

// A table of the file, or the keys that a solver adds to [[run]].
struct KeyTable {
  std::string id;       // "tank", "run", "run.sph"
  std::string heading;  // "[tank]", "[[run]] with solver = \"sph\""
  std::string needed;   // as for a key
  std::string meaning;
  std::vector<KeyEntry> keys;
};

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
