#include "reports/summary/recorded_campaigns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <tuple>

#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/provenance.hpp"

namespace slosh {
namespace {

using nlohmann::json;

Prediction prediction_from(const json& entry) {
  const json& half_width = entry.at("ratio_half_width_95");
  return {
      entry.at("case"),
      entry.at("candidate"),
      entry.at("reference"),
      entry.at("quantity"),
      entry.at("mode"),
      {entry.at("predicted"), entry.at("reference_value"),
       entry.at("reference_relative_deviation")},
      half_width.is_null() ? std::numeric_limits<double>::quiet_NaN() : half_width.get<double>()};
}

PredictionSet set_from(const json& entry) {
  PredictionSet set{entry.at("quantity_kind"), entry.at("unit"), entry.at("model"), {}, {}};
  for (const json& one : entry.at("comparisons")) set.predictions.push_back(prediction_from(one));
  return set;
}

// The worst first: a solver failed, violated, not compared, inconclusive, pass.
constexpr std::array<int, 5> statuses{exit_solver_failed, exit_violated, exit_not_compared,
                                      exit_inconclusive, exit_pass};

// Throws std::invalid_argument for a name that no verdict has.
Verdict verdict_from(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Verdict::not_supplied); ++i)
    if (const auto verdict = static_cast<Verdict>(i); verdict_name(verdict) == name) return verdict;
  throw std::invalid_argument("verdict \"" + name + "\": expected that of a gate row");
}

// The verdict that has the exit status; any other status is taken for that of a violated row.
std::string status_word(int status) {
  for (const Verdict verdict :
       {Verdict::pass, Verdict::inconclusive, Verdict::not_compared, Verdict::solver_failed})
    if (exit_status_of({verdict}) == status) return verdict_name(verdict);
  return verdict_name(Verdict::violated);
}

reports::Table campaigns_table(const std::vector<RecordedCampaign>& campaigns) {
  reports::Table table{
      "campaigns",
      "Verdicts of the campaigns",
      "Each line is the last report of a campaign in this directory.",
      {"verdict", "campaign", "form", "gate rows judged", "gate rows that hold", "report"}};
  for (const RecordedCampaign& one : campaigns)
    table.rows.push_back({status_word(one.exit_status), one.name, one.is_quick ? "quick" : "whole",
                          std::to_string(one.rows), std::to_string(one.passed),
                          "`" + one.place + "`"});
  return table;
}

std::string document_of(int status, const std::vector<PredictionSet>& sets) {
  auto document =
      nlohmann::ordered_json::parse(with_exit_status(status, results_json("all", false, {})));
  for (const PredictionSet& set : sets) document["model_bias"].push_back(bias_json(set));
  return document.dump(2);
}

// The user may have replaced that of an inconclusive campaign.
int exit_status_in(const json& document) {
  const json& status = document.at("exit_status");
  if (!status.is_number_integer() || status < 0 || status > largest_exit)
    throw std::invalid_argument(fmt::format("exit_status {}: expected an integer from 0 to {}",
                                            status.dump(), largest_exit));
  return status;
}

}  // namespace

bool is_worse_status(int status, int other) {
  return std::find(statuses.begin(), statuses.end(), status) <
         std::find(statuses.begin(), statuses.end(), other);
}

RecordedCampaign recorded_campaign(const std::string& text, const std::string& place) try {
  const json document = parsed_json<json>(text);
  RecordedCampaign recorded{
      document.at("campaign"), document.at("quick"), exit_status_in(document), 0, 0, place, {}};
  std::vector<Verdict> verdicts;
  for (const char* kind : {"cases", "problems"})
    for (const json& one : document.at(kind))
      for (const json& row : one.at("gate")) {
        const Verdict verdict = verdict_from(row.at("verdict"));
        if (verdict == Verdict::not_selected || verdict == Verdict::not_supplied) continue;
        verdicts.push_back(verdict);
        ++recorded.rows;
        recorded.passed += verdict == Verdict::pass;
      }
  const int of_rows = exit_status_of(verdicts);
  if (of_rows == exit_inconclusive && !is_worse_status(recorded.exit_status, of_rows))
    recorded.exit_status = of_rows;
  if (is_worse_status(of_rows, recorded.exit_status) ||
      std::find(statuses.begin(), statuses.end(), recorded.exit_status) == statuses.end())
    throw std::invalid_argument(fmt::format("exit_status {}: expected {}, that of its gate rows",
                                            recorded.exit_status, of_rows));
  for (const json& set : document.at("model_bias")) recorded.predictions.push_back(set_from(set));
  return recorded;
} catch (const json::exception& error) {
  throw std::invalid_argument(words_of(error));
}

