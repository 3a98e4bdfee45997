// What a program says in its log makes its run a failure, wherever in a line it says it.
#include "verification/solvers/external_facts.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "verification/input/case_file_error.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/solvers/external_program.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::external_facts_test {
namespace {

std::string failure(const std::string& log) try {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "log") << log;
  require_no_match({"NaN"}, directory.path() / "log");
  return "";
} catch (const SolverError& error) {
  return error.what();
}

std::string progress(const char* end) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "progress " + std::to_string(i) + end;
  return text;
}

TEST(RequireNoMatch, LooksAtTheWholeOfALongLine) {
  EXPECT_EQ(failure(progress("\r") + "\nall is well\n"), "");
  EXPECT_TRUE(holds(failure(progress("\r") + "NaN detected\n"), "line 1 of its log"));
  EXPECT_TRUE(holds(failure(progress(" ") + "NaN detected\n"), "line 1 of its log"));
}

// A text that lies across the border of two pieces of a line is found.
TEST(RequireNoMatch, FindsATextAnywhereInALine) {
  for (const int before : {58981, 58982, 65533, 65534, 65535, 65536, 131072})
    EXPECT_NE(failure(std::string(before, 'x') + "NaN" + std::string(9000, 'x') + "\n"), "");
}

TEST(RequireNoMatch, QuotesTheEndOfALongLineAlone) {
  EXPECT_LT(failure(progress(" ") + "NaN\n").size(), 1000u);
}

// What an external program tells of its run: what is taken, what stays unknown and what is refused.

const RunCost took_ten_seconds{.wall_time = 10, .user_time = 8, .system_time = 2};

RunResult told(const std::string& text) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "cost.json") << text;
  RunResult result;
  add_external_facts(directory.path() / "cost.json", took_ten_seconds, result);
  return result;
}

std::string complaint(const std::string& text) {
  return message_of<CaseFileError>([&] { told(text); });
}

TEST(ExternalFacts, AreCountsOfTheCostAndDiagnostics) {
  const RunResult result = told(
      R"({"schema_version": 1, "liquid_particles": 3500, "wall_particles": 912, "steps": 62715,
          "speed_of_sound_m_s": 18.53, "smoothing_length_ratio": 1.3, "loop_wall_time_s": 530.5,
          "loop_processor_time_s": 505})");
  EXPECT_EQ(result.cost.elements, 3500);
  EXPECT_EQ(result.cost.steps, 62715);
  EXPECT_EQ(result.diagnostics, (std::map<std::string, double>{{"wall_particles", 912},
                                                               {"speed_of_sound_m_s", 18.53},
                                                               {"smoothing_length_ratio", 1.3},
                                                               {"loop_wall_time_s", 530.5},
                                                               {"loop_processor_time_s", 505}}));
}

TEST(ExternalFacts, CountTheTimesOfCompilingApart) {
  const RunResult result =
      told(R"({"schema_version": 1, "compile_wall_time_s": 4, "compile_processor_time_s": 3})");
  EXPECT_EQ(result.cost.wall_time, 4);
  EXPECT_EQ(result.cost.user_time + result.cost.system_time, 3);
  EXPECT_EQ(result.diagnostics.at("compile_wall_time_s"), 4);
  EXPECT_EQ(result.diagnostics.at("compile_processor_time_s"), 3);
}

TEST(ExternalFacts, RefuseACompilationThatTookLongerThanTheProgram) {
  for (const char* key : {"compile_wall_time_s", "compile_processor_time_s"})
    EXPECT_TRUE(holds(complaint(std::string("{\"schema_version\": 1, \"") + key + "\": 11}"),
                      std::string(key) + " = 11: expected at most the 10 s that the program took"));
}

TEST(ExternalFacts, StayUnknownWhereTheProgramDoesNotKnowThem) {
  const RunResult result = told(R"({"schema_version": 1, "steps": null, "wall_particles": 0})");
  EXPECT_EQ(result.cost.steps, 0);
  EXPECT_EQ(result.cost.elements, 0);
  EXPECT_EQ(result.diagnostics, (std::map<std::string, double>{{"wall_particles", 0}}));
}

TEST(ExternalFacts, AreRefusedByTheKeyThatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> texts{
      {R"({"schema_version": 1, "steps": 0})", "steps = 0: expected an integer > 0, or null"},
      {R"({"schema_version": 1, "steps": 1.5})", "steps = 1.5: expected an integer > 0"},
      {R"({"schema_version": 1, "steps": "9"})", "steps = \"9\": expected an integer > 0"},
      {R"({"schema_version": 1, "wall_particles": -1})",
       "wall_particles = -1: expected an integer >= 0"},
      {R"({"schema_version": 1, "speed_of_sound_m_s": 0})",
       "speed_of_sound_m_s = 0: expected a number > 0"},
      {R"({"schema_version": 1, "step": 9})", "step = 9: expected only these keys: schema_version"},
      {R"({"schema_version": 1, "step": 9})", "nearest: steps"},
      {R"({"schema_version": 1, "steps": 9, "steps": 8})", "steps: expected each key once"},
      {R"({"schema_version": 2})", "schema_version = 2: expected 1"},
      {R"({"steps": 9})", "schema_version = (missing): expected 1"},
      {"[1]", "expected a JSON object"},
      {R"({"schema_version": 1)", "not JSON: "},
      {"", "not JSON: "}};
  for (const auto& [text, wanted] : texts) {
    const std::string said = complaint(text);
    EXPECT_TRUE(holds(said, "cost.json: "));
    EXPECT_TRUE(holds(said, wanted));
  }
  RunResult result;
  EXPECT_THROW(add_external_facts("/none/cost.json", took_ten_seconds, result), CaseFileError);
}

