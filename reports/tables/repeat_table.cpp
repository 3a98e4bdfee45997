#include "reports/tables/repeat_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/tables/impact_table.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

using Row = std::vector<std::string>;
using Repeats = std::vector<const RunDefinition*>;

bool differ_in_seed_alone(const SphRun& one, const SphRun& other) {
  SphRun alike = other;
  alike.start_seed = one.start_seed;
  return one == alike && one.start_seed != other.start_seed;
}

// The peaks of an impact over the repeats.
struct Sample {
  std::vector<double> peaks;          // [Pa], of the repeats in which the impact came
  std::size_t usable = 0;             // repeats with a pressure
  std::vector<std::string> left_out;  // without
};

Sample sample_of(const CaseAssessment& assessment, const Repeats& repeats,
                 const std::string& pressure, std::size_t impact) {
  Sample sample;
  for (const RunDefinition* run : repeats) {
    try {
      const auto result = assessment.runs.results.find(run->name);
      if (result == assessment.runs.results.end())
        throw ResultError(state_name(assessment.runs.status.at(run->name).state));
      const auto peaks = impacts_in(result->second.at(pressure), assessment.definition);
      ++sample.usable;
      if (peaks[impact]) sample.peaks.push_back(peaks[impact]->pressure);
    } catch (const std::runtime_error& error) {  // ResultError and ComparisonError
      sample.left_out.push_back(fmt::format("{} ({})", run->name, error.what()));
    }
  }
  return sample;
}

// Mean, standard deviation, central 90 %.
Row moments(const Distribution& peaks) {
  const std::size_t count = peaks.sorted().size();
  Row row{fmt::format("{:.0f}", peaks.mean()),
          count < 2 ? std::string("of one") : fmt::format("{:.0f}", peaks.standard_deviation())};
  try {
    const Interval interval = peaks.central_90_percent();
    row.push_back(fmt::format("{:.0f} to {:.0f}", interval.low, interval.high));
  } catch (const ComparisonError&) {
    row.push_back("needs 20");
  }
  return row;
}

Row experiment_row(const CaseDefinition& definition, std::size_t impact) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  Row row{"experiment", "as published", fmt::format("{}", impact + 1)};
  if (impacts.repeats.empty()) {
    row.insert(row.end(), {"", fmt::format("{:.0f}", impacts.peak_means[impact]),
                           fmt::format("{:.0f}", impacts.peak_deviations[impact]), "not supplied"});
  } else {
    const Distribution peaks = repeated_peaks(definition, impact);
    row.push_back(fmt::format("{0} of {0}", peaks.sorted().size()));
    const Row rest = moments(peaks);
    row.insert(row.end(), rest.begin(), rest.end());
  }
  row.insert(row.end(), {"", "", ""});
  return row;
}

Row run_row(const CaseAssessment& assessment, const Repeats& repeats, const std::string& pressure,
            std::size_t impact) {
  const CaseDefinition& definition = assessment.definition;
  const Sample sample = sample_of(assessment, repeats, pressure, impact);
  Row row{fmt::format("{} to {}", repeats.front()->name, repeats.back()->name),
          pressure_word(pressure), fmt::format("{}", impact + 1),
          fmt::format("{} of {}", sample.peaks.size(), sample.usable)};
  if (sample.peaks.empty()) {
    row.insert(row.end(), 5, "");
  } else {
    const Distribution peaks("peaks of " + repeats.front()->name, sample.peaks);
    const Row rest = moments(peaks);
    row.insert(row.end(), rest.begin(), rest.end());
    if (definition.impacts->repeats.empty()) {
      row.insert(row.end(), {"not supplied", ""});
    } else {
      const Distribution experiment = repeated_peaks(definition, impact);
      const double area = area_metric(peaks, experiment);
      row.insert(row.end(), {fmt::format("{:.0f}", area),
                             fmt::format("{:.0f}", 100 * area / experiment.mean())});
    }
  }
  row.push_back(fmt::format("{}", fmt::join(sample.left_out, "; ")));
  return row;
}

}  // namespace

std::vector<Repeats> repeated_runs(const CaseDefinition& definition) {
  std::vector<Repeats> groups;
  for (const RunDefinition& run : definition.runs) {
    const SphRun* sph = std::get_if<SphRun>(&run.solver);
    if (!sph) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Repeats& one) {
      return differ_in_seed_alone(std::get<SphRun>(one.front()->solver), *sph);
    });
    if (group == groups.end())
      groups.push_back({&run});
    else
      group->push_back(&run);
  }
  std::erase_if(groups, [](const Repeats& group) { return group.size() < 2; });
  return groups;
}

std::optional<reports::Table> repeat_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const auto groups = repeated_runs(definition);
  if (!definition.impacts || groups.empty()) return std::nullopt;
  reports::Table table{
      definition.name + "-repeats",
      "Repeats",
      "Peaks over the runs that differ in the seed of their disordered start alone, beside those "
      "over the experiment's repeats. The area metric is the area between the two cumulative "
      "distributions, and beside it in percent of the experiment's mean; both samples are small, "
      "so that two of the same distribution are apart too.",
      {"repeats", "pressure", "impact", "came", "mean [Pa]", "sd [Pa]", "central 90 % [Pa]",
       "area metric [Pa]", "area metric [% of mean]", "left out"},
      {}};
  for (std::size_t impact = 0; impact < definition.impacts->times.size(); ++impact) {
    table.rows.push_back(experiment_row(definition, impact));
    for (const Repeats& group : groups)
      for (const std::string& pressure : impact_pressures(definition))
        table.rows.push_back(run_row(assessment, group, pressure, impact));
  }
  return table;
}

}  // namespace slosh
