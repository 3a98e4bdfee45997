// The ledgers of the shipped campaigns: each row that they hold is one that the campaign has, so
// that no gate on a shipped campaign ends with a lost row.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::shipped_ledgers_test {
namespace {

namespace fs = std::filesystem;

const fs::path verification = fs::path(SLOSH_SOURCE_DIR) / "verification";

// Every row without a value, as none is computed here.
std::vector<CaseAssessment> assessments_of(const CampaignDefinition& campaign) {
  std::vector<CaseAssessment> cases;
  for (const fs::path& file : campaign.cases) {
    CaseAssessment one{read_case(file), {}, {}, {}, {}};
    for (const GateRow& row : one.definition.gate)
      one.gate.push_back({row, Verdict::not_compared, {not_a_number, not_a_number}, ""});
    cases.push_back(std::move(one));
  }
  return cases;
}

std::vector<ProblemAssessment> problems_of(const CampaignDefinition& campaign) {
  std::vector<ProblemAssessment> problems;
  for (const ProblemDefinition& definition : campaign.problems) {
    ProblemAssessment one{definition, {}, {}};
    for (const ProblemGateRow& row : definition.gate)
      one.gate.push_back({row, Verdict::not_compared, not_a_number, ""});
    problems.push_back(std::move(one));
  }
  return problems;
}

// The text with the numbers of one line half as large again, or without the line.
std::string without_line(const std::vector<std::string>& lines, std::size_t changed, bool scaled) {
  static const std::regex number("([=\\[, ])(-?[0-9.]+(e-?[0-9]+)?)(?=[,\\] \n]|$)");
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line = lines[i];
    if (i == changed && !scaled) continue;
    std::smatch found;
    if (i == changed && std::regex_search(line, found, number)) {
      const std::string digits = found[2];
      const bool is_whole = digits.find_first_of(".e") == digits.npos;
      line = found.prefix().str() + found[1].str() +
             (is_whole ? std::to_string(std::stol(digits) + 1)
                       : fmt::format("{}", 1.5 * std::stod(digits) + 1e-3)) +
             found.suffix().str();
    }
    text += line + "\n";
  }
  return text;
}

struct ReadCase {
  std::vector<CaseAssessment> assessed;
  std::set<std::string> settings;  // of its runs
};

ReadCase read(const fs::path& file) {
  ReadCase one{{{read_case(file), {}, {}, {}, {}}}, {}};
  for (const GateRow& row : one.assessed[0].definition.gate)
    one.assessed[0].gate.push_back({row, Verdict::not_compared, {not_a_number, not_a_number}, ""});
  for (const RunDefinition& run : one.assessed[0].definition.runs)
    one.settings.insert(run.name + hashed_settings(run).dump());
  return one;
}

// Words, what says which form of a campaign has a run, what has this value without a key, and the
// scale of a record that is not supplied.
bool may_change(const std::string& line) {
  static const std::regex words(
      "^ *(#.*|\\[.*|title.*|source.*|reason.*|limits\\.[a-z_]+\\.(reason|source).*|tags.*|"
      "quick.*|schema_version.*|quantity.*|scale.*|)$");
  return std::regex_match(line, words);
}

// Every line of a case is changed and left out in turn. The case is refused, the key of a result
// is another, or a row tells the change.
TEST(ShippedLedgers, TellAChangeOfEveryKeyOfACase) {
  const TemporaryDirectory temporary;
  fs::copy(verification / "cases", temporary.path(), fs::copy_options::recursive);
  std::size_t told = 0;
  for (const char* name :
       {"li2010_small_amplitude", "zhao2021_mild_roll", "spheric10_water", "dam_break_lobovsky"}) {
    const fs::path file = temporary.path() / (std::string(name) + ".toml");
    const ReadCase whole = read(file);
    Baseline before;
    for (const RowMovement& one : movements({}, {whole.assessed, {}}))
      before[one.row] = one.after.value();
    std::vector<std::string> lines;
    std::ifstream text(file);
    for (std::string line; std::getline(text, line);)
      lines.push_back(line.substr(0, line.find("  #")));
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const bool scaled : {false, true}) {
        const std::string changed = without_line(lines, i, scaled);
        if (may_change(lines[i]) || (scaled && changed == without_line(lines, lines.size(), false)))
          continue;
        std::ofstream(file) << changed;
        try {
          const ReadCase other = read(file);
          const auto moved = movements(before, {other.assessed, {}});
          const bool is_told = other.settings != whole.settings ||
                               std::any_of(moved.begin(), moved.end(),
                                           [](const auto& one) { return one.has_changed(); });
          EXPECT_TRUE(is_told) << name << ":" << i + 1 << ": " << lines[i];
          told += is_told;
        } catch (const CaseFileError&) {  // no case any more
        }
      }
  }
  EXPECT_GT(told, 200U);
}

TEST(ShippedLedgers, HoldNoRowThatTheirCampaignHasLost) {
  std::size_t rows = 0;
  for (const auto& entry : fs::directory_iterator(verification / "campaigns")) {
    if (entry.path().extension() != ".toml") continue;
    const CampaignDefinition campaign =
        read_campaign(entry.path(), verification / "cases", known_problems());
    const std::vector<CaseAssessment> cases = assessments_of(campaign);
    const std::vector<ProblemAssessment> problems = problems_of(campaign);
    for (const char* form : {"", "-quick"}) {
      const fs::path ledger = verification / "baselines" / (campaign.name + form + ".jsonl");
      const Baseline baseline = baseline_of(read_ledger(ledger));
      rows += baseline.size();
      for (const RowMovement& one : movements(baseline, {cases, problems}))
        EXPECT_FALSE(one.lost()) << ledger.filename() << ": " << one.row;
    }
  }
  EXPECT_GT(rows, 500U);
}

}  // namespace
}  // namespace slosh::shipped_ledgers_test
