// The findings on waves: their growth, against linear theory, between runs, and of their spectrum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/papers/claims.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// "li2010_20mm of li2010_large_b125".
std::string place(const Question& on) {
  return name_of_members(on.first, on.run(0)) + " of " + on.definition().name;
}

// Returns the comparison of the first run with theory, the second one, at the first gauge. Throws
// where there is none that counts.
const Comparison& against_theory(const Question& on) {
  on.result(0), on.result(1);
  if (on.first.runs.status.at(on.run(1)).state == RunState::out_of_range)
    throw std::runtime_error(on.run(1) + " of " + on.definition().name + ": out of range");
  const std::string quantity = at_first_gauge(on.definition(), "elevation");
  for (const Comparison& one : on.first.comparisons)
    if (one.candidate == on.run(0) && one.reference == on.run(1) && one.quantity == quantity)
      return one;
  throw std::runtime_error(on.run(0) + " could not be compared with " + on.run(1));
}

Finding mode_error(const Question& on, Estimate ModeComparison::*error) {
  const Comparison& comparison = against_theory(on);
  for (const ModeComparison& mode : comparison.modes) {
    if (mode.mode != on.row.quantity) continue;
    if (mode.resolved()) return on.judge("{0}: " + on.row.name, 100, "%", mode.*error);
    throw std::runtime_error(
        fmt::format("{} of {} cannot be resolved", mode.mode, comparison.candidate));
  }
  throw std::runtime_error(on.row.quantity + " was not fitted");
}

// The error of the fitted mode `quantity`, the first run against theory. Threshold: range of the
// relative error.
Finding frequency_against_theory(const Question& on) {
  return mode_error(on, &ModeComparison::frequency_error);
}
Finding amplitude_against_theory(const Question& on) {
  return mode_error(on, &ModeComparison::amplitude_error);
}

// Skewness of the elevation of theory, the second run, minus that of the first, at the first gauge.
// Threshold: that of the difference.
Finding flattened_crests(const Question& on) {
  against_theory(on);
  const std::string quantity = at_first_gauge(on.definition(), "elevation");
  const auto skewness_of = [&](std::size_t i) {
    return skewness(on.result(i).at(quantity), comparison_window(on.definition()));
  };
  const double ours = skewness_of(0);
  Finding finding = on.judge("{0}: skewness of theory's elevation less its own", 1, "",
                             {skewness_of(1) - ours, 0});
  finding.text += fmt::format(", which is {:+.3f}", ours);
  return finding;
}

// Judges a ratio by both readings, and leaves it open where they disagree.
template <class Ratio>
Finding judged_ratio(const Question& on, const std::string& of, const Ratio& ratio) {
  const auto by = [&](double Readings::*which, const std::string& reading) {
    return judged({fmt::format("{}: {}{}", of, on.row.name, reading), 1, ""}, ratio(which),
                  on.threshold());
  };
  if (on.row.measures.front().quantity != "momentum") return by(&Readings::small, "");
  const Finding small = by(&Readings::small, " by |P|"),
                large = by(&Readings::large, " by sqrt(2 M K)");
  return {small.held == large.held ? small.held : Held::undecided, small.text + "; " + large.text};
}

// The first measure of the first run in the last case over the last measure of the last run in the
// first case: the growth from a first case to a second, the ratio of a first run to a second, or of
// two measures of one run. Geometric means over ensembles, with their interval. Threshold: that of
// the ratio over the printed one.
Finding ratio(const Question& on) {
  const FindingRow& row = on.row;
  const auto over = measured(on.first, row.runs.back(), row.measures.back());
  const auto of = measured(on.last, row.runs.front(), row.measures.front());
  const std::string names = name_of_members(on.last, row.runs.front()) +
                            (row.runs.size() < 2 ? "" : " over ") +
                            (row.runs.size() < 2 ? "" : name_of_members(on.first, row.runs.back()));
  if (row.by_repeats && std::min(of.size(), over.size()) < 2)
    return {Held::undecided, fmt::format("{}: {} needs repeats of both, as each history is chaotic",
                                         names, row.name)};
  return judged_ratio(on, names, [&](double Readings::*which) {
    const Estimate found =
        ratio_of_members(numbers(of, which), numbers(over, which), SingleSide::one_of_many);
    return Estimate{found.value / row.printed, found.half_width / row.printed};
  });
}

// The measure of the first run over the printed number. Threshold: that of the quotient.
Finding against_printed(const Question& on) {
  const auto of = measured(on.first, on.run(0), on.row.measures.front());
  return judged_ratio(on, place(on), [&](double Readings::*which) {
    return ratio_of_members(numbers(of, which), {on.row.printed});
  });
}

