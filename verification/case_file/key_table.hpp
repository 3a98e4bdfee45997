// The keys of case and campaign files, in one table: the parser takes the names of its keys from
// here and refuses all others, and the case-file reference (docs/case_file.md) is made from it.
// What a value must be is the parser's own rule, which the words here describe. A [[sweep]] takes
// the keys of [[run]] beside its own.
#pragma once

#include <string>
#include <vector>

namespace slosh {

struct KeyEntry {
  std::string name;
  std::string value;   // what the key holds: "number > 0, m"
  std::string needed;  // "yes", "no", or when: "with type = \"sine\""
  std::string meaning;
};

// A table of the file, or what a solver adds to the keys of [[run]].
struct KeyTable {
  std::string id;       // "tank", "run", "run.sph"
  std::string heading;  // "[tank]", "[[run]] with solver = \"sph\""
  std::string needed;   // as of a key
  std::string meaning;
  std::vector<KeyEntry> keys;
};

// In the order of the reference.
const std::vector<KeyTable>& case_key_tables();
const std::vector<KeyTable>& campaign_key_tables();

// The names of the keys of the table with this id, of either kind of file. Throws std::logic_error
// for an id that no table has.
std::vector<std::string> keys_of(const std::string& id);

// The reference of both kinds of file as Markdown: docs/case_file.md.
std::string key_reference();

}  // namespace slosh
