// Figures of many curves as several panels, each of few enough to tell apart.
#pragma once

#include <cstddef>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh {

inline constexpr std::size_t most_curves = 6;  // as many as there are hues

// Returns the figure itself if it has at most six curves; otherwise figures of at most six with the
// same axes, each with all references and guides, as far as there is room for a run beside them.
// The first one keeps the id.
std::vector<reports::Figure> in_panels(const reports::Figure& figure);

}  // namespace slosh
