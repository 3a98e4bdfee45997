#include "reports/wording/shown_quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "reports/wording/case_text.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

constexpr std::string_view filtered = through_filter;

template <class Gauge>
const Gauge& gauge_named(const std::vector<Gauge>& gauges, const std::string& name) {
  const auto found = std::find_if(gauges.begin(), gauges.end(),
                                  [&](const Gauge& gauge) { return gauge.name == name; });
  if (found == gauges.end()) throw std::invalid_argument("the case has no gauge " + name);
  return *found;
}

// A tank of many metres has elevations in m, and loads and pressures in thousands.
void suit_the_size(const CaseDefinition& definition, ShownQuantity& shown) {
  constexpr double long_tank = 5, large = 1e4;
  const double depth = definition.liquid.fill_depth,
               pressure = definition.liquid.density * definition.gravity * depth;
  if (shown.unit == "mm" && definition.tank.length >= long_tank) {
    shown.unit = "m";
    shown.scale = 1;
  }
  for (const auto& [unit, still] : {std::pair{"Pa", pressure},
                                    {"N/m", pressure * depth},
                                    {"N", pressure * depth * definition.tank.length}})
    if (shown.unit == unit && still >= large) {
      shown.unit = std::string("k") + unit;
      shown.scale *= 1e-3;
      break;
    }
}

}  // namespace

std::string place_on_wall(const PressureGaugeDefinition& gauge) {
  if (gauge.at)
    return fmt::format("on the outline {:.3g} m from the left and {:.3g} m above the bottom",
                       gauge.at->x, gauge.at->z);
  const bool is_level = gauge.wall == Wall::bottom || gauge.wall == Wall::roof;
  return fmt::format("on the {} {:.3g} m {}",
                     name_of(gauge.wall, wall_names) + std::string(is_level ? "" : " wall"),
                     gauge.position, is_level ? "from the left wall" : "above the bottom");
}

ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity) {
  const Quantity* known = find_quantity(quantity);
  if (!known) throw std::invalid_argument("no figure shows " + quantity);
  ShownQuantity shown{.title = known->title,
                      .word = known->label,
                      .unit = known->shown_unit,
                      .scale = known->shown_per_si,
                      .what = known->meaning,
                      .sph = known->sph,
                      .interfoam = known->interfoam,
                      .theory = known->theory};
  suit_the_size(definition, shown);
  const bool of_filtered = is_filtered(quantity);
  std::string gauge = known->at == MeasuredAt::tank ? "" : quantity.substr(quantity.find('@') + 1);
  if (of_filtered) gauge.resize(gauge.size() - filtered.size());
  const PressureGaugeDefinition* sensor = nullptr;
  switch (known->at) {
    case MeasuredAt::tank:
      break;
    case MeasuredAt::pressure_gauge:
      sensor = &gauge_named(definition.pressure_gauges, gauge);
      shown.title += " " + place_on_wall(*sensor);
      if (sensor->filter_cutoff) shown.title += of_filtered ? ", filtered" : ", unfiltered";
      shown.what += sensor->width > 0
                        ? fmt::format(", the mean over a sensor of {:.3g} mm along the wall.",
                                      1000 * sensor->width)
                        : ", at a point.";
      break;
    case MeasuredAt::surface_gauge:
      shown.title +=
          fmt::format(" {:.3g} m from the left wall", gauge_named(definition.gauges, gauge).x);
      break;
    case MeasuredAt::probe: {
      const ProbeDefinition& probe = gauge_named(definition.probes, gauge);
      shown.title +=
          fmt::format(" {:.3g} m from the left wall, {:.3g} m above the bottom", probe.x, probe.z);
      break;
    }
    case MeasuredAt::wall:
      shown.title += ", on the " + gauge + (gauge == "bottom" || gauge == "roof" ? "" : " wall");
      break;
  }
  if (known->tells_sampling)
    shown.recorded = fmt::format(
        "Solvers and theory are sampled every {:.3g} s (instantaneous values){}.",
        definition.sample_interval,
        of_filtered && sensor
            ? "; then the same low-pass filter for all: " + low_pass_name(*sensor->filter_cutoff)
            : ", and not filtered");
  return shown;
}

std::string measured_how(const ShownQuantity& shown, const CaseDefinition& definition,
                         const std::vector<std::string>& runs) {
  const auto any = [&](auto is) {
    return std::any_of(runs.begin(), runs.end(),
                       [&](const std::string& run) { return is(run_named(definition, run)); });
  };
  std::vector<std::string> ways;
  const auto add = [&](const char* who, const std::string& way, bool is_shown) {
    if (is_shown && !way.empty()) ways.push_back(who + way);
  };
  add("SPH: ", shown.sph, any([](const auto& run) { return solver_kind(run).has_particles; }));
  add("OpenFOAM: ", shown.interfoam,
      any([](const auto& run) { return std::holds_alternative<InterFoamRun>(run.solver); }));
  add("theory: ", shown.theory, any(is_theory));
  std::string text = shown.what.empty() ? "" : shown.what + " ";
  if (!ways.empty()) text += fmt::format("{}. ", fmt::join(ways, "; "));
  return text + (shown.recorded.empty() ? "" : shown.recorded + " ");
}

std::string id_of(const std::string& quantity) {
  std::string id = quantity;
  if (is_filtered(id)) id = "filtered_" + id.substr(0, id.size() - filtered.size());
  const std::size_t at = id.find('@');
  return at == id.npos ? id : id.substr(0, at) + "-" + name_id(id.substr(at + 1));
}

}  // namespace slosh
