#include "verification/papers/zhao2021_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reports/tables/impact_table.hpp"
#include "verification/assessment/pressure_noise.hpp"
#include "verification/case/motion.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/claim_thresholds.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

namespace limit = claim_thresholds;

using Cases = std::vector<CaseAssessment>;

const std::string mild = "zhao2021_mild_roll", violent = "zhao2021_violent_roll";
const std::string record_of_mild = "akyildiz";
const std::array<std::string, 2> ways{"moving", "fixed"};
const std::string papers_spacing_run = "fixed_2mm";
// The paper's studies of spacing and of time step; each run in both ways.
const std::array<std::string, 5> studies{"8mm", "4mm", "2mm", "4mm_cfl01", "4mm_cfl04"};

// The series that a record is of, filtered where the run has it so: the record is smooth.
const TimeSeries& like_the_record(const RunResult& result, const std::string& quantity) {
  for (const TimeSeries& series : result.series)
    if (series.name == quantity + "/filtered") return series;
  return result.at(quantity);
}

struct RecordedPressure {
  const CaseAssessment& assessment;
  const TimeSeries& record;
  const TimeSeries& run;
  TimeWindow window;  // what the record covers of the comparison's
};

RecordedPressure recorded_pressure(const Cases& cases, const std::string& run) {
  const CaseAssessment& assessment = case_named(cases, mild);
  const RunResult& measured = standing_result(assessment, record_of_mild);
  const auto& definition =
      std::get<RecordRun>(run_named(assessment.definition, record_of_mild).solver);
  TimeWindow window = comparison_window(assessment.definition);
  const TimeSeries& record = measured.at(definition.quantity);
  window.begin = std::max(window.begin, record.time.front());
  window.end = std::min(window.end, record.time.back());
  return {assessment, record,
          like_the_record(standing_result(assessment, run), definition.quantity), window};
}

Finding agrees_in_phase(const Cases& cases, const std::string& run) {
  const RecordedPressure found = recorded_pressure(cases, run);
  const ToneDifference tone = tone_difference(found.run, found.record, found.window,
                                              forcing_frequency(found.assessment.definition));
  Finding finding = within({run + ": lag behind the record", 1, "deg"}, tone.lag_degrees,
                           -limit::agreeing_lag_degrees, limit::agreeing_lag_degrees);
  finding.text += fmt::format(", {:.2f} ± {:.2f} times its amplitude", tone.amplitude_ratio.value,
                              tone.amplitude_ratio.half_width);
  return finding;
}

Finding agrees_in_shape(const Cases& cases, const std::string& run) {
  const RecordedPressure found = recorded_pressure(cases, run);
  const HistoryDifference apart = difference(found.run, found.record, found.window);
  Finding finding =
      within({run + ": rms difference to the record, both freed of their means,", 100, "%"},
             {apart.without_means, 0}, 0, limit::agreeing_shape);
  finding.text += fmt::format(", {:.0f} % as they are: the record lies {:+.0f} Pa off",
                              100 * apart.as_it_is, apart.offset);
  return finding;
}

// Through the filter of the case's pressure gauge, whatever the series.
TimeSeries filtered(const RunResult& result, const std::string& quantity, double cutoff) {
  return quantity.ends_with("/filtered") ? result.at(quantity)
                                         : low_pass(result.at(quantity), cutoff);
}

enum class Load { pressure, force, moment };

Finding same_in_both_ways(const Cases& cases, Load load) {
  const CaseAssessment& assessment = case_named(cases, mild);
  const std::string moving_run = "moving_5mm", fixed_run = "fixed_5mm";
  const RunResult& moving = standing_result(assessment, moving_run);
  const RunResult& fixed = standing_result(assessment, fixed_run);
  const auto [pressure, cutoff] = filtered_gauge(assessment.definition);
  const std::string quantity = load == Load::pressure ? pressure
                               : load == Load::force  ? "force_x"
                                                      : "moment";
  const HistoryDifference apart =
      difference(filtered(moving, quantity, cutoff), filtered(fixed, quantity, cutoff),
                 comparison_window(assessment.definition));
  return within({fmt::format("moving_5mm against fixed_5mm: rms difference of {}",
                             load == Load::pressure ? quantity : quantity + "/filtered"),
                 100, "%"},
                {apart.as_it_is, 0}, 0, limit::same_history);
}

