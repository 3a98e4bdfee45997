#include "reports/figures/shown_quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "verification/assessment/case_assessment.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

constexpr std::string_view filtered = "/filtered";

template <class Gauge>
const Gauge& gauge_named(const std::vector<Gauge>& gauges, const std::string& name) {
  const auto found = std::find_if(gauges.begin(), gauges.end(),
                                  [&](const Gauge& gauge) { return gauge.name == name; });
  if (found == gauges.end()) throw std::invalid_argument("the case has no gauge " + name);
  return *found;
}

std::string wall_text(const PressureGaugeDefinition& gauge) {
  if (gauge.wall == Wall::bottom)
    return fmt::format("on the bottom {:.3g} m from the left wall", gauge.position);
  return fmt::format("on the {} wall {:.3g} m above the bottom",
                     gauge.wall == Wall::left ? "left" : "right", gauge.position);
}

std::string sampled(const CaseDefinition& definition) {
  return fmt::format("Solvers and theory are sampled every {:.3g} s, at that instant",
                     definition.sample_interval);
}

ShownQuantity pressure(const CaseDefinition& definition, const std::string& name,
                       bool is_filtered) {
  const PressureGaugeDefinition& gauge = gauge_named(definition.pressure_gauges, name);
  const std::string state = is_filtered ? ", filtered" : gauge.filter_cutoff ? ", unfiltered" : "";
  return {
      .title = "Pressure " + wall_text(gauge) + state,
      .word = "pressure",
      .unit = "Pa",
      .scale = 1,
      .what = "Above the gas's pressure, " +
              (gauge.width > 0 ? fmt::format("the mean over a sensor of {:.3g} mm along the wall.",
                                             1000 * gauge.width)
                               : "at a point."),
      .sph = "the kernel's mean over three spacings, carried to the wall by its pressure gradient",
      .interfoam = "interpolated between the wall's faces, less the gas's mean",
      .theory = {},
      .recorded = sampled(definition) + (is_filtered ? "; then one low-pass filter for all: " +
                                                           low_pass_name(*gauge.filter_cutoff) + "."
                                                     : ", and not filtered.")};
}

ShownQuantity load(const CaseDefinition& definition, const std::string& title, const char* word,
                   const char* unit, const std::string& what) {
  return {.title = title,
          .word = word,
          .unit = unit,
          .scale = 1,
          .what = what,
          .sph = "the reaction to what the walls give the particles",
          .interfoam = "that of liquid and gas on walls and obstacles",
          .theory = "the liquid's pressure on the walls and the bottom up to the still surface",
          .recorded = sampled(definition) + ", and not filtered."};
}

ShownQuantity ungauged(const CaseDefinition& definition, const std::string& quantity) {
  const std::string along = "On the tank, per metre of width, along the tank's axes.";
  if (quantity == "front_position")
    return {"Front of the breaking dam, from the left wall", "front position", "mm", 1000};
  if (quantity == "force_x")
    return load(definition, "Force along the tank's bottom", "force x", "N/m", along);
  if (quantity == "force_z")
    return load(definition, "Force normal to the tank's bottom", "force z", "N/m", along);
  if (quantity == "moment")
    return load(definition, "Moment about the roll's axis", "moment", "N",
                "On the tank, per metre of width, counter-clockwise.");
  const bool horizontal = quantity == "momentum_x";
  if (!horizontal && quantity != "momentum_z")
    throw std::invalid_argument("no figure shows " + quantity);
  return {horizontal ? "Total momentum, horizontal" : "Total momentum, vertical",
          horizontal ? "momentum x" : "momentum z", "kg/s", 1,
          "Of the liquid against the earth, along the earth's axes, per metre of width."};
}

ShownQuantity surface(const std::string& kind, double x) {
  if (kind == "elevation")
    return {.title = fmt::format("Surface elevation {:.3g} m from the left wall", x),
            .word = "elevation",
            .unit = "mm",
            .scale = 1000,
            .sph =
                "the depth of liquid over the gauge, drops and overturning jets included, less the "
                "still depth",
            .interfoam = "the filling of the column of cells at the gauge, less the still depth"};
  return {.title = fmt::format("Highest surface {:.3g} m from the left wall", x),
          .word = "highest surface",
          .unit = "mm",
          .scale = 1000,
          .what = "Of whatever is wet over the gauge, above the still level.",
          .sph = "the upper edge of the highest particle within a spacing",
          .interfoam = "the highest place of the column where a cell is half full"};
}

}  // namespace

ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity) {
  const std::size_t at = quantity.find('@');
  if (at == quantity.npos) return ungauged(definition, quantity);
  const std::string kind = quantity.substr(0, at);
  std::string gauge = quantity.substr(at + 1);
  if (kind != "wall_pressure") return surface(kind, gauge_named(definition.gauges, gauge).x);
  const bool is_filtered = gauge.ends_with(filtered);
  if (is_filtered) gauge.resize(gauge.size() - filtered.size());
  return pressure(definition, gauge, is_filtered);
}

std::string measured_how(const ShownQuantity& shown, const CaseDefinition& definition,
                         const std::vector<std::string>& runs) {
  const auto any = [&](auto is) {
    return std::any_of(runs.begin(), runs.end(), [&](const std::string& run) {
      return is(run_named(definition, run).solver);
    });
  };
  std::vector<std::string> ways;
  const auto add = [&](const char* who, const std::string& way, bool is_shown) {
    if (is_shown && !way.empty()) ways.push_back(who + way);
  };
  add("SPH: ", shown.sph, any([](const auto& one) { return std::holds_alternative<SphRun>(one); }));
  add("interFoam: ", shown.interfoam,
      any([](const auto& one) { return std::holds_alternative<InterFoamRun>(one); }));
  add("theory: ", shown.theory, any([](const auto& one) {
        return std::holds_alternative<LinearRun>(one) ||
               std::holds_alternative<PotentialRun>(one) ||
               std::holds_alternative<ViscousWaveRun>(one);
      }));
  std::string text = shown.what.empty() ? "" : shown.what + " ";
  if (!ways.empty()) text += fmt::format("{}. ", fmt::join(ways, "; "));
  return text + (shown.recorded.empty() ? "" : shown.recorded + " ");
}

std::string id_of(const std::string& quantity) {
  std::string id = quantity;
  if (id.ends_with(filtered)) id = "filtered_" + id.substr(0, id.size() - filtered.size());
  std::replace(id.begin(), id.end(), '@', '-');
  return id;
}

}  // namespace slosh
