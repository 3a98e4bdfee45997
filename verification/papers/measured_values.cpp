#include "verification/papers/measured_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/low_pass_filter.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Values = std::vector<double>;

TimeWindow window_of(Stage stage, const CaseDefinition& definition) {
  const TimeWindow steady = comparison_window(definition);
  if (stage == Stage::first) return {0, steady.begin};
  if (stage == Stage::late) return {(steady.begin + steady.end) / 2, steady.end};
  return steady;
}

// The mean of a number of the values of each whole period of the forcing.
template <class Number>
double mean_over_periods(const TimeSeries& cut, const CaseDefinition& definition,
                         const Number& number) {
  const double period = 2 * std::numbers::pi / forcing_frequency(definition);
  Values found;
  auto from = cut.time.begin();
  for (double end = cut.time.front() + period; end <= cut.time.back(); end += period) {
    const auto to = std::lower_bound(from, cut.time.end(), end);
    const auto value = [&](auto at) { return cut.value.begin() + (at - cut.time.begin()); };
    if (from != to) found.push_back(number(Values(value(from), value(to))));
    from = to;
  }
  if (found.empty()) throw std::runtime_error(cut.name + " covers no period of the forcing");
  return mean(found);
}

double noise_of(const TimeSeries& series, const TimeSeries& cut, const CaseDefinition& definition,
                TimeWindow window) {
  const TimeSeries smooth = low_pass(series, filtered_gauge(definition).second);
  return rms(minus(cut.value, cut_to_window(smooth, window).value));
}

double value_of(const TimeSeries& series, const Measured& what, const CaseDefinition& definition) {
  const TimeWindow window = window_of(what.stage, definition);
  const TimeSeries cut = cut_to_window(series, window);
  const auto highest = [](const Values& values) {
    return *std::max_element(values.begin(), values.end());
  };
  const auto lowest = [](const Values& values) {
    return *std::min_element(values.begin(), values.end());
  };
  const auto variance = [](const Values& values) { return std::pow(rms(without_mean(values)), 2); };
  switch (what.measure) {
    case Measure::mean:
      return mean(cut.value);
    case Measure::fluctuation:
      return std::sqrt(mean_over_periods(cut, definition, variance));
    case Measure::crest:
      return mean_over_periods(cut, definition, highest);
    case Measure::trough:
      return std::abs(mean_over_periods(cut, definition, lowest));
    case Measure::largest:
      return highest(cut.value);
    case Measure::noise:
      return noise_of(series, cut, definition, window);
    case Measure::main_frequency: {
      const auto peaks = spectral_peaks(power_spectrum(series, window), 1);
      return peaks.empty() ? not_a_number : peaks.front().frequency;
    }
    default:
      throw std::logic_error("the measure is not one of a series");
  }
}

double value_of(const SurfaceSpectrum& spectrum, Measure measure) {
  switch (measure) {
    case Measure::first_frequency:
      return spectrum.peak[0].frequency;
    case Measure::second_frequency:
      return spectrum.peak[1].frequency;
    case Measure::first_power:
      return spectrum.peak[0].power;
    case Measure::second_power:
      return spectrum.peak[1].power;
    default:
      return spectrum.ratio();
  }
}

double distance_of_impacts(const CaseAssessment& assessment, const std::string& run,
                           Measure measure) {
  const CaseDefinition& definition = assessment.definition;
  if (!definition.impacts)
    throw std::runtime_error("the case " + definition.name + " has no [impacts]");
  const ImpactsDefinition& published = *definition.impacts;
  const auto peaks =
      impacts_in(standing_result(assessment, run).at(wall_pressure(published.gauge)), definition);
  Values distances;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    if (!peaks[n]) return not_a_number;
    distances.push_back(measure == Measure::peak_distance
                            ? std::abs(std::log(peaks[n]->pressure / published.peak_means[n]))
                            : std::abs(peaks[n]->time - published.times[n]) / published.period);
  }
  return mean(distances);
}

std::string series_of(const std::string& quantity, const CaseDefinition& definition) {
  if (quantity == "elevation" || quantity == "highest_surface")
    return at_first_gauge(definition, quantity);
  return quantity == "wall_pressure" ? filtered_gauge(definition).first : quantity;
}

Readings of_member(const CaseAssessment& assessment, const std::string& run, const Measured& what) {
  if (what.stage == Stage::first_over_steady) {
    const auto in = [&](Stage stage) {
      return of_member(assessment, run, {what.quantity, what.measure, stage});
    };
    const Readings first = in(Stage::first), steady = in(Stage::steady);
    return {first.small / steady.small, first.large / steady.large};
  }
  if (what.measure >= Measure::peak_distance) {
    const double distance = distance_of_impacts(assessment, run, what.measure);
    return {distance, distance};
  }
  if (what.measure >= Measure::first_frequency) {
    const double value = value_of(surface_spectrum(assessment, run), what.measure);
    return {value, value};
  }
  const CaseDefinition& definition = assessment.definition;
  const RunResult& result = standing_result(assessment, run);
  if (what.quantity != "momentum") {
    const double value =
        value_of(result.at(series_of(what.quantity, definition)), what, definition);
    return {value, value};
  }
  const auto [small, large] = momentum_magnitudes(result, definition);
  return {value_of(small, what, definition), value_of(large, what, definition)};
}

}  // namespace

std::pair<TimeSeries, TimeSeries> momentum_magnitudes(const RunResult& result,
                                                      const CaseDefinition& definition) {
  const TimeSeries &x = result.at("momentum_x"), &z = result.at("momentum_z"),
                   &energy = result.at("kinetic_energy");
  if (x.time != z.time || x.time != energy.time)
    throw std::runtime_error(result.run_name + ": momentum and energy have different times");
  const double mass =
      definition.liquid.density * definition.tank.length * definition.liquid.fill_depth;
  TimeSeries small{"|P|", x.unit, x.time, {}}, large{"sqrt(2 M K)", x.unit, x.time, {}};
  for (std::size_t i = 0; i < x.time.size(); ++i) {
    small.value.push_back(std::hypot(x.value[i], z.value[i]));
    large.value.push_back(std::sqrt(2 * mass * energy.value[i]));
  }
  return {small, large};
}

std::vector<Readings> measured(const CaseAssessment& assessment, const std::string& run,
                               const Measured& what) {
  std::vector<Readings> members;
  for (const std::string& member : members_of(assessment.definition, run))
    members.push_back(of_member(assessment, member, what));
  return members;
}

}  // namespace slosh
