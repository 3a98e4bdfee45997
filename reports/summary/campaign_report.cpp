#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/paper_panels.hpp"
#include "reports/model/report_files.hpp"
#include "reports/summary/headline.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "reports/summary/shown_rows.hpp"
#include "reports/wording/case_text.hpp"
#include "sph/threads.hpp"
#include "verification/assessment/campaign_cost.hpp"
#include "verification/assessment/predictions.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/results/provenance.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {
namespace {

using reports::Section;

// The first page: the departures case by case, error against run time, the gate rows worst first,
// bias and scatter of the models. `sentences` are shown unchanged.
std::vector<Section> summary_sections(const std::vector<CaseAssessment>& cases,
                                      const std::vector<ProblemAssessment>& problems,
                                      const std::vector<HeadlineLine>& lines,
                                      const std::string& sentences) {
  Section gate{"gate", "Verdicts", {sentences}};
  if (lines.empty())
    gate.paragraphs.push_back("The campaign has no gate row that was judged.");
  else
    gate.tables.push_back(headline_table(lines));
  for (const CaseAssessment& one : cases)
    if (auto figure = speed_figure(one)) gate.figures.push_back(std::move(*figure));
  std::vector<Section> sections{std::move(gate)};
  if (reports::Table worst = worst_first_table(cases, problems); !worst.rows.empty())
    sections.push_back({"worst", "Gate rows, worst first", {}, {std::move(worst)}});
  if (!cases.empty()) sections.push_back(bias_section(prediction_sets(cases)));
  return sections;
}

// What the rows of the cases detect, for the first page.
std::string coverage_text(const std::vector<CaseCoverage>& covered) {
  if (covered.empty()) return "";
  std::vector<std::string> incomplete;
  for (const CaseCoverage& one : covered)
    if (!one.missed().empty()) incomplete.push_back(one.case_name);
  return fmt::format(
      "Coverage: the gate rows of {} of {} cases detect results that are made wrong on purpose, in "
      "{}{}.",
      covered.size() - incomplete.size(), covered.size(), fmt::join(names_of_required(), ", "),
      incomplete.empty() ? ""
                         : fmt::format("; those of {} miss some", fmt::join(incomplete, ", ")));
}

// Whether every judged row passes. What a failing row would not detect says nothing: it objects
// already.
bool all_pass(const CaseAssessment& assessment) {
  return std::ranges::none_of(assessment.gate, [](const GateOutcome& outcome) {
    return is_judged(outcome.verdict) && outcome.verdict != Verdict::pass;
  });
}

std::string missed_text(const CaseCoverage& covered) {
  const std::vector<std::string> missed = covered.missed();
  return missed.empty() ? ""
                        : fmt::format("The rows would not detect: {}.", fmt::join(missed, ", "));
}

// With regression rows alone a campaign that passes is watched.
reports::Outcome shown_outcome(int status, const std::vector<HeadlineLine>& lines) {
  return status == exit_pass && is_only_watched(lines) ? reports::Outcome::watched
                                                       : outcome_of(status);
}

// The page has no verdict where no row was judged and no run failed or is missing.
reports::Page page_of(const CaseAssessment& assessment, const CaseCoverage& coverage,
                      std::vector<HeadlineLine> lines) {
  const std::string& name = assessment.definition.name;
  reports::Page page{case_id(name), assessment.definition.title, "", {}};
  page.glance = glance_figure(assessment, worst_candidate(assessment));
  if (all_pass(assessment)) page.remark = missed_text(coverage);
  page.doubts = assessment.doubts;
  std::erase_if(lines, [&](const auto& line) { return line.section != case_id(name) + "-gate"; });
  const std::vector<CaseAssessment> alone{assessment};
  const Standing standing = standing_of(alone);
  if (lines.empty() && !standing.run_failed && !standing.left_open) return page;
  page.verdict = verdict_sentence(alone);
  page.outcome = shown_outcome(exit_status(standing), lines);
  return page;
}

// What is worked out of a case before its page is written.
struct WrittenCase {
  std::vector<Section> sections;
  CaseCoverage coverage;
};

WrittenCase written(const CaseAssessment& assessment) {
  const std::vector<RowSensitivity> sensitivity = gate_sensitivity(assessment);
  CaseCoverage coverage = case_coverage(assessment, sensitivity);
  return {case_sections(assessment, sensitivity, coverage), std::move(coverage)};
}

reports::Page appendix_page(const CaseDefinition& definition) {
  return {appendix_of_case(definition.name),
          definition.title + ": further figures and tables",
          "",
          {},
          case_id(definition.name)};
}

// Adds what the paper says beside our results, to the first page, and its figures redrawn.
void add_paper_sections(const Paper& paper, const std::vector<CaseAssessment>& cases,
                        reports::Report& report, std::vector<Section>& sections) {
  PaperPanels panels = paper_panels(paper, cases, report.sections);
  report.sections.push_back(paper_section(paper, cases, panels.redrawn));
  if (panels.figures.empty()) return;
  sections.push_back({paper.name + "-figures",
                      "The paper's figures, redrawn",
                      {fmt::format("The figures of {} from the runs of this campaign. A curve that "
                                   "you digitised from the paper joins its panel as a record: a "
                                   "run with `solver = \"record\"` in the case file.",
                                   paper.citation)},
                      {},
                      std::move(panels.figures)});
}

// Adds the page of results across several cases, where there are any.
void add_across_page(const CampaignDefinition& campaign, const std::vector<CaseAssessment>& cases,
                     reports::Report& report) {
  std::vector<Section> sections;
  if (auto walls = wall_treatment_section(cases)) sections.push_back(std::move(*walls));
  if (!campaign.paper.empty())
    add_paper_sections(paper_named(campaign.paper), cases, report, sections);
  if (sections.empty()) return;
  report.pages.push_back({across_page, "Across the cases", "", {}});
  for (Section& one : sections) {
    one.page = across_page;
    report.sections.push_back(std::move(one));
  }
}

}  // namespace

