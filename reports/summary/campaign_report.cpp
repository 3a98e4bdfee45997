#include "reports/summary/campaign_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/figures/case_figures.hpp"
#include "reports/model/side_by_side.hpp"
#include "reports/summary/problem_tables.hpp"
#include "reports/summary/results_json.hpp"
#include "reports/summary/summary_sections.hpp"
#include "reports/summary/work_precision_tables.hpp"
#include "reports/summary/worst_first.hpp"
#include "reports/tables/ablation_table.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/tables/case_text.hpp"
#include "reports/tables/ensemble_table.hpp"
#include "reports/tables/error_matrix.hpp"
#include "reports/tables/impact_table.hpp"
#include "reports/tables/order_table.hpp"
#include "reports/tables/repeat_table.hpp"
#include "reports/tables/report_places.hpp"
#include "reports/tables/rest_table.hpp"
#include "reports/tables/uncertainty_table.hpp"
#include "sph/threads.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/case_file/motion_table.hpp"
#include "verification/papers/li2010_paper.hpp"
#include "verification/papers/wall_treatments.hpp"
#include "verification/papers/zhao2021_paper.hpp"
#include "verification/results/provenance.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/sensitivity/row_strength.hpp"

namespace slosh {
namespace {

using reports::Section;

template <class Assessment>
int count(const std::vector<Assessment>& assessed, Verdict verdict) {
  int n = 0;
  for (const Assessment& one : assessed)
    for (const auto& outcome : one.gate) n += outcome.verdict == verdict;
  return n;
}

int count(const std::vector<CaseAssessment>& cases, const std::vector<ProblemAssessment>& problems,
          RunState state) {
  int n = 0;
  for (const ProblemAssessment& one : problems) n += one.run.status.state == state;
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status) n += status.state == state;
  return n;
}

int pairs_not_comparable(const std::vector<CaseAssessment>& cases) {
  int n = 0;
  for (const CaseAssessment& one : cases) n += static_cast<int>(one.not_comparable.size());
  return n;
}

// The gate rows of a case and what they ask for, first on its page.
Section gate_section(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Section section;
  section.id = definition.name + "-gate";
  section.title = "Gate";
  section.page = page_of_case(definition.name);
  if (definition.gate.empty())
    section.paragraphs.push_back("No gate row judges this case.");
  else
    section.tables = {gate_table(assessment), limits_table(assessment)};
  if (auto failures = failure_table(definition.name, assessment.runs.status))
    section.tables.push_back(std::move(*failures));
  return section;
}

Section case_section(const CaseAssessment& assessment, int threads, KnownStrengths* known) {
  const std::vector<RowStrength> strengths = row_strengths(assessment, threads, known);
  const CaseDefinition& definition = assessment.definition;
  Section section;
  section.id = definition.name;
  section.title = "Case and runs";
  section.page = page_of_case(definition.name);
  section.paragraphs = {
      fmt::format("{}. Tank {} m x {} m, liquid {}; {}; {} s from rest in the {}'s frame. "
                  "Comparison from {} to {} s.",
                  definition.source, definition.tank.length, definition.tank.height,
                  liquid_text(definition), motion_text(definition), definition.duration,
                  definition.start == Start::earth ? "earth" : "tank", definition.window_begin,
                  definition.window_end)};
  for (const auto& [run, status] : assessment.runs.status)
    if (status.state == RunState::out_of_range)
      section.paragraphs.push_back("The reference `" + run + "` " + status.message +
                                   ": it is drawn and never gates.");
    else if (status.state == RunState::not_supplied)
      section.paragraphs.push_back("The record `" + run + "` is not supplied: " + status.message +
                                   ". Rows that need it neither pass nor fail.");
  for (const std::string& pair : assessment.not_comparable)
    section.paragraphs.push_back("Not comparable: " + pair + ".");
  section.figures = case_figures(assessment);
  section.fields = case_fields(assessment);
  if (auto uncertain = uncertainty_table(assessment))
    section.tables.push_back(std::move(*uncertain));
  if (!definition.gate.empty()) section.tables.push_back(strength_table(assessment, strengths));
  section.tables.push_back(
      coverage_table(definition.name + "-coverage", {case_coverage(assessment, strengths)}));
  if (auto remedies = remedy_table(assessment)) section.tables.push_back(std::move(*remedies));
  if (auto matrix = error_matrix(assessment)) section.tables.push_back(std::move(*matrix));
  if (auto refined = refinement_table(assessment)) section.tables.push_back(std::move(*refined));
  if (auto rest = rest_table(assessment)) section.tables.push_back(std::move(*rest));
  if (auto impacts = impact_table(assessment)) section.tables.push_back(std::move(*impacts));
  if (auto ensembles = ensemble_table(assessment)) section.tables.push_back(std::move(*ensembles));
  if (auto repeats = repeat_table(assessment)) section.tables.push_back(std::move(*repeats));
  if (auto choices = ablation_table(assessment)) section.tables.push_back(std::move(*choices));
  if (auto orders = order_table(assessment)) section.tables.push_back(std::move(*orders));
  if (!assessment.comparisons.empty()) {
    if (!fitted_modes(definition).empty()) section.tables.push_back(mode_table(assessment));
    section.tables.push_back(history_table(assessment));
  }
  for (reports::Table& table : work_precision_tables(assessment))
    section.tables.push_back(std::move(table));
  section.tables.push_back(cost_table(assessment));
  section.tables.push_back(terms_table(assessment));
  section.tables.push_back(provenance_table(assessment));
  return section;
}

bool has_selected(const std::vector<ProblemAssessment>& problems) {
  return std::any_of(problems.begin(), problems.end(), [](const ProblemAssessment& one) {
    return one.run.status.state != RunState::not_selected;
  });
}

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

// Without a verdict where nothing is judged and nothing is amiss.
reports::Page page_of(const CaseAssessment& assessment) {
  reports::Page page{page_of_case(assessment.definition.name), assessment.definition.title, "", {}};
  const std::vector<CaseAssessment> alone{assessment};
  const Standing standing = standing_of(alone);
  const bool judged =
      std::any_of(standing.verdicts.begin(), standing.verdicts.end(), [](Verdict verdict) {
        return verdict != Verdict::not_selected && verdict != Verdict::not_supplied;
      });
  if (!judged && !standing.run_failed && !standing.left_open) return page;
  page.verdict = verdict_sentence(alone);
  page.outcome = outcome_of(exit_status(standing));
  return page;
}

// What is told of several cases together, where there is any.
void add_across_page(const CampaignDefinition& campaign, const std::vector<CaseAssessment>& cases,
                     reports::Report& report) {
  std::vector<Section> sections;
  if (auto walls = wall_treatment_section(cases)) sections.push_back(std::move(*walls));
  if (campaign.paper == "li2010") sections.push_back(li2010_section(cases));
  if (campaign.paper == "zhao2021") sections.push_back(zhao2021_section(cases));
  if (sections.empty()) return;
  report.pages.push_back({across_page, "Across the cases", "", {}});
  for (Section& one : sections) {
    one.page = across_page;
    report.sections.push_back(std::move(one));
  }
}

}  // namespace

