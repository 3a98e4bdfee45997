// Writes the long lines of an SVG drawing in a third of their length: figures of long histories are
// most of a report's weight.
#pragma once

#include <string>

namespace slosh::reports {

// Returns the tag of a <path> or a <polygon> with its places rounded to a tenth of a pixel and each
// place relative to the one before it. Rounding does not add up, since the rounded places are
// subtracted. A polygon becomes a closed path. Short lines, other tags and paths of other commands
// than M and L are returned as they are: gnuplot scales its symbols, which tenths would deform.
std::string with_relative_places(const std::string& tag);

}  // namespace slosh::reports
