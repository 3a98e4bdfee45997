// The table of keys is right about which keys are required, and the shipped reference is generated
// from it.
#include "verification/case_file/key_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "verification/case_file/made_cases.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::key_table_test {
namespace {

const KeyEntry& entry(const std::string& table_id, const std::string& key) {
  for (const KeyTable& table : case_key_tables())
    if (table.id == table_id)
      for (const KeyEntry& one : table.keys)
        if (one.name == key) return one;
  throw std::logic_error("no key " + key + " in " + table_id);
}

// Returns the id of the table that a line of the trial case opens, "" for any other line.
std::string opened_table(const std::string& line) {
  const std::size_t begin = line.find_first_not_of('['), end = line.find(']');
  if (begin == 0 || end == std::string::npos) return "";
  const std::string name = line.substr(begin, end - begin);
  return name.substr(name.find('.') + 1);
}

std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }

// The trial case with optional keys and tables.
const std::string full_text =
    with_keys(valid_text,
              "motion.surge.ramp_periods = 1 & run(theory).two_layer = true & "
              "run(mesh).processes = 2 & run(mesh).courant_number = 0.4 & "
              "run(mesh).interface_courant_number = 0.3 & run(mesh).outer_corrections = 2 & "
              "run(mesh).no_slip = true & gate.kind = \"validation\" & "
              "run(coarse).variant = \"any\" & run(coarse).initial_state = \"settled\" & "
              "run(coarse).artificial_viscosity = 0.1 & run(coarse).start_disorder = 0.1 & "
              "run(coarse).smoothing_length_ratio = 2 & run(coarse).sound_speed_ratio = 20 & "
              "run(coarse).courant_number = 0.4 & run(coarse).density_diffusion = 0.1 & "
              "run(coarse).energy_budget = true") +
    R"([[pressure_gauge]]
name = "b"
wall = "left"
position_m = 0.4
width_m = 0.01
filter_cutoff_Hz = 10
[[probe]]
name = "p"
x_m = 1.5
z_m = 0.2
[[obstacle]]
name = "baffle"
left_m = 0.9
right_m = 1.1
bottom_m = 0.0
top_m = 0.2
[impacts]
gauge = "b"
times_s = [2.375, 4.073]
period_s = 1.6
peaks_Pa = [3710, 4816]
peaks_sd_Pa = [732, 1501]
plateau_begin_s = 2.45
plateau_end_s = 2.65
plateau_Pa = 670
arrival_share = 0.3
arrivals_s = [2.37, 4.06]
arrivals_half_width_s = 0.01
source = "a paper"
)";

struct Line {
  std::string table, text;
  int number;
};

// Returns the lines "key = value" of the trial case, each with the id of its table; in a run, that
// of its solver if the solver has the key.
std::vector<Line> assignments() {
  std::vector<Line> lines;
  std::istringstream text(full_text);
  std::string table = "case", solver_table;
  int number = 0;
  for (std::string line; std::getline(text, line); ++number) {
    if (const std::string opened = opened_table(line); !opened.empty()) {
      table = solver_table = opened;
    } else {
      if (key_of(line) == "solver") {
        const std::size_t quote = line.find('"') + 1;
        solver_table = "run." + line.substr(quote, line.size() - 1 - quote);
      }
      const std::vector<std::string> common = keys_of(table);
      const bool is_common = std::count(common.begin(), common.end(), key_of(line)) > 0;
      lines.push_back({is_common ? table : solver_table, line, number});
    }
  }
  return lines;
}

// The case with other text in place of a line.
std::string with_line(int number, const std::string& other) {
  std::istringstream text(full_text);
  std::string edited;
  int i = 0;
  for (std::string line; std::getline(text, line); ++i) edited += i == number ? other : line + "\n";
  return edited;
}

TEST(KeyTable, SaysOfEachKeyWhetherACaseCanBeWithoutIt) {
  const Workspace workspace;
  int required = 0, optional = 0;
  for (const Line& line : assignments()) {
    const std::string needed = entry(line.table, key_of(line.text)).needed.words;
    const std::string found = complaint(workspace.write("trial.toml", with_line(line.number, "")));
    const bool is_optional = needed == "no";
    EXPECT_EQ(found.empty(), is_optional)
        << line.table << "." << line.text << " is needed: " << needed << "; " << found;
    ++(is_optional ? optional : required);
  }
  EXPECT_GE(required, 60);
  EXPECT_GE(optional, 20);
}

// Numbers beyond the bounds of a key that are numbers themselves.
std::vector<std::string> beyond(const KeyValue& value) {
  std::vector<std::string> numbers;
  const auto add = [&](const std::optional<KeyValue::End>& end, double step) {
    if (end && end->bound.name.empty())
      numbers.push_back(fmt::format("{}", end->bound.value + (end->included ? step : 0)));
  };
  add(value.lower, -1);
  add(value.upper, 1);
  return numbers;
}

