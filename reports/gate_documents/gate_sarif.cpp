#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/gate_documents/gate_document.hpp"

namespace slosh::reports {
namespace {

using Json = nlohmann::ordered_json;

struct Rule {
  const char *id, *level, *text;
};

constexpr Rule violated{"tolerance-violated", "error", "A metric lies outside its tolerance."};
constexpr Rule not_compared{"not-compared", "error", "There was nothing to compare."};
constexpr Rule solver_failed{"solver-failed", "error", "A solver that the row rests on failed."};
constexpr Rule inconclusive{"inconclusive", "warning",
                            "The uncertainty of a metric reaches across its tolerance."};
constexpr Rule loosened{"tolerance-loosened", "warning",
                        "A tolerance is looser than the baseline's."};

Json rule_json(const Rule& rule) {
  return {{"id", rule.id},
          {"shortDescription", {{"text", rule.text}}},
          {"defaultConfiguration", {{"level", rule.level}}}};
}

// JSON has no NaN or infinity; null takes their place.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json result_json(const GateEntry& entry, const Rule& rule, const std::string& message) {
  return {{"ruleId", rule.id},
          {"level", rule.level},
          {"message", {{"text", entry.group + ": " + entry.name + ": " + message}}},
          {"locations",
           {{{"physicalLocation",
              {{"artifactLocation", {{"uri", entry.file}}},
               {"region", {{"startLine", entry.line}}}}}}}},
          {"properties",
           {{"value", number_or_null(entry.value)},
            {"uncertainty_95", number_or_null(entry.uncertainty)},
            {"unit", entry.unit}}}};
}

void add_results(const GateEntry& entry, Json& results) {
  switch (entry.outcome) {
    case GateOutcomeKind::violated:
      results.push_back(result_json(entry, violated, entry.message));
      break;
    case GateOutcomeKind::not_compared:
      results.push_back(result_json(entry, not_compared, entry.message));
      break;
    case GateOutcomeKind::solver_failed:
      results.push_back(result_json(entry, solver_failed, entry.message));
      break;
    case GateOutcomeKind::inconclusive:
      results.push_back(result_json(entry, inconclusive, entry.message));
      break;
    case GateOutcomeKind::pass:
    case GateOutcomeKind::skipped:
      break;
  }
  if (entry.loosened) results.push_back(result_json(entry, loosened, entry.moved));
}

}  // namespace

std::string gate_sarif(const GateDocument& document) {
  Json rules = Json::array(), results = Json::array();
  for (const Rule& rule : {violated, not_compared, solver_failed, inconclusive, loosened})
    rules.push_back(rule_json(rule));
  for (const GateEntry* entry : worst_first(document)) add_results(*entry, results);
  const Json driver{{"name", "Slosh"}, {"version", document.tool_version}, {"rules", rules}};
  const Json sarif{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                   {"version", "2.1.0"},
                   {"runs", {{{"tool", {{"driver", driver}}}, {"results", results}}}}};
  return sarif.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace slosh::reports