const TimeSeries& violent_pressure(const Cases& cases, const std::string& run) {
  const CaseAssessment& assessment = case_named(cases, violent);
  const RunResult& result = standing_result(assessment, run);
  if (!assessment.definition.impacts)
    throw std::runtime_error("the case " + violent + " says nothing of impacts");
  return result.at("wall_pressure@" + assessment.definition.impacts->gauge);
}

Finding impacts_in_time(const Cases& cases) {
  const TimeSeries& pressure = violent_pressure(cases, papers_spacing_run);
  const CaseDefinition& definition = case_named(cases, violent).definition;
  const ImpactsDefinition& published = *definition.impacts;
  const auto peaks = impacts_in(pressure, definition);
  const double allowed = limit::impact_time_over_period * published.period;
  std::vector<std::string> texts;
  bool all = true;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    const double late = peaks[n] ? peaks[n]->time - published.times[n] : NAN;
    texts.push_back(peaks[n] ? fmt::format("{:+.3f}", late) : "none");
    all = all && std::abs(late) <= allowed;
  }
  return {all ? Held::yes : Held::no,
          fmt::format("{}: impacts late by {} s (at most {:.3f})", papers_spacing_run,
                      fmt::join(texts, ", "), allowed)};
}

Finding plateau_agrees(const Cases& cases) {
  const TimeSeries& pressure = violent_pressure(cases, papers_spacing_run);
  return within({papers_spacing_run + ": plateau against the published one", 100, "%"},
                {plateau_error(pressure, case_named(cases, violent).definition), 0},
                -limit::agreeing_plateau, limit::agreeing_plateau);
}

bool among_repeats(const CaseDefinition& definition, std::size_t impact, double peak) {
  const ImpactsDefinition& published = *definition.impacts;
  if (published.repeats.empty())
    return std::abs(peak - published.peak_means[impact]) <=
           limit::repeats_deviations * published.peak_deviations[impact];
  const double percentile = repeated_peaks(definition, impact).percentile(peak);
  return percentile >= limit::repeats_low && percentile <= limit::repeats_high;
}

Finding peaks_among_repeats(const Cases& cases) {
  const TimeSeries& pressure = violent_pressure(cases, papers_spacing_run);
  const CaseDefinition& definition = case_named(cases, violent).definition;
  const auto peaks = impacts_in(pressure, definition);
  std::vector<std::string> texts;
  int missed = 0;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    texts.push_back(peaks[n] ? place_among_repeats(definition, n, peaks[n]->pressure) : "none");
    missed += !(peaks[n] && among_repeats(definition, n, peaks[n]->pressure));
  }
  return {missed <= limit::peaks_that_may_miss ? Held::yes : Held::no,
          fmt::format("{}: peaks at {} of the repeats ({} to {} % or within {} sd; all but {})",
                      papers_spacing_run, fmt::join(texts, ", "), limit::repeats_low,
                      limit::repeats_high, limit::repeats_deviations, limit::peaks_that_may_miss)};
}

// Whether a run of a study finished. Throws where it was not tried.
bool finished(const CaseAssessment& assessment, const std::string& run) {
  const auto status = assessment.runs.status.find(run);
  if (status != assessment.runs.status.end() && status->second.state == RunState::failed)
    return false;
  standing_result(assessment, run);
  return true;
}

double crossings(const CaseAssessment& assessment, const std::string& run) {
  const RunResult& result = standing_result(assessment, run);
  const auto found = result.diagnostics.find("wall_crossings");
  if (found == result.diagnostics.end() || !std::isfinite(found->second))
    throw std::runtime_error(run + " of " + violent + " counted no wall crossings");
  return found->second;
}

struct StabilityOfWays {
  std::array<int, 2> finished{};
  std::array<double, 2> log_noise{}, crossings{};  // over the runs that finished both ways
  int pairs = 0;
};

StabilityOfWays stability(const Cases& cases) {
  const CaseAssessment& assessment = case_named(cases, violent);
  StabilityOfWays found;
  for (const std::string& study : studies) {
    std::array<bool, 2> done{};
    for (const std::size_t w : {0u, 1u}) {
      done[w] = finished(assessment, ways[w] + "_" + study);
      found.finished[w] += done[w];
    }
    if (!done[0] || !done[1]) continue;
    ++found.pairs;
    for (const std::size_t w : {0u, 1u}) {
      const std::string run = ways[w] + "_" + study;
      found.log_noise[w] +=
          std::log(plateau_noise(violent_pressure(cases, run), assessment.definition));
      found.crossings[w] += crossings(assessment, run);
    }
  }
  return found;
}

