#include <string>

#include "reports/gate_documents/gate_document.hpp"
#include "reports/model/file_formats.hpp"

namespace slosh::reports {

std::string outcome_word(GateOutcomeKind outcome) {
  switch (outcome) {
    case GateOutcomeKind::solver_failed:
      return "solver failed";
    case GateOutcomeKind::violated:
      return "violated";
    case GateOutcomeKind::not_compared:
      return "not compared";
    case GateOutcomeKind::inconclusive:
      return "inconclusive";
    case GateOutcomeKind::pass:
      return "pass";
    case GateOutcomeKind::skipped:
      return "skipped";
  }
  return "";
}

namespace {

std::string bound(const std::optional<double>& value) { return value ? csv_number(*value) : ""; }

}  // namespace

std::string gate_csv(const GateDocument& document) {
  std::string text =
      csv_line({"verdict", "kind", "case", "row", "value", "uncertainty_95", "lower", "upper",
                "unit", "found", "uncertainties", "since_the_baseline", "file", "line"});
  for (const GateEntry& entry : document.entries)
    text += csv_line({outcome_word(entry.outcome), entry.kind, entry.group, entry.name,
                      csv_number(entry.value), csv_number(entry.uncertainty), bound(entry.lower),
                      bound(entry.upper), entry.unit, entry.message, entry.uncertainties,
                      entry.moved, entry.file, std::to_string(entry.line)});
  return text;
}

}  // namespace slosh::reports
