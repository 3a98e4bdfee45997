// The names of an enumeration's values, as files and messages write them: one table per
// enumeration.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slosh {

template <class Enum>
struct EnumName {
  Enum value;
  const char* name;
};

// Throws std::logic_error for a value that the table lacks.
template <class Enum, std::size_t n>
std::string name_of(Enum value, const EnumName<Enum> (&table)[n]) {
  for (const EnumName<Enum>& one : table)
    if (one.value == value) return one.name;
  throw std::logic_error("a value of an enumeration has no name");
}

// Throws std::logic_error for a name that the table lacks.
template <class Enum, std::size_t n>
Enum value_of(std::string_view name, const EnumName<Enum> (&table)[n]) {
  for (const EnumName<Enum>& one : table)
    if (one.name == name) return one.value;
  throw std::logic_error("no value of the enumeration has the name " + std::string(name));
}

template <class Enum, std::size_t n>
std::vector<std::string> all_names(const EnumName<Enum> (&table)[n]) {
  std::vector<std::string> names;
  for (const EnumName<Enum>& one : table) names.push_back(one.name);
  return names;
}

}  // namespace slosh