// Better, worse, or alike: undecided.
Held clearly_smaller(double ours, double others) {
  if (ours <= limit::clearly_smaller * others && ours < others) return Held::yes;
  return others <= limit::clearly_smaller * ours && others < ours ? Held::no : Held::undecided;
}

// What one way has over the other: better in something and worse in nothing.
Finding fixed_is_more_stable(const Cases& cases) {
  const StabilityOfWays found = stability(cases);
  const double noise =
      found.pairs ? std::exp((found.log_noise[1] - found.log_noise[0]) / found.pairs) : NAN;
  const auto count = [&](std::size_t w) {
    return static_cast<int>(studies.size()) - found.finished[w];
  };
  std::vector<Held> parts{count(1) < count(0)   ? Held::yes
                          : count(1) > count(0) ? Held::no
                                                : Held::undecided,
                          clearly_smaller(noise, 1),
                          clearly_smaller(found.crossings[1], found.crossings[0])};
  const bool better = std::count(parts.begin(), parts.end(), Held::yes) > 0;
  const bool worse = std::count(parts.begin(), parts.end(), Held::no) > 0;
  std::string text = fmt::format(
      "of {} runs each {} of the fixed and {} of the moving finished; over the {} that both "
      "finished the fixed have {:.3g} times the noise of the moving on the plateaus and {:.0f} "
      "wall "
      "crossings against {:.0f} (better in one, worse in none; a fifth counts)",
      studies.size(), found.finished[1], found.finished[0], found.pairs, noise, found.crossings[1],
      found.crossings[0]);
  if (better && worse) text += ": they contradict one another";
  if (!better && !worse) text += ": nothing tells the two apart";
  return {better == worse ? Held::undecided : better ? Held::yes : Held::no, text};
}

// The mean rms difference of a way's runs to its finest.
double spread(const CaseAssessment& assessment, const std::string& way,
              const std::vector<std::string>& coarser, const std::string& finest) {
  const std::string quantity = filtered_gauge(assessment.definition).first;
  const std::string finest_run = way + "_" + finest;
  const TimeSeries& best = standing_result(assessment, finest_run).at(quantity);
  double sum = 0;
  for (const std::string& one : coarser)
    sum += difference(standing_result(assessment, way + "_" + one).at(quantity), best,
                      comparison_window(assessment.definition))
               .as_it_is;
  return sum / static_cast<double>(coarser.size());
}

Finding converges_better(const Cases& cases, const char* study,
                         const std::vector<std::string>& coarser, const std::string& finest) {
  const CaseAssessment& assessment = case_named(cases, violent);
  const double moving = spread(assessment, "moving", coarser, finest);
  const double fixed = spread(assessment, "fixed", coarser, finest);
  const Held held = clearly_smaller(fixed, moving);
  return {held, fmt::format("{}: rms difference of the filtered pressure to {} {:.0f} % fixed, "
                            "{:.0f} % moving (at most {} times as much){}",
                            study, finest, 100 * fixed, 100 * moving, limit::clearly_smaller,
                            held == Held::undecided ? ": alike or no number" : "")};
}

}  // namespace

std::vector<Claim> zhao2021_claims(const Cases& cases) {
  const Cases* all = &cases;
  Claim record{
      "The pressure at the gauge of the mildly rolling tank agrees with the experiment in shape "
      "and "
      "phase.",
      {}};
  for (const char* run : {"moving_5mm", "fixed_5mm"}) {
    record.findings.push_back([=] { return agrees_in_phase(*all, run); });
    record.findings.push_back([=] { return agrees_in_shape(*all, run); });
  }
  Claim same{"Moving and fixed dynamic boundary particles give the same mild roll.", {}};
  for (const Load load : {Load::pressure, Load::force, Load::moment})
    same.findings.push_back([=] { return same_in_both_ways(*all, load); });
  return {record,
          same,
          {"The violent roll's impact pressure agrees with the experiment.",
           {[=] { return impacts_in_time(*all); }, [=] { return plateau_agrees(*all); },
            [=] { return peaks_among_repeats(*all); }}},
          {"Fixed boundary particles are more stable than moving ones.",
           {[=] { return fixed_is_more_stable(*all); }}},
          {"Fixed boundary particles converge better with time step and spacing.",
           {[=] {
              return converges_better(*all, "spacing", {"8mm", "4mm"}, "2mm");
            },
            [=] {
              return converges_better(*all, "time step", {"4mm", "4mm_cfl04"}, "4mm_cfl01");
            }}}};
}

}  // namespace slosh
