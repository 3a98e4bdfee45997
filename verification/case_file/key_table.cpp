#include "verification/case_file/key_table.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace slosh {
namespace {

std::function<bool(const TomlTable&)> where_written(const std::string& key,
                                                    const std::string& value) {
  return [=](const TomlTable& table) { return table.written(key) == value; };
}

}  // namespace

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

}  // namespace slosh