// Values of other types than that of a key.
std::vector<std::string> mistaken(KeyKind kind) {
  switch (kind) {
    case KeyKind::number:
      return {"\"2\"", "true", "nan", "inf", "[1.0]", "1979-05-27"};
    case KeyKind::integer:
      return {"\"2\"", "true", "3.0", "5000000000", "1979-05-27"};
    case KeyKind::text:
    case KeyKind::name:
    case KeyKind::choice:
      return {"3", "true", "\"\"", "1979-05-27"};
    case KeyKind::list:
    case KeyKind::numbers:
    case KeyKind::increasing_numbers:
      return {"\"a\"", "3", "[true]"};
    default:
      return {"\"yes\"", "3", "1979-05-27"};
  }
}

TEST(KeyTable, RefusesAValueOfAnotherTypeOrBeyondItsBoundsAtEachKey) {
  const Workspace workspace;
  for (const Line& line : assignments()) {
    const std::string key = key_of(line.text),
                      place = "trial.toml:" + std::to_string(line.number + 1);
    const KeyValue& is = entry(line.table, key).value;
    std::vector<std::string> values = mistaken(is.kind);
    if (is.kind == KeyKind::number || is.kind == KeyKind::integer)
      std::ranges::move(beyond(is), std::back_inserter(values));
    for (const std::string& value : values) {
      const std::string found = complaint(
          workspace.write("trial.toml", with_line(line.number, key + " = " + value + "\n")));
      EXPECT_TRUE(found.starts_with(place + ": ") && found.find(key + " = ") != found.npos &&
                  found.find(": expected ") != found.npos)
          << line.table << "." << key << " = " << value << ": " << found;
    }
  }
}

TEST(KeyTable, NamesEachKeyOfATableOnceAndSaysWhatItHolds) {
  for (const auto* tables : {&case_key_tables(), &campaign_key_tables()})
    for (const KeyTable& table : *tables) {
      std::set<std::string> names;
      for (const KeyEntry& key : table.keys) {
        EXPECT_TRUE(names.insert(key.name).second) << table.id << "." << key.name;
        EXPECT_FALSE(key.value.words().empty() || key.needed.words.empty())
            << table.id << "." << key.name;
      }
    }
}

TEST(KeyTable, ThatDoesNotExistHasNoKeys) { EXPECT_THROW(keys_of("tankk"), std::logic_error); }

// A new case that is made from another one can be read, and its keys are explained.

const std::filesystem::path cases = SLOSH_SOURCE_DIR "/verification/cases";

CaseDefinition shipped(const std::string& name) { return read_case(cases / (name + ".toml")); }

TEST(CommentedCase, CanBeReadWhateverShippedCaseItIsLike) {
  const Workspace workspace;
  int made = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition like = read_case(entry.path());
    const std::filesystem::path file = workspace.write("new.toml", commented_case(like, "my_tank"));
    ASSERT_EQ(complaint(file), "") << entry.path();
    const CaseDefinition read = read_case(file);
    EXPECT_EQ(read.name, "my_tank");
    EXPECT_EQ(read.tank.length, like.tank.length);
    EXPECT_EQ(read.gauges.size(), like.gauges.size());
    EXPECT_GE(read.runs.size(), 1u);
    ++made;
  }
  EXPECT_GE(made, 30);
}

// The shipped case has several spacings in one table, and its rows in groups.
TEST(CommentedCase, KeepsTheTheoriesAndTheCoarsestJudgedRunWithItsRows) {
  const std::string text = commented_case(shipped("li2010_small_amplitude"), "my_tank");
  const CaseDefinition read = read_text(text);
  std::vector<std::string> runs;
  for (const RunDefinition& run : read.runs) runs.push_back(run.name);
  EXPECT_EQ(runs, (std::vector<std::string>{"linear", "linear_two_layer", "recommended_10mm",
                                            "potential"}));
  for (const GateRow& row : read.gate) EXPECT_EQ(row.candidate, "recommended_10mm");
  EXPECT_GE(read.gate.size(), 1u);
  for (const char* line : {"\nname = \"recommended_10mm\"\n", "\nparticle_spacing_m = 0.01\n",
                           "\nquick = true\n", "\ncandidate = \"recommended_10mm\"\n"})
    EXPECT_TRUE(holds(text, line)) << line << "\nin\n" << text;
  EXPECT_FALSE(holds(text, "\ncandidates = "));
}

TEST(CommentedCase, ExplainsEachKeyOnceInTheWordsOfTheKeyTable) {
  const std::string text = commented_case(shipped("li2010_small_amplitude"), "my_tank");
  for (const char* line :
       {"# length_m: number > 0, m. The inner length.\nlength_m = 1.0\n",
        "# fill_depth_m: number > 0 and below the tank's height, m. The still depth.\n",
        "# Not here: breadth_m: number > 0, m. The inner breadth of a narrow tank",
        "# A tank, seen from the side: a rectangle, a polygon or a lying cylinder."})
    EXPECT_TRUE(holds(text, line)) << line << "\nin\n" << text;
  const std::string once = "# solver: text. The solver: one of the tables below.";
  EXPECT_EQ(text.find(once), text.rfind(once));
}

TEST(CommentedCase, RefusesANameThatNoCaseMayHaveAndACaseWithoutAnSphRun) {
  CaseDefinition like = shipped("still_water");
  EXPECT_THROW(commented_case(like, "my tank"), CaseFileError);
  like.runs.clear();
  EXPECT_THROW(commented_case(like, "my_tank"), CaseFileError);
}

}  // namespace
}  // namespace slosh::key_table_test
