#include "verification/gate/impact_metrics.hpp"

#include <fmt/format.h>

#include "verification/case/quantities.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

const ImpactsDefinition& published(const CaseDefinition& definition) {
  if (definition.impacts) return *definition.impacts;
  throw ComparisonError("the case " + definition.name + " has no [impacts]");
}

const ArrivalsDefinition& arrivals_of(const ImpactsDefinition& impacts) {
  if (impacts.arrivals) return *impacts.arrivals;
  throw ComparisonError("the case's [impacts] has no arrival_share and arrivals_s");
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
  if (!(impacts.plateau > 0)) throw ComparisonError("the case's [impacts] publishes no plateau");
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
  if (!is_filtered(pressure.name)) return published(definition).times[n];
  if (!record)
    throw NotSuppliedError(
        "the published times are those of the unfiltered pressure, and the record, which would be "
        "filtered alike, is not supplied");
  const std::optional<ImpactPeak> peak = impacts_in(*record, definition).at(n);
  if (!peak) throw not_in_record(*record, n, definition);
  return peak->time;
}

std::optional<double> arrival_in(const TimeSeries& pressure, std::size_t n,
                                 const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = published(definition);
  return arrival_time(pressure, impact_windows(impacts.times, impacts.period).at(n),
                      arrivals_of(impacts).share * impacts.peak_means.at(n));
}

std::optional<double> impulse_in(const TimeSeries& pressure, std::size_t n,
                                 const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = published(definition);
  if (!impacts.impulses)
    throw ComparisonError("the case's [impacts] has no impulse_duration_s and impulses_Pa_s");
  const std::optional<double> arrival = arrival_in(pressure, n, definition);
  if (!arrival) return std::nullopt;
  return impulse(pressure, {*arrival, *arrival + impacts.impulses->duration});
}

std::vector<ImpactNumbers> impact_numbers(const TimeSeries& pressure,
                                          const CaseDefinition& definition) {
  const ImpactsDefinition& impacts = published(definition);
  std::vector<ImpactNumbers> all;
  for (const std::optional<ImpactPeak>& peak : impacts_in(pressure, definition)) {
    ImpactNumbers one{.peak = peak};
    const std::size_t n = all.size();
    if (peak) one.rise_time = rise_time(pressure, *peak);
    if (impacts.arrivals) one.arrival = arrival_in(pressure, n, definition);
    if (impacts.impulses) one.impulse = impulse_in(pressure, n, definition);
    all.push_back(one);
  }
  return all;
}

std::size_t impact_number(const std::string& mode, const CaseDefinition& definition) {
  for (std::size_t n = 0; n < published(definition).times.size(); ++n)
    if (mode == fmt::format("impact_{}", n + 1)) return n;
  throw ComparisonError("the case has no " + mode);
}

std::optional<ImpactPeak> peak_in(const TimeSeries& pressure, std::size_t n,
                                  const TimeSeries* record, const CaseDefinition& definition) {
  const std::optional<ImpactPeak> peak = impacts_in(pressure, definition).at(n);
  if (!peak && record && lacks_impact(*record, n, definition))
    throw not_in_record(*record, n, definition);
  return peak;
}

double impact_metric(Metric metric, const std::string& mode, const TimeSeries& pressure,
                     const TimeSeries* record, const CaseDefinition& definition) {
  if (metric == Metric::plateau_error) return plateau_error(pressure, definition);
  const ImpactsDefinition& impacts = published(definition);
  const std::size_t n = impact_number(mode, definition);
  const std::optional<ImpactPeak> peak = peak_in(pressure, n, record, definition);
  switch (metric) {
    case Metric::impact_arrival:
      return arrival_in(pressure, n, definition).value_or(not_a_number) -
             arrivals_of(impacts).times.at(n);
    case Metric::impact_peak_error:
      return peak ? peak->pressure / impacts.peak_means.at(n) - 1 : not_a_number;
    case Metric::impulse_error: {
      const std::optional<double> found = impulse_in(pressure, n, definition);
      return found ? *found / impacts.impulses->values.at(n) - 1 : not_a_number;
    }
    default:
      throw std::logic_error("an impact has no value of " + metric_name(metric));
  }
}

}  // namespace slosh
