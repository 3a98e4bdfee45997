// Whether a name stands in a list.
#pragma once

#include <algorithm>

namespace slosh {

template <class Name, class List>
bool is_one_of(const Name& name, const List& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace slosh
