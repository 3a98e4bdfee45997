// Where a line of cells is half full for the last time.
#pragma once

#include <optional>
#include <vector>

namespace slosh::openfoam {

// In cells from the line's begin: linear between the centres of the last cell that is half full and
// the next, and with the last one's filling where the next is not among `cells`, because a wall or
// an obstacle is there. `cells`: the numbers of the free cells, ascending; `fractions`: the
// liquid's share of each. Empty where none is half full.
std::optional<double> last_half_full(const std::vector<int>& cells,
                                     const std::vector<double>& fractions);

}  // namespace slosh::openfoam
