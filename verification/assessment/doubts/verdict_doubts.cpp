#include "verification/assessment/doubts/verdict_doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

constexpr double much_of_a_series = 0.5;  // a quarter of its variance

bool rests_on_models_alone(const CaseDefinition& definition, const GateRow& row) {
  return (row.metric == Metric::largest_magnitude || row.metric == Metric::frequency) &&
         find_quantity(row.quantity) && is_simulation(run_named(definition, row.candidate));
}

std::string beyond_limits(const CaseDefinition& definition, const CaseRuns& runs) {
  std::vector<std::string> exceeded;
  for (const ModelLimit& limit : model_limits(definition, runs))
    if (limit.exceeded()) exceeded.push_back(limit_text(limit));
  return exceeded.empty()
             ? ""
             : fmt::format("beyond the limit of the models: {}", fmt::join(exceeded, "; "));
}

bool is_of_pair(const GateRow& row, const Comparison& pair) {
  return row.candidate == pair.candidate && row.reference == pair.reference &&
         row.quantity == pair.quantity;
}

bool judges_a_mode(const GateRow& row) {
  return metric_entry(row.metric).fitted != FittedTones::none && !row.reference.empty();
}

bool judges_all_of_it(const GateRow& row) {
  return row.metric == Metric::normalised_rms || row.metric == Metric::aligned_rms ||
         row.metric == Metric::outside_band;
}

// "" where a row judges the whole series of the pair, or where it is near enough.
std::string rest_of_series(const GateRow& row, const std::vector<GateOutcome>& gate,
                           const std::vector<Comparison>& comparisons) {
  const auto pair = std::ranges::find_if(
      comparisons, [&](const Comparison& one) { return is_of_pair(row, one); });
  if (pair == comparisons.end() || !(pair->normalised_rms.value > much_of_a_series)) return "";
  const bool is_judged_whole = std::ranges::any_of(gate, [&](const GateOutcome& other) {
    return is_of_pair(other.row, *pair) && judges_all_of_it(other.row);
  });
  if (is_judged_whole) return "";
  return fmt::format(
      "{} departs from {} by {:.2g} % rms in all of {}, which no row judges; is the start or "
      "another "
      "mode wrong?",
      row.candidate, row.reference, 100 * pair->normalised_rms.value, row.quantity);
}

void add_remark(const std::string& remark, GateOutcome& outcome) {
  const std::string last = " (regression)";
  const std::size_t end = outcome.message.size();
  outcome.message.insert(outcome.message.ends_with(last) ? end - last.size() : end, remark);
}

// "; linear theory has 0.1531 Hz"; "" where it has no such mode.
std::string linear_frequency(const CaseDefinition& definition, const std::string& mode) {
  const std::string natural = "natural_";
  if (!mode.starts_with(natural)) return "";
  const int number = std::stoi(mode.substr(natural.size()));
  const std::vector<double> all = natural_frequencies(definition, number);
  return std::ssize(all) < number
             ? ""
             : fmt::format("; linear theory has {:.4g} Hz", all.back() / (2 * std::numbers::pi));
}

}  // namespace

std::vector<std::string> doubt_verdicts(const CaseDefinition& definition, const CaseRuns& runs,
                                        const std::vector<Comparison>& comparisons,
                                        std::vector<GateOutcome>& gate) {
  std::vector<std::string> told;
  if (std::string unsound = doubtful_runs(definition, runs); !unsound.empty())
    told.push_back(std::move(unsound));
  for (GateOutcome& outcome : gate) {
    if (!is_judged(outcome.verdict)) continue;
    if (outcome.row.metric == Metric::frequency)
      add_remark(linear_frequency(definition, outcome.row.mode), outcome);
    std::string doubt, of_row;
    if (rests_on_models_alone(definition, outcome.row)) {
      doubt = beyond_limits(definition, runs);
      of_row = "beyond a limit of the models, and without a reference";
    } else if (outcome.verdict == Verdict::pass && judges_a_mode(outcome.row)) {
      doubt = rest_of_series(outcome.row, gate, comparisons);
      of_row = "no row judges the rest of the series, which departs by more";
    }
    if (doubt.empty()) continue;
    outcome.is_doubtful = true;
    outcome.remarks += "; doubtful: " + of_row;
    add_remark("; doubtful: " + of_row, outcome);
    const std::string line = fmt::format("doubtful: {}: {}", definition.name, doubt);
    if (std::ranges::find(told, line) == told.end()) told.push_back(line);
  }
  return told;
}

}  // namespace slosh
