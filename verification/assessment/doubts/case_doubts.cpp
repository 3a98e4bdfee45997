#include "verification/assessment/doubts/case_doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/external/external_script.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// Cells that are stretched by less are square to within what the particles' own disorder changes.
constexpr double unseen_stretch = 0.005;
// A gauge of SPH measures the liquid in a column that reaches so far to either side: twice the
// window's width of three spacings (sph/recording/free_surface.hpp).
constexpr double column_reach = 6;
// The moving fits of the report take three periods (docs/results.md).
constexpr double fewest_periods = 3;
// With fewer samples a period, the largest sample misses more than 5 % of a sine's crest:
// 1 - cos(pi / 10).
constexpr double fewest_samples = 10;

using Doubts = std::vector<std::string>;

// How much the cells of a lattice of this spacing are stretched to fill a length.
double stretch(double length, double spacing) {
  return std::abs(length / (std::max(1.0, std::round(length / spacing)) * spacing) - 1);
}

// Returns the spacing nearest to this one that divides the tank's length and the depth, or 0.
double dividing_spacing(const CaseDefinition& definition, double spacing) {
  constexpr double whole = 1e-9;  // of a spacing
  const double length = definition.liquid.column_width.value_or(definition.tank.length);
  double nearest = 0;
  for (int n = std::max(1, static_cast<int>(length / (2 * spacing))); n <= 2 * length / spacing;
       ++n)
    if (const double one = length / n; stretch(definition.liquid.fill_depth, one) < whole)
      if (nearest == 0 || std::abs(one - spacing) < std::abs(nearest - spacing)) nearest = one;
  return nearest;
}

void doubt_spacings(const CaseDefinition& definition, Doubts& doubts) {
  if (!is_rectangle(definition.tank)) return;  // no lattice fits its walls
  const double length = definition.liquid.column_width.value_or(definition.tank.length);
  std::vector<double> told;
  for (const RunDefinition& run : definition.runs) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    if (!sph || std::find(told.begin(), told.end(), sph->particle_spacing) != told.end()) continue;
    told.push_back(sph->particle_spacing);
    const double stretched = std::max(stretch(length, sph->particle_spacing),
                                      stretch(definition.liquid.fill_depth, sph->particle_spacing));
    if (stretched < unseen_stretch) continue;
    const double nearest = dividing_spacing(definition, sph->particle_spacing);
    doubts.push_back(
        fmt::format("run {}: particle_spacing_m = {:g} does not divide the liquid's length and "
                    "depth: the start "
                    "stretches its cells by {:.2g} %{}",
                    run.name, sph->particle_spacing, 100 * stretched,
                    nearest > 0 ? fmt::format("; the nearest that does is {:.6g}", nearest) : ""));
  }
}

double coarsest_spacing(const CaseDefinition& definition) {
  double coarsest = 0;
  for (const RunDefinition& run : definition.runs)
    if (const auto* sph = std::get_if<SphRun>(&run.solver))
      coarsest = std::max(coarsest, sph->particle_spacing);
  return coarsest;
}

void doubt_gauges(const CaseDefinition& definition, Doubts& doubts) {
  const double reach = column_reach * coarsest_spacing(definition);
  for (const GaugeDefinition& gauge : definition.gauges)
    for (const ObstacleDefinition& obstacle : definition.obstacles) {
      const double away = std::max({obstacle.left - gauge.x, gauge.x - obstacle.right, 0.0});
      const bool is_wet = obstacle.bottom < definition.liquid.fill_depth;
      if (is_wet && away < reach)
        doubts.push_back(fmt::format(
            "gauge {}: x_m = {:g} is {:.3g} m from the obstacle {}: within six spacings of the "
            "coarsest SPH run, {:.3g} m, it reads too low",
            gauge.name, gauge.x, away, obstacle.name, reach));
    }
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (!is_under_still_water(definition, gauge))
      for (const GateRow& row : definition.gate)
        if (!row.reference.empty() && row.quantity.starts_with(wall_pressure(gauge.name)) &&
            std::holds_alternative<LinearRun>(run_named(definition, row.reference).solver))
          doubts.push_back(fmt::format(
              "gate row of line {}: {} has no pressure at the gauge {}, which is not wholly below "
              "the still level",
              row.where.line, row.reference, gauge.name));
}

struct Tone {
  std::string name;
  double period;  // [s]
};

