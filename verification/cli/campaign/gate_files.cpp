#include "verification/cli/campaign/gate_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reports/summary/shown_rows.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/files/own_files.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
// The path that a code forge knows the file by: relative to the source tree, or to the current
// directory, whichever it lies below; for a case of another repository that is the latter.
std::string path_in_repository(const fs::path& source, const fs::path& file) {
  for (const fs::path& root : {source, fs::current_path()}) {
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(root);
    if (!relative.empty() && *relative.begin() != "..") return relative.string();
  }
  return file.string();
}

bool is_skipped(const reports::GateEntry& entry) {
  return entry.verdict == Verdict::not_selected || entry.verdict == Verdict::not_supplied;
}

// Fills in what rows of cases and of problems have in common: all but the name, the value and the
// change since the baseline.
template <class Outcome>
reports::GateEntry entry_in(const std::string& group, const Outcome& outcome,
                            const fs::path& source) {
  return {.verdict = outcome.verdict,
          .group = group,
          .name = "",
          .message = outcome.message,
          .unit = outcome.row.unit,
          .lower = {},
          .upper = {},
          .moved = "",
          .kind = kind_name(outcome.row.kind),
          .file = path_in_repository(source, outcome.row.where.file),
          .line = outcome.row.where.line};
}

// Adds the change since the baseline. A row of validation that is one of regression now has lost
// its verdict.
void add_movement(const std::string& row, const GateFindings& findings, reports::GateEntry& entry) {
  const auto moved =
      std::find_if(findings.movements.begin(), findings.movements.end(),
                   [&](const RowMovement& one) { return one.row == row && !one.lost(); });
  if (moved == findings.movements.end()) return;
  entry.lower = moved->after->lower;
  entry.upper = moved->after->upper;
  const bool is_bad = entry.verdict != Verdict::pass && !is_skipped(entry);
  const bool is_told = moved->has_changed() || is_bad;
  if (findings.has_baseline && is_told) entry.moved = movement_text(*moved);
  entry.loosened = moved->loosened;
  entry.lost = moved->loses_validation() && entry.verdict == Verdict::pass;
}

reports::GateEntry entry_of(const CaseAssessment& assessment, const GateOutcome& outcome,
                            const GateFindings& findings, const fs::path& source) {
  const std::string& group = assessment.definition.name;
  reports::GateEntry entry = entry_in(group, outcome, source);
  entry.name = row_name(outcome.row);
  entry.value = outcome.value.value;
  entry.uncertainty = outcome.value.half_width;
  if (outcome.judgement)
    entry.uncertainties = uncertainties_text(*outcome.judgement, outcome.row.unit);
  if (outcome.remarks.starts_with("; ")) entry.remarks = outcome.remarks.substr(2);
  add_movement(row_name(group, outcome.row), findings, entry);
  return entry;
}

reports::GateEntry entry_of(const ProblemAssessment& assessment, const ProblemGateOutcome& outcome,
                            const GateFindings& findings, const fs::path& source) {
  reports::GateEntry entry = entry_in(assessment.definition.name, outcome, source);
  entry.name = metric_name(outcome.row.metric) + " of " + outcome.row.measure;
  entry.value = outcome.value;
  add_movement(row_name(assessment.definition.name, outcome.row), findings, entry);
  return entry;
}

reports::GateEntry entry_of(const RowMovement& lost) {
  const std::size_t colon = std::min(lost.row.find(": "), lost.row.size());
  reports::GateEntry entry =
      bare_entry(lost.row.substr(0, colon), lost.row.substr(std::min(colon + 2, lost.row.size())),
                 Verdict::not_selected, "the baseline has the row, and no approval takes it out");
  entry.lost = lost.loses_validation();
  entry.moved = movement_text(lost);
  if (lost.before->terms) entry.kind = lost.before->terms->kind;
  return entry;
}

// Adds a run or a problem that has no usable result.
void add_open_run(const std::string& group, const std::string& name, const RunStatus& status,
                  reports::GateDocument& document) {
  if (status.state != RunState::failed && status.state != RunState::missing) return;
  const auto [verdict, message] = obstacle_of(name, status).value();
  document.entries.push_back(bare_entry(group, name, verdict, message));
}

// Adds the verdict itself where it is none of a row or a run: nothing was judged, or no pair of a
// case could be compared.
void add_bare_verdict(const std::string& campaign, const GateFindings& findings,
                      reports::GateDocument& document) {
  const auto passes = [&](const reports::GateEntry& one) {
    return !one.lost && (one.verdict == Verdict::pass || is_skipped(one) ||
                         (one.verdict == Verdict::inconclusive && findings.inconclusive_passes));
  };
  const bool is_told = !std::all_of(document.entries.begin(), document.entries.end(), passes);
  const bool all_pass = findings.status == exit_pass ||
                        (findings.status == exit_inconclusive && findings.inconclusive_passes);
  if (!all_pass && !is_told)
    document.entries.push_back(
        bare_entry(campaign, "the campaign", Verdict::not_compared, document.verdict));
}

}  // namespace