reports::Outcome outcome_of(int status) {
  switch (status) {
    case exit_pass:
      return reports::Outcome::pass;
    case exit_inconclusive:
      return reports::Outcome::inconclusive;
    case exit_not_compared:
      return reports::Outcome::not_compared;
    default:
      return reports::Outcome::fail;
  }
}

reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::string& command,
                                const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems) {
  const auto origin = provenance("");
  reports::Report report;
  report.title = campaign.title + (quick ? " (quick form)" : "");
  const std::vector<HeadlineLine> lines = headline_lines(cases, problems);
  const std::string verdict = verdict_sentence(cases, problems);
  report.verdict = lines.empty() ? verdict : headline_sentence(lines);
  report.outcome = shown_outcome(exit_status(cases, problems), lines);
  report.decision = decision_of(cases, problems);
  report.subtitle = fmt::format("{} · Slosh {} · {}", origin.at("date_utc"),
                                origin.at("slosh_version"), origin.at("processor"));
  std::vector<std::string> sentences{
      verdict + coverage_sentence(cases), basis_sentence(cases, problems),
      cost_sentence(cases, problems),
      fmt::format("Repeat this campaign with `{}`. Source: {}.", command, campaign.source)};
  std::erase(sentences, "");
  report.sections =
      summary_sections(cases, problems, lines, fmt::format("{}", fmt::join(sentences, " ")));
  std::vector<WrittenCase> ready(cases.size());
  reports::side_by_side(cases.size(), sph::usable_cores(), [&](std::size_t i) {
    if (has_selected_runs(cases[i])) ready[i] = written(cases[i]);
  });
  std::vector<CaseCoverage> covered;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!has_selected_runs(cases[i])) continue;
    report.pages.push_back(page_of(cases[i], ready[i].coverage, lines));
    std::ranges::copy(report.pages.back().doubts, std::back_inserter(report.doubts));
    report.pages.push_back(appendix_page(cases[i].definition));
    std::ranges::move(ready[i].sections, std::back_inserter(report.sections));
    if (all_pass(cases[i])) covered.push_back(std::move(ready[i].coverage));
  }
  report.coverage = coverage_text(covered);
  const std::size_t before_problems = report.sections.size();
  for (const ProblemAssessment& one : problems)
    if (one.run.status.state != RunState::not_selected)
      report.sections.push_back(problem_section(one));
  if (report.sections.size() > before_problems)
    report.pages.push_back({problems_page, "Verification problems", verdict_sentence({}, problems),
                            outcome_of(exit_status({}, problems))});
  add_across_page(campaign, cases, report);
  report.results_json = results_json(campaign.name, quick, cases, problems, campaign.paper);
  return report;
}

}  // namespace slosh