std::vector<PredictionSet> merged_predictions(const std::vector<RecordedCampaign>& campaigns) {
  std::vector<PredictionSet> merged;
  using Key = std::tuple<std::string, std::string, std::string, std::string, std::string>;
  std::set<Key> known;
  for (const bool quick : {false, true})
    for (const RecordedCampaign& campaign : campaigns) {
      if (campaign.is_quick != quick) continue;
      std::set<Key> of_campaign;  // one campaign may compare a model with several references
      for (const PredictionSet& set : campaign.predictions) {
        auto into = std::find_if(merged.begin(), merged.end(), [&](const PredictionSet& one) {
          return one.kind == set.kind && one.model == set.model;
        });
        if (into == merged.end())
          into = merged.insert(into, {set.kind, set.unit, set.model, {}, {}});
        for (const Prediction& one : set.predictions) {
          const Key key{set.kind, set.model, one.case_name, one.quantity, one.mode};
          of_campaign.insert(key);
          if (!known.contains(key)) into->predictions.push_back(one);
        }
      }
      known.merge(of_campaign);
    }
  settle(merged);
  return merged;
}

int exit_status(const std::vector<RecordedCampaign>& campaigns,
                const std::vector<std::string>& left_out) {
  if (campaigns.empty()) return exit_not_compared;
  int worst = left_out.empty() ? exit_pass : exit_not_compared;
  for (const RecordedCampaign& one : campaigns)
    if (is_worse_status(one.exit_status, worst)) worst = one.exit_status;
  return worst;
}

reports::Report superseded_report(const std::string& campaign, int status, const std::string& why) {
  reports::Report report;
  report.title = campaign;
  report.verdict = why;
  const bool is_verdict = std::find(statuses.begin(), statuses.end(), status) != statuses.end();
  report.outcome = outcome_of(is_verdict ? status : static_cast<int>(exit_not_compared));
  report.results_json = with_exit_status(status, results_json(campaign, false, {}));
  return report;
}

reports::Report report_of_campaigns(const std::vector<RecordedCampaign>& campaigns,
                                    const std::vector<std::string>& left_out) {
  std::size_t rows = 0, passed = 0, held = 0;
  for (const RecordedCampaign& one : campaigns) {
    rows += one.rows;
    passed += one.passed;
    held += one.exit_status == exit_pass;
  }
  const std::vector<PredictionSet> sets = merged_predictions(campaigns);
  const auto origin = provenance("");
  reports::Report report;
  report.title = "All campaigns";
  const int status = exit_status(campaigns, left_out);
  report.verdict = fmt::format("{} of {} campaigns pass; {} of {} gate rows hold.", held,
                               campaigns.size() + left_out.size(), passed, rows);
  report.outcome = outcome_of(status);
  report.subtitle = fmt::format("{} · Slosh {}", origin.at("date_utc"), origin.at("slosh_version"));
  reports::Section verdicts{"campaigns", "Verdicts", {}, {campaigns_table(campaigns)}};
  if (!left_out.empty())
    verdicts.paragraphs.push_back(
        fmt::format("Left out, as they could not be read: {}.", fmt::join(left_out, "; ")));
  reports::Section bias = bias_section(sets);
  bias.paragraphs.push_back(
      "A comparison that several campaigns make counts once, that of a whole campaign before that "
      "of a quick form.");
  report.sections = {std::move(bias), std::move(verdicts)};
  report.results_json = document_of(status, sets);
  return report;
}

}  // namespace slosh
