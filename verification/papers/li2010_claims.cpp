#include "verification/papers/li2010_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/claim_thresholds.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/estimate.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

namespace limit = claim_thresholds;

using Cases = std::vector<CaseAssessment>;

const std::string papers_run = "li2010_20mm";
const std::string small_case = "li2010_small_amplitude";
constexpr std::array<const char*, 2> large_cases{"li2010_large_b075", "li2010_large_b125"};

// With linear theory at the first gauge. Throws where there is none that counts.
const Comparison& against_theory(const CaseAssessment& assessment) {
  standing_result(assessment, papers_run);
  standing_result(assessment, "linear");
  if (assessment.runs.status.at("linear").state == RunState::out_of_range)
    throw std::runtime_error("linear of " + assessment.definition.name + ": out of range");
  const std::string quantity = at_first_gauge(assessment.definition, "elevation");
  for (const Comparison& one : assessment.comparisons)
    if (one.candidate == papers_run && one.reference == "linear" && one.quantity == quantity)
      return one;
  throw std::runtime_error(papers_run + " could not be compared with linear");
}

const ModeComparison& mode_named(const Comparison& comparison, const std::string& name) {
  for (const ModeComparison& mode : comparison.modes)
    if (mode.mode == name) {
      if (mode.resolved()) return mode;
      throw std::runtime_error(
          fmt::format("{} of {} cannot be told from the rest", name, comparison.candidate));
    }
  throw std::runtime_error(name + " was not fitted");
}

Finding same_period(const Cases& cases) {
  const Comparison& comparison = against_theory(case_named(cases, small_case));
  return within({papers_run + ": first natural frequency against theory", 100, "%"},
                mode_named(comparison, "natural_1").frequency_error, -limit::same_period,
                limit::same_period);
}

Finding slightly_below(const Cases& cases) {
  const Comparison& comparison = against_theory(case_named(cases, small_case));
  return within({papers_run + ": forced amplitude against theory", 100, "%"},
                mode_named(comparison, "forced").amplitude_error, -limit::slightly_below, 0);
}

Finding flattened_crests(const Cases& cases) {
  const CaseAssessment& assessment = case_named(cases, small_case);
  against_theory(assessment);
  const std::string quantity = at_first_gauge(assessment.definition, "elevation");
  const TimeWindow window = comparison_window(assessment.definition);
  const double ours = skewness(standing_result(assessment, papers_run).at(quantity), window);
  const double theory = skewness(standing_result(assessment, "linear").at(quantity), window);
  return {at_least(theory - ours, 0, -limit::flattened_skewness),
          fmt::format("{}: skewness of the elevation {:+.3f} against theory's {:+.3f} (at least "
                      "{:.2g} less)",
                      papers_run, ours, theory, -limit::flattened_skewness)};
}

// The finest interFoam that the case declares, be there a result of it or not.
std::vector<std::string> deciding_runs(const CaseAssessment& assessment) {
  std::vector<std::string> runs{papers_run};
  int most_cells = 0;
  for (const RunDefinition& run : assessment.definition.runs) {
    const InterFoamRun* mesh = std::get_if<InterFoamRun>(&run.solver);
    if (!mesh || mesh->cells_x * mesh->cells_z <= most_cells) continue;
    most_cells = mesh->cells_x * mesh->cells_z;
    runs.resize(1);
    runs.push_back(run.name);
  }
  return runs;
}

Held both(Held one, Held other) {
  if (one == Held::no || other == Held::no) return Held::no;
  return one == Held::yes && other == Held::yes ? Held::yes : Held::undecided;
}

Finding violent(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  const TimeSeries elevation =
      cut_to_window(standing_result(assessment, run).at(at_first_gauge(definition, "elevation")),
                    comparison_window(definition));
  const auto [lowest, highest] =
      std::minmax_element(elevation.value.begin(), elevation.value.end());
  const double over_depth = *highest / definition.liquid.fill_depth;
  // A surface that never falls has no trough to compare with.
  const double ratio = *lowest < 0 ? *highest / -*lowest : not_a_number;
  return {
      both(at_least(over_depth, limit::violent_elevation_over_depth,
                    limit::violent_elevation_over_depth),
           at_least(ratio, 1, limit::crest_over_trough)),
      fmt::format("{} of {}: highest elevation {:.2f} depths (at least {:.2g}), {:.2f} times as "
                  "high as the lowest is deep (at least {:.3g})",
                  run, definition.name, over_depth, limit::violent_elevation_over_depth, ratio,
                  limit::crest_over_trough)};
}

struct BothSpectra {
  SurfaceSpectrum smaller, larger;

