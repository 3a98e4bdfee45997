#include "verification/cli/campaign/gate_files.hpp"

#include <algorithm>
#include <stdexcept>

#include "reports/summary/campaign_report.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using reports::GateOutcomeKind;

constexpr const char *junit_name = "junit.xml", *markdown_name = "gate.md";

GateOutcomeKind kind_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return GateOutcomeKind::pass;
    case Verdict::violated:
      return GateOutcomeKind::violated;
    case Verdict::inconclusive:
      return GateOutcomeKind::inconclusive;
    case Verdict::solver_failed:
      return GateOutcomeKind::solver_failed;
    case Verdict::not_compared:
      return GateOutcomeKind::not_compared;
    case Verdict::not_selected:
    case Verdict::not_supplied:
      return GateOutcomeKind::skipped;
  }
  throw std::logic_error("a verdict without a kind");
}

// The path that a code forge knows the file by: relative to the source tree, or to the current
// directory, whichever it lies below; for a case of another repository that is the latter.
std::string path_in_repository(const fs::path& source, const fs::path& file) {
  for (const fs::path& root : {source, fs::current_path()}) {
    const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(root);
    if (!relative.empty() && *relative.begin() != "..") return relative.string();
  }
  return file.string();
}

// Fills in what rows of cases and of problems have in common: all but the name, the value and the
// change since the baseline.
template <class Outcome>
reports::GateEntry entry_in(const std::string& group, const Outcome& outcome,
                            const fs::path& source) {
  return {.outcome = kind_of(outcome.verdict),
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

reports::GateEntry entry_of(const CaseAssessment& assessment, const GateOutcome& outcome,
                            const std::vector<RowMovement>& movements, const fs::path& source) {
  const std::string& group = assessment.definition.name;
  reports::GateEntry entry = entry_in(group, outcome, source);
  entry.name = row_name(outcome.row);
  entry.value = outcome.value.value;
  entry.uncertainty = outcome.value.half_width;
  if (outcome.judgement)
    entry.uncertainties = uncertainties_text(*outcome.judgement, outcome.row.unit);
  const auto moved = std::find_if(movements.begin(), movements.end(), [&](const RowMovement& one) {
    return one.row == row_name(group, outcome.row);
  });
  if (moved == movements.end()) return entry;
  if (moved->after) {
    entry.lower = moved->after->lower;
    entry.upper = moved->after->upper;
  }
  if (moved->before) entry.moved = movement_text(*moved);
  entry.loosened = moved->loosened;
  return entry;
}

reports::GateEntry entry_of(const ProblemAssessment& assessment, const ProblemGateOutcome& outcome,
                            const fs::path& source) {
  reports::GateEntry entry = entry_in(assessment.definition.name, outcome, source);
  entry.name = metric_name(outcome.row.metric) + " of " + outcome.row.measure;
  entry.value = outcome.value;
  return entry;
}

}  // namespace

reports::GateDocument gate_document(const AssessedCampaign& assessed,
                                    const std::vector<RowMovement>& movements,
                                    const fs::path& source) {
  reports::GateDocument document{
      .title = assessed.definition.title,
      .verdict = headline_word(exit_status(assessed.cases, assessed.problems)) + ": " +
                 verdict_sentence(assessed.cases, assessed.problems) +
                 coverage_sentence(assessed.cases),
      .entries = {},
      .basis = kinds_sentence(assessed.cases, assessed.problems)};
  for (const CaseAssessment& one : assessed.cases)
    for (const GateOutcome& outcome : one.gate)
      document.entries.push_back(entry_of(one, outcome, movements, source));
  for (const ProblemAssessment& one : assessed.problems)
    for (const ProblemGateOutcome& outcome : one.gate)
      document.entries.push_back(entry_of(one, outcome, source));
  return document;
}

void require_gate_places(const fs::path& directory) {
  for (const char* name : {junit_name, markdown_name}) require_no_input(directory / name);
}

void write_gate_files(const reports::GateDocument& document, const fs::path& directory) {
  const auto write = [&](const char* name, const std::string& text) {
    replace_file(directory / name, text, Durability::process_crash);
  };
  write(junit_name, reports::junit_xml(document));
  write(markdown_name, reports::gate_markdown(document));
}

}  // namespace slosh
