#include "verification/runs/fitting_spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "sph/start/initial_lattice.hpp"
#include "verification/case/shape/tank_shape.hpp"

namespace slosh {
namespace {

constexpr double rounding = 1e-6;  // of lengths that are written with a few decimals

double lattice_length(const CaseDefinition& definition) {
  return definition.liquid.column_width.value_or(definition.tank.length);
}

// By which share of itself a cell is stretched along the length.
double stretch(double length, double spacing) {
  const double count = std::max(1.0, std::round(length / spacing));
  return std::abs(length / (count * spacing) - 1);
}

bool fits(const CaseDefinition& definition, double spacing) {
  return stretch(lattice_length(definition), spacing) <= sph::largest_stretch &&
         stretch(definition.liquid.fill_depth, spacing) <= sph::largest_stretch;
}

}  // namespace

std::optional<double> nearest_fitting_spacing(const CaseDefinition& definition, double spacing) {
  if (!is_rectangle(definition.tank)) return std::nullopt;
  const double length = lattice_length(definition);
  const auto fewest = static_cast<long>(std::max(1.0, std::ceil(length / (2 * spacing)))),
             most = static_cast<long>(std::floor(2 * length / spacing));
  for (const double allowed : {rounding, sph::largest_stretch}) {
    std::optional<double> nearest;
    for (long count = fewest; count <= most; ++count) {
      const double tried = length / static_cast<double>(count);
      if (!(stretch(definition.liquid.fill_depth, tried) <= allowed)) continue;
      if (!nearest || std::abs(std::log(tried / spacing)) < std::abs(std::log(*nearest / spacing)))
        nearest = tried;
    }
    if (nearest) return nearest;
  }
  return std::nullopt;
}

std::string spacing_hint(const std::string& refusal, const CaseDefinition& definition,
                         const RunDefinition& run) {
  if (refusal.find("particle_spacing = ") == std::string::npos) return "";
  const auto* sph = std::get_if<SphRun>(&run.solver);
  if (!sph || sph->surface_particle_spacing != sph->particle_spacing ||
      fits(definition, sph->particle_spacing))
    return "";
  const std::optional<double> nearest = nearest_fitting_spacing(definition, sph->particle_spacing);
  return nearest ? fmt::format("; the nearest that divides both is {:.6g} m", *nearest) : "";
}

}  // namespace slosh
