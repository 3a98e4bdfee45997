#include "openfoam_cases/geometry/half_full.hpp"

#include <algorithm>
#include <cassert>

namespace slosh::openfoam {

std::optional<double> last_half_full(const std::vector<int>& cells,
                                     const std::vector<double>& fractions) {
  assert(fractions.size() == cells.size());
  for (std::size_t i = cells.size(); i-- > 0;) {
    const double share = fractions[i];
    if (!(share >= 0.5)) continue;
    const bool before_wall = i + 1 == cells.size() || cells[i + 1] != cells[i] + 1;
    const double in_cell =
        before_wall ? std::min(share, 1.0) : 0.5 + (share - 0.5) / (share - fractions[i + 1]);
    return cells[i] + in_cell;
  }
  return std::nullopt;
}

}  // namespace slosh::openfoam