const std::string origin =
    R"({"schema_version": 1, "software": "their SPH 5.4", "date": "2026-11-22",
        "machine": "one core", "processor_time_s": 776)";

RunResult stored(const std::string& rest, double duration) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "cost.json") << origin << rest << "}";
  RunResult result;
  add_stored_facts(directory.path() / "cost.json", duration, result);
  return result;
}

std::string complaint_of_stored(const std::string& text) {
  return message_of<CaseFileError>([&] {
    const TemporaryDirectory directory;
    std::ofstream(directory.path() / "cost.json") << text;
    RunResult result;
    add_stored_facts(directory.path() / "cost.json", 2, result);
  });
}

TEST(FactsOfAStoredResult, SayWhichCodeRanWhenWhereAndAtWhatCost) {
  const RunResult result = stored(
      R"(, "simulated_time_s": 10, "wall_time_s": 800, "liquid_particles": 3500, "steps": 107691,
          "wall_particles": 924, "speed_of_sound_m_s": 37)",
      10);
  EXPECT_EQ(result.provenance,
            (std::map<std::string, std::string>{{"stored_software", "their SPH 5.4"},
                                                {"stored_date", "2026-11-22"},
                                                {"stored_machine", "one core"}}));
  EXPECT_DOUBLE_EQ(result.cost.user_time + result.cost.system_time, 776);
  EXPECT_DOUBLE_EQ(result.cost.wall_time, 800);
  EXPECT_EQ(result.cost.elements, 3500);
  EXPECT_EQ(result.cost.steps, 107691);
  EXPECT_EQ(result.diagnostics,
            (std::map<std::string, double>{{"wall_particles", 924}, {"speed_of_sound_m_s", 37}}));
}

// A run that went on longer is counted by its share.
TEST(FactsOfAStoredResult, CountTheShareOfARunThatWentOn) {
  const RunResult result = stored(
      R"(, "simulated_time_s": 10, "liquid_particles": 3500, "steps": 1001,
          "loop_processor_time_s": 700, "smoothing_length_ratio": 1.7)",
      2);
  EXPECT_DOUBLE_EQ(result.cost.user_time, 776.0 / 5);
  EXPECT_EQ(result.cost.steps, 200) << "whole steps";
  EXPECT_EQ(result.cost.elements, 3500);
  EXPECT_DOUBLE_EQ(result.diagnostics.at("loop_processor_time_s"), 140);
  EXPECT_DOUBLE_EQ(result.diagnostics.at("smoothing_length_ratio"), 1.7);
}

TEST(FactsOfAStoredResult, AreRefusedByTheKeyThatIsWrong) {
  const std::string long_enough = R"(, "simulated_time_s": 10)";
  const std::vector<std::pair<std::string, std::string>> texts{
      {R"({"schema_version": 1})", "software = (missing): expected a text"},
      {R"({"schema_version": 1, "software": 5})", "software = 5: expected a text"},
      {R"({"schema_version": 1, "software": ""})", "software = \"\": expected a text"},
      {origin + "}", "simulated_time_s = (missing): expected a number > 0"},
      {origin + R"(, "simulated_time_s": 1.5})",
       "simulated_time_s = 1.5: expected at least the case's 2 s"},
      {origin + R"(, "simulated_time_s": 0})", "simulated_time_s = 0: expected a number > 0"},
      {origin + long_enough + R"(, "compile_wall_time_s": 1})",
       "compile_wall_time_s = 1: expected only these keys"},
      {origin + long_enough + R"(, "steps": 1.5})", "steps = 1.5: expected an integer > 0"}};
  for (const auto& [text, wanted] : texts) {
    const std::string said = complaint_of_stored(text);
    EXPECT_TRUE(holds(said, "cost.json: " + wanted)) << said << "\nwanted: " << wanted;
  }
}

TEST(ExternalFacts, AreThoseOfThePublishedSchema) {
  std::ifstream stream(SLOSH_SOURCE_DIR "/verification/solvers/external_facts.schema.json");
  const nlohmann::json properties = nlohmann::json::parse(stream).at("properties");
  EXPECT_EQ(properties.size(), external_facts().size() + 1) << "and the version";
  for (const ExternalFact& fact : external_facts()) {
    const auto& property = properties.at(fact.name);
    EXPECT_EQ(property.at("description"), fact.meaning);
    EXPECT_EQ(property.at("type"), nlohmann::json({fact.is_count ? "integer" : "number", "null"}));
    EXPECT_EQ(property.at(fact.may_be_zero ? "minimum" : "exclusiveMinimum"), 0) << fact.name;
  }
}

TEST(ExternalFacts, RefuseANumberBeyondWhatADoubleHolds) {
  EXPECT_TRUE(holds(complaint(R"({"schema_version": 1, "steps": 1e999})"), "cost.json: not JSON"));
}

}  // namespace
}  // namespace slosh::external_facts_test