// The lag of the elevation's forced tone at the first gauge, the first run behind the second [deg].
// Threshold: range of the lag.
Finding lag_of_runs(const Question& on) {
  const CaseDefinition& definition = on.definition();
  const std::string quantity = at_first_gauge(definition, "elevation");
  std::vector<std::vector<Estimate>> pairs;
  for (const std::string& one : members_of(definition, on.run(0))) {
    pairs.emplace_back();
    for (const std::string& other : members_of(definition, on.run(1)))
      pairs.back().push_back(tone_difference(standing_result(on.first, one).at(quantity),
                                             standing_result(on.first, other).at(quantity),
                                             comparison_window(definition),
                                             forcing_frequency(definition))
                                 .lag_degrees);
  }
  const bool is_single = pairs.size() == 1 && pairs.front().size() == 1;
  return judged(
      {fmt::format("{}: lag behind {}", place(on), name_of_members(on.first, on.run(1))), 1, "deg"},
      is_single ? pairs.front().front() : ensemble_mean(pairs, SingleSide::one_of_many),
      on.threshold());
}

// Thresholds: the highest elevation at the first gauge over the depth; how far the highest wet
// point lies above the liquid's own depth there, over the depth, as under a jet or a drop; the
// largest speed over sqrt(g depth), of SPH.
Finding violent_motion(const Question& on) {
  const CaseDefinition& definition = on.definition();
  const double depth = definition.liquid.fill_depth;
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  std::vector<double> heights, jets, speeds;
  for (const std::string& member : members_of(definition, on.run(0))) {
    const RunResult& result = standing_result(on.first, member);
    const auto in_window = [&](const std::string& name) {
      return cut_to_window(result.at(name), comparison_window(definition));
    };
    const CommonSamples surface =
        common_samples(in_window(at_first_gauge(definition, "highest_surface")),
                       in_window(at_first_gauge(definition, "elevation")));
    heights.push_back(largest(surface.reference) / depth);
    jets.push_back(largest(minus(surface.candidate, surface.reference)) / depth);
    speeds.push_back(largest(in_window("mach_number").value) *
                     diagnostic_of(on.first, member, "speed_of_sound_m_s") /
                     std::sqrt(definition.gravity * depth));
  }
  const auto part = [&](const char* name, const std::vector<double>& values, std::size_t i) {
    return judged({name, 1, ""}, mean_of_members(values), on.threshold(i));
  };
  const Finding parts[]{
      part("highest elevation over the depth", heights, 0),
      part("highest wet point above the liquid's own depth there, over the depth,", jets, 1),
      part("largest speed over sqrt(g depth)", speeds, 2)};
  return {both(parts[0].held, both(parts[1].held, parts[2].held)),
          fmt::format("{}: {}, {}, {}", place(on), parts[0].text, parts[1].text, parts[2].text)};
}

// A missing peak, of NaN, speaks against two peaks.
bool is_at_multiples(const SurfaceSpectrum& spectrum, const Threshold& range) {
  const auto at = [&](std::size_t k) {
    const double expected = static_cast<double>(k + 1) * spectrum.excitation;
    return compare(spectrum.peak[k].frequency / expected - 1, range) == Held::yes;
  };
  return spectrum.highest && at(0) && at(1);
}

// The two highest peaks of the spectrum of the highest surface lie at the excitation and at twice
// it: confirmed where all members have them there, refuted where none has. Threshold: range of the
// relative difference in frequency.
Finding peaks_at_multiples(const Question& on) {
  const auto members = members_of(on.definition(), on.run(0));
  double excitation = 0;
  std::size_t count = 0;
  for (const std::string& member : members) {
    const SurfaceSpectrum spectrum = surface_spectrum(on.first, member);
    excitation = spectrum.excitation;
    count += is_at_multiples(spectrum, on.threshold());
  }
  const auto frequency = [&](Measure measure) {
    return frequency_text(numbers(measured(on.first, on.run(0), {"", measure})));
  };
  return {count == members.size() ? Held::yes
          : count > 0             ? Held::undecided
                                  : Held::no,
          fmt::format("{}: peaks [Hz] at {} and {} (in {} of {} these are the two highest and "
                      "within {:.2g} % of {:.3f} and {:.3f})",
                      place(on), frequency(Measure::first_frequency),
                      frequency(Measure::second_frequency), count, members.size(),
                      100 * on.threshold().upper, excitation, 2 * excitation)};
}

}  // namespace

const std::map<std::string, Evidence>& wave_findings() {
  static const std::map<std::string, Evidence> all{
      {"ratio", ratio},
      {"against_printed", against_printed},
      {"frequency_against_theory", frequency_against_theory},
      {"amplitude_against_theory", amplitude_against_theory},
      {"flattened_crests", flattened_crests},
      {"lag_of_runs", lag_of_runs},
      {"violent_motion", violent_motion},
      {"peaks_at_multiples", peaks_at_multiples}};
  return all;
}

}  // namespace slosh