std::string verdict_text(const AssessedCampaign& assessed, const std::vector<HeadlineLine>& lines,
                         int status) {
  const auto& [definition, output, cases, problems] = assessed;
  auto [lead, row, finding] = decision_of(cases, problems);
  if (status == exit_solver_failed) finding = "";  // the complaint about the run has it
  const std::string sentence =
      lines.empty() ? verdict_sentence(cases, problems) : headline_sentence(lines);
  std::string decision;
  if (!row.text.empty())
    decision = fmt::format(" {} {}{}", lead, row.text, finding.empty() ? "." : ": " + finding);
  // The line of a case without a reference is the row that decides: what remains is the remedy.
  const std::size_t remedy = finding.find(". What would decide it");
  const std::string told =
      finding.substr(0, std::min(remedy, finding.size() - finding.ends_with('.')));
  if (!told.empty() && sentence.find(told) != sentence.npos)
    decision = remedy == finding.npos ? "" : finding.substr(remedy + 1);
  return fmt::format("{}: {}{}", headline_word(status, lines), sentence, decision);
}

std::string headline_text(const AssessedCampaign& assessed, int status) {
  const auto& [definition, output, cases, problems] = assessed;
  const std::vector<HeadlineLine> lines = headline_lines(cases, problems);
  std::string text = verdict_text(assessed, lines, status);
  for (const CaseAssessment& one : cases)
    for (const std::string& doubt : one.doubts) text += "\n" + doubt;
  // Those of the only case stand in the sentence.
  const bool is_one = std::ranges::all_of(
      lines, [&](const HeadlineLine& line) { return line.name == lines.front().name; });
  for (const HeadlineLine& line : is_one ? std::vector<HeadlineLine>{} : lines)
    text += fmt::format("\n{:<22} {}: {}{}", line.standing, line.name, line_text(line),
                        has_numbers(line) ? "; decided by " + line.decides : "");
  return text;
}

std::string rows_text(const AssessedCampaign& assessed) {
  const auto& [definition, output, cases, problems] = assessed;
  const std::string basis = basis_sentence(cases, problems);
  return verdict_sentence(cases, problems) + coverage_sentence(cases) +
         (basis.empty() ? "" : " " + basis);
}

reports::GateEntry bare_entry(const std::string& group, const std::string& name, Verdict verdict,
                              const std::string& message) {
  return {.verdict = verdict,
          .group = group,
          .name = name,
          .message = message,
          .unit = "1",
          .value = std::nan(""),
          .uncertainty = std::nan(""),
          .lower = {},
          .upper = {},
          .moved = "",
          .file = ""};
}

reports::GateDocument gate_document(const AssessedCampaign& assessed, const GateFindings& findings,
                                    const fs::path& source) {
  const std::string changes =
      findings.has_baseline ? changes_sentence(findings.movements)
                            : "There is no baseline: nothing is compared with earlier figures.";
  const std::vector<HeadlineLine> lines = headline_lines(assessed.cases, assessed.problems);
  reports::GateDocument document{
      .title = assessed.definition.title,
      .verdict = verdict_text(assessed, lines, findings.status),
      .entries = {},
      .standings = headline_table(lines),
      .basis = rows_text(assessed) + (changes.empty() ? "" : " " + changes),
      .speed = speed_sentence(assessed.cases),
      .exit_status = findings.status,
      .inconclusive_passes = findings.inconclusive_passes};
  for (const CaseAssessment& one : assessed.cases) {
    if (!one.doubts.empty()) document.doubts[one.definition.name] = one.doubts;
    for (const GateOutcome& outcome : one.gate)
      document.entries.push_back(entry_of(one, outcome, findings, source));
    for (const auto& [run, status] : one.runs.status)
      add_open_run(one.definition.name, "run " + run, status, document);
  }
  for (const ProblemAssessment& one : assessed.problems) {
    for (const ProblemGateOutcome& outcome : one.gate)
      document.entries.push_back(entry_of(one, outcome, findings, source));
    add_open_run(one.definition.name, "the problem", one.run.status, document);
  }
  for (const RowMovement& one : findings.movements)
    if (one.lost()) document.entries.push_back(entry_of(one));
  add_bare_verdict(assessed.definition.name, findings, document);
  return document;
}

void write_gate_files(const reports::GateDocument& document, const fs::path& directory) {
  const auto write = [&](const char* name, const std::string& text) {
    replace_own(directory / name, text);
  };
  write(junit_name, reports::junit_xml(document));
  write(gate_page_name, reports::gate_markdown(document));
}

}  // namespace slosh
