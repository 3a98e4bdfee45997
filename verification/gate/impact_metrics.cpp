#include "verification/gate/impact_metrics.hpp"

#include <fmt/format.h>

#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

const ImpactsDefinition& published(const CaseDefinition& definition) {
  if (definition.impacts) return *definition.impacts;
  throw ComparisonError("the case " + definition.name + " has no [impacts]");
}

// 0 for "impact_1", 1 for "impact_2", ...
std::size_t impact_number(const std::string& mode, const ImpactsDefinition& impacts) {
  for (std::size_t n = 0; n < impacts.times.size(); ++n)
    if (mode == fmt::format("impact_{}", n + 1)) return n;
  throw ComparisonError("the case has no " + mode);
}

ComparisonError not_in_record(const TimeSeries& record, std::size_t n,
                              const CaseDefinition& definition) {
  return ComparisonError(fmt::format(
      "the record's own {} has no impact_{}: no peak above {:.4g} Pa, {:g} of the lowest mean peak "
      "published",
      record.name, n + 1, impact_threshold(published(definition).peak_means), impact_share));
}

// False for a record that cannot be searched, which excuses no candidate.
bool lacks_impact(const TimeSeries& record, std::size_t n, const CaseDefinition& definition) try {
  return !impacts_in(record, definition).at(n);
} catch (const ComparisonError&) {
  return false;
}

}  // namespace

std::vector<std::optional<ImpactPeak>> impacts_in(const TimeSeries& pressure,
                                                  const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = published(definition);
  return impact_peaks(pressure, impact_windows(impacts.times, impacts.period),
                      impact_threshold(impacts.peak_means));
}

double plateau_error(const TimeSeries& pressure, const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = published(definition);
  return plateau_mean(pressure, {impacts.plateau_begin, impacts.plateau_end}) / impacts.plateau - 1;
}

Distribution repeated_peaks(const CaseDefinition& definition, std::size_t n) {
  const ImpactsDefinition& impacts = published(definition);
  if (impacts.repeats.empty())
    throw NotSuppliedError(
        "the table of the experiment's repeats is not supplied: " +
        (impacts.peak_table.empty()
             ? std::string("the case names none")
             : fmt::format("expected {}, below the directory of --experiments or "
                           "SLOSH_EXPERIMENTS; where to get the original: {}",
                           impacts.peak_table.string(), impacts.source)));
  return {fmt::format("repeats of impact {}", n + 1), impacts.repeats.at(n)};
}

double expected_time(std::size_t n, const TimeSeries& pressure, const TimeSeries* record,
                     const CaseDefinition& definition) {
  if (!pressure.name.ends_with("/filtered")) return published(definition).times[n];
  if (!record)
    throw NotSuppliedError(
        "the published times are those of the unfiltered pressure, and the record, which would be "
        "filtered alike, is not supplied");
  const std::optional<ImpactPeak> peak = impacts_in(*record, definition).at(n);
  if (!peak) throw not_in_record(*record, n, definition);
  return peak->time;
}

double impact_metric(Metric metric, const std::string& mode, const TimeSeries& pressure,
                     const TimeSeries* record, const CaseDefinition& definition) {
  if (metric == Metric::plateau_error) return plateau_error(pressure, definition);
  const ImpactsDefinition& impacts = published(definition);
  const std::size_t n = impact_number(mode, impacts);
  const std::optional<ImpactPeak> peak = impacts_in(pressure, definition).at(n);
  if (!peak && record && lacks_impact(*record, n, definition))
    throw not_in_record(*record, n, definition);
  if (metric == Metric::impact_time)
    return peak ? peak->time - expected_time(n, pressure, record, definition) : not_a_number;
  if (metric != Metric::impact_percentile)
    throw std::logic_error("an impact has no value of " + metric_name(metric));
  const Distribution repeats = repeated_peaks(definition, n);
  return peak ? repeats.percentile(peak->pressure) / 100 : not_a_number;
}

}  // namespace slosh
