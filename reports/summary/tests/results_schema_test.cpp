// results.json against the schema that is published for it, by a validator that others use.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "reports/summary/results_json.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::results_schema_test {
namespace {

using nlohmann::json;

json published_schema() {
  std::ifstream stream(SLOSH_SOURCE_DIR "/reports/results.schema.json");
  return json::parse(stream);
}

// What the validator says of the document, one line a complaint; empty where it keeps to the
// schema.
std::string complaints(const json& document) {
  const json text = published_schema();
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(text), schema);
  valijson::ValidationResults results;
  valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(document),
                                 &results);
  std::string told;
  for (valijson::ValidationResults::Error error; results.popError(error);) {
    for (const std::string& place : error.context) told += place;
    told += ": " + error.description + "\n";
  }
  return told;
}

// A campaign of everything that a row and a run can come to.
json whole_document() {
  TimeSeries broken = elevation_of({});
  broken.value[250] = std::numeric_limits<double>::quiet_NaN();
  CaseDefinition bounded = surge_case();
  bounded.gate[0].limit.reset();
  bounded.gate[0].between = {-0.1, 0.1};
  bounded.gate[1].limit.reset();
  bounded.gate[1].improves_on = "particles";
  bounded.gate[1].candidate = "coarse_mesh";
  bounded.gate[1].reference = "theory_with_gas";
  const ProblemGateRow order{"velocity", ProblemMetric::order_at_least, "1", 1.9, {}, "a", "b", {}};
  ProblemRun run{{RunState::finished, ""}, ProblemResult{}};
  run.result->outcome.measures = {{"velocity", {{0.1, 0.01}, {0.05, 0.0025}}}, {"none", {}}};
  run.result->provenance = {{"command", "./slosh run"}};
  const RunFailure failure{"killed", "out of memory", "step 7", "fine_mesh.log"};
  const ProblemRun failed{{RunState::failed, "killed", failure}, {}};
  CaseRuns diverged = surge_runs_without("fine_mesh", RunState::failed, "diverged");
  diverged.status.at("fine_mesh").failure = failure;
  return json::parse(results_json(
      "surges", true,
      {assess(surge_case(), surge_runs()), assess(bounded, surge_runs()),
       assess(surge_case(), surge_runs_with("particles", broken)), assess(surge_case(), diverged),
       assess(surge_case(), surge_runs_without("theory", RunState::not_supplied, "nowhere"))},
      {assess(ProblemDefinition{"rigid_rotation", {order}}, run),
       assess(ProblemDefinition{"taylor_green", {order}}, failed)},
      "li2010"));
}

TEST(ResultsSchema, IsKeptToByEveryKindOfOutcomeAndByACampaignOfNothing) {
  EXPECT_EQ(complaints(whole_document()), "");
  EXPECT_EQ(complaints(json::parse(results_json("empty", false, {}))), "");
}

TEST(ResultsSchema, RefusesADocumentWithoutAnyOneOfItsKeys) {
  const json whole = whole_document();
  for (const char* place :
       {"/schema", "/schema_version", "/campaign", "/exit_status", "/verdict_matrix/0/verdict",
        "/problem_matrix/0/metric", "/model_bias/0/bias", "/model_bias/0/comparisons/0/predicted",
        "/cases/0/name", "/cases/0/runs/0/state", "/cases/0/gate/0/value",
        "/cases/0/gate/0/uncertainty_95/all", "/cases/0/comparisons/0/modes/0/phase_lag_deg/value",
        "/problems/0/measures/0/errors/0/step", "/problems/0/gate/0/verdict", "/claims/0/number",
        "/claims/0/verdict"}) {
    const json::json_pointer pointer(place);
    json cut = whole;
    ASSERT_TRUE(cut.contains(pointer)) << place;
    cut.at(pointer.parent_pointer()).erase(pointer.back());
    EXPECT_NE(complaints(cut), "") << place;
  }
}

TEST(ResultsSchema, RefusesAValueOfAnotherTypeAndAKeyThatItDoesNotKnow) {
  const json whole = whole_document();
  const std::pair<const char*, json> wrong[] = {{"/schema_version", 2},
                                                {"/quick", "yes"},
                                                {"/exit_status", 0.5},
                                                {"/cases/0/gate/0/verdict", "perhaps"},
                                                {"/cases/0/gate/0/value", "0.01"},
                                                {"/cases/0/gate/0/line", 1.5},
                                                {"/cases/0/gate/0/between", json::array({1})},
                                                {"/model_bias/0/comparisons/0/predicted", -1},
                                                {"/cases/0/runs", json::object()},
                                                {"/cases/0/gate/0/tolerence", 1},
                                                {"/cases/0/gate/0/value", nullptr}};
  for (const auto& [place, value] : wrong) {
    json changed = whole;
    changed[json::json_pointer(place)] = value;
    EXPECT_EQ(complaints(changed) == "", value.is_null()) << place;
  }
}

}  // namespace
}  // namespace slosh::results_schema_test
