#include "verification/baseline/gate_history.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/result_error.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const CampaignState& state) {
  Json rows = Json::array();
  for (const auto& [row, judged] : state.rows)
    rows.push_back({{"row", row}, {"holds", judged.holds}, {"value", json_of(judged.value)}});
  return {{"when_utc", state.when_utc}, {"rows", rows}, {"results", state.results}};
}

CampaignState state_from(const Json& line) {
  CampaignState state{line.at("when_utc"), {}, line.at("results")};
  for (const Json& row : line.at("rows"))
    state.rows[row.at("row")] = {value_from(row.at("value")), row.at("holds")};
  return state;
}

}  // namespace

CampaignState state_of(const std::vector<CaseAssessment>& cases, const std::string& when_utc) {
  CampaignState state{when_utc, {}, {}};
  for (const CaseAssessment& one : cases) {
    for (const GateOutcome& outcome : one.gate)
      if (const auto value = baseline_value(outcome); value && is_judged(outcome.verdict))
        state.rows[row_name(one.definition.name, outcome.row)] = {*value,
                                                                  outcome.verdict == Verdict::pass};
    for (const auto& [run, result] : one.runs.results)
      state.results[one.definition.name + "/" + run] = result.key;
  }
  return state;
}

std::vector<CampaignState> read_history(const fs::path& file) {
  std::vector<CampaignState> states;
  if (!fs::exists(file)) return states;
  try {
    std::istringstream lines(read_bytes(file));
    for (std::string line; std::getline(lines, line);)
      states.push_back(state_from(parsed_json<Json>(line)));
  } catch (const Json::exception& error) {
    throw ResultError(fmt::format("{}:{}: not a line of a campaign's history: {}", file.string(),
                                  states.size() + 1, error.what()));
  } catch (const fs::filesystem_error& error) {
    throw ResultError(error.what());
  }
  return states;
}

void append_state(const CampaignState& state, const fs::path& file) {
  try {
    const FileLock alone(file.native() + ".lock");
    const std::vector<CampaignState> known = read_history(file);
    if (!known.empty() && known.back().rows == state.rows && known.back().results == state.results)
      return;
    const std::string before = fs::exists(file) ? read_bytes(file) : "";
    replace_file(file, before + json_of(state).dump() + "\n", Durability::process_crash);
  } catch (const fs::filesystem_error& error) {
    throw ResultError(error.what());
  }
}

}  // namespace slosh