std::vector<Tone> fitted_tones(const CaseDefinition& definition) {
  std::vector<Tone> tones;
  const std::vector<ForcedMode> forced = forced_modes(definition);
  for (const ForcedMode& mode : forced)
    tones.push_back({forced.size() == 1 ? "the motion" : mode.name,
                     2 * std::numbers::pi / mode.angular_frequency});
  for (const auto& [number, frequency] : excited_frequencies(definition, definition.natural_modes))
    tones.push_back({fmt::format("natural_{}", number), 2 * std::numbers::pi / frequency});
  return tones;
}

void doubt_times(const CaseDefinition& definition, Doubts& doubts) {
  const double window = definition.window_end - definition.window_begin;
  for (const Tone& tone : fitted_tones(definition)) {
    if (window < fewest_periods * tone.period)
      doubts.push_back(
          fmt::format("comparison: its window of {:g} s is {:.2g} periods of {}, of {:.3g} s each: "
                      "three or more tell an amplitude from a trend",
                      window, window / tone.period, tone.name, tone.period));
    if (definition.sample_interval * fewest_samples > tone.period)
      doubts.push_back(fmt::format(
          "time: sample_interval_s = {:g} leaves {:.2g} samples in a period of {}: ten or more "
          "show "
          "its crests",
          definition.sample_interval, tone.period / definition.sample_interval, tone.name));
  }
}

// A record that begins within a sample of the window covers it.
void doubt_begin_of(const RunDefinition& run, const RecordRun& record,
                    const CaseDefinition& definition, Doubts& doubts) {
  const std::vector<double>& time = record.time;
  if (time.size() < 2) return;
  const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  if (time.front() > definition.window_begin + interval)
    doubts.push_back(
        fmt::format("run {}: the record begins at {:.6g} s, after the comparison's window, which "
                    "begins at {:g} s: {}",
                    run.name, time.front(), definition.window_begin,
                    time.front() < definition.window_end ? "rows on it judge what follows alone"
                                                         : "no row on it can be judged"));
}

void doubt_references(const CaseDefinition& definition, const CaseRuns& theories, Doubts& doubts) {
  if (definition.gate.empty())
    doubts.push_back("gate: there is no row: the case is only shown, and cannot fail");
  const bool has_truth =
      std::any_of(definition.runs.begin(), definition.runs.end(),
                  [](const RunDefinition& run) { return is_theory(run) || is_record(run); });
  if (!has_truth)
    doubts.push_back(
        "run: there is neither a theory nor a record: the simulations are compared with one "
        "another "
        "alone");
  for (const RunDefinition& run : definition.runs) {
    const auto is_on = [&](const GateRow& row) { return row.reference == run.name; };
    const auto rows = std::count_if(definition.gate.begin(), definition.gate.end(), is_on);
    const auto* record = std::get_if<RecordRun>(&run.solver);
    if (record && !record->supplied && rows > 0)
      doubts.push_back(
          fmt::format("run {}: the record is not supplied: {} gate rows need it", run.name, rows));
    if (record) doubt_begin_of(run, *record, definition, doubts);
    const auto found = theories.results.find(run.name);
    if (found == theories.results.end()) continue;
    if (const auto outside = outside_validity(definition, run, found->second))
      doubts.push_back(
          fmt::format("run {}: outside its range, it judges nothing ({} gate rows need it): it {}",
                      run.name, rows, *outside));
  }
}

void doubt_scripts(const CaseDefinition& definition, Doubts& doubts) {
  for (const RunDefinition& run : definition.runs)
    if (std::string doubt = script_doubt(run, definition); !doubt.empty())
      doubts.push_back(std::move(doubt));
}

void doubt_models(const CaseDefinition& definition, Doubts& doubts) {
  for (const ModelLimit& limit : model_limits(definition))
    if (limit.exceeded()) doubts.push_back("beyond the limit of the models: " + limit_text(limit));
}

}  // namespace

std::vector<std::string> case_doubts(const CaseDefinition& definition, const CaseRuns& theories) {
  Doubts doubts;
  doubt_spacings(definition, doubts);
  doubt_gauges(definition, doubts);
  doubt_times(definition, doubts);
  doubt_models(definition, doubts);
  doubt_references(definition, theories, doubts);
  doubt_scripts(definition, doubts);
  return doubts;
}

}  // namespace slosh