  double growth(std::size_t k) const { return larger.peak[k].power / smaller.peak[k].power; }
};

BothSpectra spectra(const Cases& cases, const std::string& run) {
  return {surface_spectrum(case_named(cases, large_cases[0]), run),
          surface_spectrum(case_named(cases, large_cases[1]), run)};
}

// A peak that is not there speaks against two peaks: NaN does not hold.
bool at_multiples(const SurfaceSpectrum& spectrum) {
  const auto at = [&](std::size_t k) {
    const double expected = static_cast<double>(k + 1) * spectrum.excitation;
    return std::abs(spectrum.peak[k].frequency / expected - 1) <= limit::peak_frequency;
  };
  return spectrum.highest && at(0) && at(1);
}

Finding two_peaks(const Cases& cases, const std::string& run) {
  const BothSpectra found = spectra(cases, run);
  const bool placed = at_multiples(found.smaller) && at_multiples(found.larger);
  const auto text = [](const SurfaceSpectrum& one) {
    return fmt::format("{:.3f} and {:.3f} Hz{}", one.peak[0].frequency, one.peak[1].frequency,
                       one.highest ? "" : " (not the two highest)");
  };
  const Held grown = both(at_least(found.growth(0), 1, limit::growth),
                          at_least(found.growth(1), 1, limit::growth));
  return {placed ? grown : Held::no,
          fmt::format("{}: peaks at {}, then {} (within {:.2g} % of {:.3f} and {:.3f} Hz); powers "
                      "grow {:.3g} and {:.3g} times (at least {})",
                      run, text(found.smaller), text(found.larger), 100 * limit::peak_frequency,
                      found.smaller.excitation, 2 * found.smaller.excitation, found.growth(0),
                      found.growth(1), limit::growth)};
}

constexpr double printed_ratio_smaller = 2.00, printed_ratio_larger = 4.915;

Held near_printed(double ratio, double printed) {
  const double factor = std::max(ratio / printed, printed / ratio);
  if (std::isnan(factor)) return Held::undecided;
  return factor <= limit::printed_ratio_factor ? Held::yes : Held::no;
}

Finding faster_growth(const Cases& cases, const std::string& run) {
  const BothSpectra found = spectra(cases, run);
  const double smaller = found.smaller.ratio(), larger = found.larger.ratio();
  return {both(at_least(larger / smaller, 1, limit::growth),
               both(near_printed(smaller, printed_ratio_smaller),
                    near_printed(larger, printed_ratio_larger))),
          fmt::format("{}: first over second from {:.3g} to {:.3g} (printed: {:.2f} to {:.3f}; met "
                      "within a factor of {})",
                      run, smaller, larger, printed_ratio_smaller, printed_ratio_larger,
                      limit::printed_ratio_factor)};
}

// The finding of each deciding run; of a case that is absent its absence.
template <class FindOfRun>
std::vector<Find> for_deciding_runs(const Cases& cases, const char* large_case,
                                    const FindOfRun& find) {
  const CaseAssessment* found = find_case(cases, large_case);
  std::vector<Find> findings;
  const auto runs = found ? deciding_runs(*found) : std::vector<std::string>{papers_run};
  for (const std::string& run : runs) findings.push_back([=] { return find(run); });
  return findings;
}

}  // namespace

std::vector<Claim> li2010_claims(const Cases& cases) {
  const Cases* all = &cases;
  Claim violent_motion{
      "Near resonance and at large amplitude the motion is violent and nonlinear: crests far above "
      "linear theory's validity, higher than the troughs are deep.",
      {}};
  for (const char* name : large_cases)
    for (Find& find : for_deciding_runs(cases, name, [=](const std::string& run) {
           return violent(case_named(*all, name), run);
         }))
      violent_motion.findings.push_back(std::move(find));
  return {{"SPH with repulsive and mirror particles follows linear theory at small amplitude: the "
           "same period, the amplitude slightly below theory, crests flattened.",
           {[=] { return same_period(*all); }, [=] { return slightly_below(*all); },
            [=] { return flattened_crests(*all); }}},
          violent_motion,
          {"The spectrum of the highest surface elevation at x = 0.95 m has two peaks, at the "
           "excitation (0.77 Hz) and at twice it (1.54 Hz), and both grow with the amplitude.",
           for_deciding_runs(cases, large_cases[0],
                             [=](const std::string& run) { return two_peaks(*all, run); })},
          {"The power grows faster at the first peak: from b = 0.075 to 0.125 m the ratio of the "
           "first to the second grows from 2.00 to 4.915.",
           for_deciding_runs(cases, large_cases[0],
                             [=](const std::string& run) { return faster_growth(*all, run); })}};
}

}  // namespace slosh
