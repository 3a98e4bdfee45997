#include "verification/campaign/figure_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "verification/campaign/choice_table.hpp"

namespace slosh {
namespace {

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

std::string kind_of(const SphRun& sph) {
  const double inside = 1000 * sph.particle_spacing, surface = 1000 * sph.surface_particle_spacing;
  std::string text = fmt::format("SPH, scheme {}, {:.4g} mm", sph.scheme, inside);
  if (surface != inside) text += fmt::format(" and {:.4g} mm at the surface", surface);
  if (const std::string changes = changes_of(sph); !changes.empty()) text += ", " + changes;
  return text;
}

std::string kind_of(const InterFoamRun& mesh) {
  return fmt::format("interFoam, {} x {} cells", mesh.cells_x, mesh.cells_z);
}

std::string kind_of(const LinearRun& linear) {
  return fmt::format("linear potential theory{}{}",
                     linear.modes > 0 ? fmt::format(", {} modes", linear.modes) : "",
                     linear.two_layer ? ", with the gas" : "");
}

std::string kind_of(const PotentialRun& potential) {
  return fmt::format("nonlinear potential flow, {} x {} nodes", potential.nodes_x,
                     potential.nodes_z);
}

std::string kind_of(const ViscousWaveRun&) { return "linear theory of the viscous wave"; }

std::string kind_of(const RecordRun& record) {
  return "published record " + record.file.filename().string();
}

std::string kind_of(const ExternalRun& external) {
  return "external program " + std::filesystem::path(external.command.front()).filename().string();
}

}  // namespace

std::string family(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) return sph->scheme;
  if (std::holds_alternative<InterFoamRun>(run.solver)) return "interFoam";
  return run.name;
}

double resolution(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return 1 / (sph->particle_spacing * sph->surface_particle_spacing);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return 1.0 * mesh->cells_x * mesh->cells_z;
  return 0;
}

bool is_changed(const RunDefinition& run) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  return sph && !changes_of(*sph).empty();
}

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::function<bool(const RunResult&)>& has) {
  const auto preference = [](const RunDefinition& run) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    const std::string changes = sph ? changes_of(*sph) : "";
    return std::tuple{changes.empty(), resolution(run),
                      -std::count(changes.begin(), changes.end(), ',')};
  };
  std::vector<std::string> families;
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto result = assessment.runs.results.find(run.name);
    if (result == assessment.runs.results.end() || !has(result->second)) continue;
    const RunDefinition*& best = finest[family(run)];
    if (!best) families.push_back(family(run));
    if (!best || preference(run) > preference(*best)) best = &run;
  }
  std::vector<std::string> names;
  for (const std::string& one : families) names.push_back(finest[one]->name);
  return names;
}

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::string& quantity) {
  return finest_runs(assessment, [&](const RunResult& result) {
    return std::any_of(result.series.begin(), result.series.end(),
                       [&](const TimeSeries& series) { return series.name == quantity; });
  });
}

std::string run_label(const CaseAssessment& assessment, const std::string& run) {
  return assessment.runs.status.at(run).state == RunState::out_of_range
             ? run + " (out of its range)"
             : run;
}

// More run into one another.
constexpr std::size_t most_points = 200;

reports::Curve history_curve(const CaseAssessment& assessment, const std::string& run,
                             const std::string& quantity, const AxisScales& scales) {
  const TimeSeries& series = assessment.runs.results.at(run).at(quantity);
  reports::Curve curve{run_label(assessment, run),
                       scaled(series.time, scales.time),
                       scaled(series.value, scales.value),
                       {},
                       {}};
  if (const auto* record = std::get_if<RecordRun>(&run_named(assessment.definition, run).solver)) {
    if (record->time.size() <= most_points) curve.style = reports::Curve::Style::points;
    if (record->uncertainty)
      curve.y_error.assign(curve.y.size(), scales.value * *record->uncertainty);
  }
  return curve;
}

std::string who_is_who(const CaseDefinition& definition, const std::vector<std::string>& runs) {
  std::vector<std::string> texts;
  bool bars = false;
  for (const std::string& name : runs) {
    const RunDefinition& run = run_named(definition, name);
    texts.push_back(name + ": " +
                    std::visit([](const auto& solver) { return kind_of(solver); }, run.solver));
    const auto* record = std::get_if<RecordRun>(&run.solver);
    bars |= record && record->uncertainty;
  }
  return fmt::format("{}.{}", fmt::join(texts, "; "),
                     bars ? " Bars are a record's 95 % interval." : "");
}

}  // namespace slosh
