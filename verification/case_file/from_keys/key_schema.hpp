// The JSON Schema (draft 7) of case and campaign files, made from the table of keys
// (key_table.hpp), for editors that complete and check TOML by a schema. It states the tables,
// their keys, which are required, the types, and the bounds that are numbers. The parser knows
// more: what one value means for another.
#pragma once

#include <string>

namespace slosh {

std::string case_schema();
std::string campaign_schema();

}  // namespace slosh