std::string verdict_sentence(const std::vector<CaseAssessment>& cases,
                             const std::vector<ProblemAssessment>& problems) {
  const auto rows = [&](Verdict verdict) {
    return count(cases, verdict) + count(problems, verdict);
  };
  const auto runs = [&](RunState state) { return count(cases, problems, state); };
  const int passed = rows(Verdict::pass);
  const int judged = passed + rows(Verdict::violated) + rows(Verdict::inconclusive) +
                     rows(Verdict::solver_failed) + rows(Verdict::not_compared);
  std::string text = fmt::format("{} of {} gate rows hold", passed, judged);
  const auto add = [&](int n, const char* what) {
    if (n > 0) text += fmt::format(", {} {}", n, what);
  };
  add(rows(Verdict::violated), "violated");
  add(rows(Verdict::inconclusive), "inconclusive");
  add(rows(Verdict::not_compared), "not compared");
  add(pairs_not_comparable(cases), "pairs not comparable");
  add(runs(RunState::failed), "runs failed");
  add(runs(RunState::missing), "runs without a result");
  add(runs(RunState::not_supplied), "records not supplied");
  add(rows(Verdict::not_supplied), "gate rows without their record");
  add(rows(Verdict::not_selected), "not selected");
  return text + ".";
}

reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::string& command,
                                const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems,
                                KnownStrengths* known) {
  const auto origin = provenance("");
  reports::Report report;
  report.title = campaign.title + (quick ? " (quick form)" : "");
  report.verdict = verdict_sentence(cases, problems) + coverage_sentence(cases);
  report.outcome = outcome_of(exit_status(cases, problems));
  report.decided_by = deciding_row(cases, problems);
  report.subtitle = fmt::format("{} · Slosh {} · {}", origin.at("date_utc"),
                                origin.at("slosh_version"), origin.at("processor"));
  report.sections =
      summary_sections(cases, problems,
                       fmt::format("{} Repeat this campaign with `{}`. {}.",
                                   kinds_sentence(cases, problems), command, campaign.source));
  // The cores that the cases leave try a case's rows side by side.
  const auto selected = std::count_if(cases.begin(), cases.end(), has_selected_runs);
  const int cores = sph::usable_cores(),
            of_one_case = std::max(1, cores / std::max(1, static_cast<int>(selected)));
  std::vector<Section> case_sections(cases.size());
  reports::side_by_side(cases.size(), cores, [&](std::size_t i) {
    if (has_selected_runs(cases[i])) case_sections[i] = case_section(cases[i], of_one_case, known);
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!has_selected_runs(cases[i])) continue;
    report.pages.push_back(page_of(cases[i]));
    report.sections.push_back(gate_section(cases[i]));
    report.sections.push_back(std::move(case_sections[i]));
  }
  if (has_selected(problems))
    report.pages.push_back({problems_page, "Verification problems", verdict_sentence({}, problems),
                            outcome_of(exit_status({}, problems))});
  for (const ProblemAssessment& one : problems)
    if (one.run.status.state != RunState::not_selected)
      report.sections.push_back(problem_section(one));
  add_across_page(campaign, cases, report);
  report.results_json = results_json(campaign.name, quick, cases, problems);
  return report;
}

}  // namespace slosh
