// Where a result comes from: the versions, the compiler and the processor that made it, when and
// how to repeat it.
#pragma once

#include <map>
#include <string>

namespace slosh {

// slosh_version, compiler, compiler_flags, processor, date_utc (ISO 8601, now), command.
std::map<std::string, std::string> provenance(const std::string& command);

}  // namespace slosh
