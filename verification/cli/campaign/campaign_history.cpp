#include "verification/cli/campaign/campaign_history.hpp"

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>
#include <utility>

#include "reports/figures/earlier_figure.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/gate_history.hpp"
#include "verification/case/quantities.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

fs::path history_file(const CampaignPast& past) {
  return past.store.root() / "history" / (past.name + ".jsonl");
}

std::vector<CampaignState> readable_history(const CampaignPast& past) try {
  return read_history(history_file(past));
} catch (const ResultError& error) {
  std::cerr << error.what()
            << "\nThe report leaves out the campaign's earlier results. Remove the file to begin a "
               "new history.\n";
  return {};
}

// Reads the result of the state, with filtered pressures as the present results have them. Returns
// nullopt where it answers another question, is the present one, or is not in the store any more.
std::optional<EarlierResult> result_in(const CampaignState& state, const CaseAssessment& assessment,
                                       const GateRow& row, const ResultStore& store) try {
  const std::string& name = assessment.definition.name;
  const auto earlier = state.results.find(name + "/" + row.candidate);
  const std::string& present = assessment.runs.results.at(row.candidate).key;
  if (earlier == state.results.end() || earlier->second == present ||
      !asks_the_same(earlier->second, present))
    return std::nullopt;
  CaseRuns runs;
  runs.results[row.candidate] = read_stored(store.file(earlier->second, ".h5"), read_result);
  add_filtered_pressures(assessment.definition, runs);
  if (!has_series(runs, row.candidate, row.quantity)) return std::nullopt;
  const auto judged = state.rows.find(row_name(name, row));
  return EarlierResult{std::move(runs.results.at(row.candidate)), state.when_utc.substr(0, 10),
                       judged != state.rows.end() && judged->second.holds};
} catch (const ResultError&) {
  return std::nullopt;
}

// Returns the latest earlier result with which the row held, or else the latest one.
std::optional<EarlierResult> earlier_result(const std::vector<CampaignState>& history,
                                            const CaseAssessment& assessment, const GateRow& row,
                                            const ResultStore& store) {
  std::optional<EarlierResult> latest;
  for (auto state = history.rbegin(); state != history.rend(); ++state) {
    std::optional<EarlierResult> found = result_in(*state, assessment, row, store);
    if (found && found->row_held) return found;
    if (found && !latest) latest = std::move(found);
  }
  return latest;
}

// One figure for each candidate and quantity, however many of their rows do not hold.
std::vector<reports::Figure> earlier_figures(const std::vector<CampaignState>& history,
                                             const CaseAssessment& assessment,
                                             const ResultStore& store) {
  std::vector<reports::Figure> figures;
  std::set<std::pair<std::string, std::string>> shown;
  for (const auto& [row, verdict, value, message, judgement] : assessment.gate) {
    if (!is_judged(verdict) || verdict == Verdict::pass) continue;
    const std::vector<std::string> quantities = compared_quantities(assessment.definition);
    const bool is_compared =
        std::find(quantities.begin(), quantities.end(), row.quantity) != quantities.end() &&
        has_series(assessment.runs, row.candidate, row.quantity);
    if (!is_compared || shown.contains({row.candidate, row.quantity})) continue;
    if (const auto earlier = earlier_result(history, assessment, row, store)) {
      figures.push_back(earlier_figure(assessment, row, *earlier));
      shown.insert({row.candidate, row.quantity});
    }
  }
  return figures;
}

}  // namespace

void keep_state(const AssessedCampaign& assessed, const CampaignPast& past) try {
  append_state(state_of(assessed.cases, provenance("").at("date_utc")), history_file(past));
} catch (const ResultError& error) {
  std::cerr << "The campaign's history is not continued: " << error.what() << '\n';
}

void add_past(const AssessedCampaign& assessed, const CampaignPast& past, reports::Report& report) {
  const std::vector<CampaignState> history = readable_history(past);
  for (const CaseAssessment& one : assessed.cases) {
    const auto section =
        std::find_if(report.sections.begin(), report.sections.end(),
                     [&](const auto& section) { return section.id == one.definition.name; });
    if (section == report.sections.end()) continue;
    const std::vector<reports::Figure> figures = earlier_figures(history, one, past.store);
    section->figures.insert(section->figures.begin(), figures.begin(), figures.end());
  }
}

}  // namespace slosh
