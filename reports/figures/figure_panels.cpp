#include "reports/figures/figure_panels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/drawing/axes.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

// Whether the curve stands in each panel: references and guides, beside the runs that have a look.
bool is_shared(const Curve& curve, bool runs_have_looks) {
  return runs_have_looks && (!curve.look || curve.look->is_reference);
}

}  // namespace

std::vector<Figure> in_panels(const Figure& figure) {
  if (figure.curves.size() <= most_curves) return {figure};
  const bool looks =
      std::any_of(figure.curves.begin(), figure.curves.end(),
                  [](const Curve& curve) { return curve.look && !curve.look->is_reference; });
  const auto shared = static_cast<std::size_t>(
      std::count_if(figure.curves.begin(), figure.curves.end(),
                    [&](const Curve& curve) { return is_shared(curve, looks); }));
  const std::size_t of_runs = figure.curves.size() - shared,
                    room = most_curves - std::min(shared, most_curves - 1),
                    count = (of_runs + room - 1) / room;
  const auto [horizontal, vertical] = reports::plot_ranges(figure);
  std::vector<Figure> panels;
  for (std::size_t panel = 0; panel < count; ++panel) {
    Figure part = figure;
    if (panel > 0) part.id += fmt::format("-{}", panel + 1);
    part.title += fmt::format(" ({} of {})", panel + 1, count);
    part.x_range = {horizontal.lower, horizontal.upper};
    part.y_range = {vertical.lower, vertical.upper};
    std::size_t number = 0;  // among the runs
    std::erase_if(part.curves, [&](const Curve& curve) {
      return !is_shared(curve, looks) && number++ * count / of_runs != panel;
    });
    panels.push_back(std::move(part));
  }
  return panels;
}

}  // namespace slosh
