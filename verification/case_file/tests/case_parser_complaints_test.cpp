// A case file with several mistakes: all of them are reported at once, and each of them only once.
#include <gtest/gtest.h>

#include "verification/input/case_file_error.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::case_parser_complaints_test {
namespace {

std::string with_edits(const std::vector<Edit>& edits) {
  std::string text = valid_text;
  for (const Edit& edit : edits) {
    const std::size_t at = text.find(edit.from);
    if (at == std::string::npos) throw std::logic_error("no such text: " + edit.from);
    text.replace(at, edit.from.size(), edit.to);
  }
  return text;
}

// The messages without the directory of the file, each up to what was expected.
std::vector<std::string> mistakes_in(const std::string& text) {
  const Workspace workspace;
  const std::string directory = workspace.path().string() + "/";
  std::vector<std::string> found;
  try {
    read_case(workspace.write("trial.toml", text));
  } catch (const CaseFileErrors& errors) {
    for (const std::string& message : errors.messages) {
      const std::size_t begin = message.starts_with(directory) ? directory.size() : 0;
      found.push_back(message.substr(begin, message.find(": expected") - begin));
    }
  }
  return found;
}

using Mistakes = std::vector<std::string>;

TEST(CaseParserComplaints, AreOfEverySectionAtOnce) {
  const Mistakes told = mistakes_in(with_edits({{"\"A trial\"", "3"},
                                                {"density_kg_m3 = 1.2", "density_kg_m3 = 1200.0"},
                                                {"x_m = 0.05", "x_m = 5.0"},
                                                {"window_end_s = 20.0", "window_end_s = 21.0"},
                                                {"modes = 500", "modes = 0"},
                                                {"cells_z = 40", "cell_z = 40"}}));
  EXPECT_EQ(told, (Mistakes{"trial.toml:3: title = 3", "trial.toml:15: gas.density_kg_m3 = 1200.0",
                            "trial.toml:30: gauge.x_m = 5.0",
                            "trial.toml:33: comparison.window_end_s = 21.0",
                            "trial.toml:38: run.modes = 0", "trial.toml:51: run.cell_z = 40"}));
}

TEST(CaseParserComplaints, AreOfEveryUnknownKeyOfATable) {
  EXPECT_EQ(mistakes_in(with_edits({{"length_m = 2\nheight_m", "lenght_m = 2\nhight_m"}})),
            (Mistakes{"trial.toml:9: tank.hight_m = 1.0", "trial.toml:8: tank.lenght_m = 2"}));
}

TEST(CaseParserComplaints, AreOfEveryWrongValueOfATable) {
  EXPECT_EQ(mistakes_in(with_edits({{"length_m = 2\nheight_m = 1.0", "length_m = -2\nheight_m = 0"},
                                    {"start = \"earth\"", "start = \"moon\""}})),
            (Mistakes{"trial.toml:8: tank.length_m = -2", "trial.toml:9: tank.height_m = 0",
                      "trial.toml:22: time.start = \"moon\""}));
  EXPECT_EQ(mistakes_in(with_edits({{"cells_x = 50\ncells_z = 40", "cells_x = 1\ncells_z = 0"},
                                    {"a reason", ""},
                                    {"\"a source\"", "4"}})),
            (Mistakes{"trial.toml:50: run.cells_x = 1", "trial.toml:51: run.cells_z = 0",
                      "trial.toml:60: gate.reason = \"\"", "trial.toml:61: gate.source = 4"}));
}

// The sample interval is not checked against a duration that could not be read.
TEST(CaseParserComplaints, AreNotOfAValueThatRestsOnAWrongOneOfItsTable) {
  EXPECT_EQ(mistakes_in(with_edits({{"duration_s = 20.0", "duration_s = 0"},
                                    {"sample_interval_s = 0.01", "sample_interval_s = 15"}})),
            Mistakes{"trial.toml:23: time.duration_s = 0"});
}

// The gauges, runs and gate rows depend on the tank; the time does not.
TEST(CaseParserComplaints, AreNotOfWhatRestsOnAnotherMistake) {
  EXPECT_EQ(mistakes_in(with_edits({{"length_m = 2", "length_m = -2"}, {"\"earth\"", "\"moon\""}})),
            (Mistakes{"trial.toml:8: tank.length_m = -2", "trial.toml:22: time.start = \"moon\""}));
  EXPECT_EQ(mistakes_in(with_edits({{"gravity_m_s2 = 9.81", "gravity_m_s2 = -9.81"}})),
            Mistakes{"trial.toml:6: gravity_m_s2 = -9.81"});
}

TEST(CaseParserComplaints, OfAMisspeltSectionDoNotCallItMissing) {
  EXPECT_EQ(mistakes_in(with_edits({{"[tank]", "[tnak]"}, {"title =", "titel ="}})),
            (Mistakes{"trial.toml:3: titel = \"A trial\"", "trial.toml:7: tnak = (a table)"}));
}

TEST(CaseParserComplaints, OfGaugesOrRunsThatCannotBeListedAreNotOfTheRowsThatNameThem) {
  const std::string gauges = "[[gauge]]\nname = \"right\"\nx_m = 1.95\n[[gauge]]";
  EXPECT_EQ(mistakes_in(with_edits({{gauges, "[gauge]"}})),
            Mistakes{"trial.toml:25: gauge = (a table)"});
  const std::size_t first = valid_text.find("[[run]]"), end = valid_text.find("[[gate]]");
  const std::string runs = valid_text.substr(first, end - first);
  EXPECT_EQ(mistakes_in(with_edits({{runs, ""}})), Mistakes{"trial.toml:1: run is missing"});
  EXPECT_EQ(
      mistakes_in(with_edits({{"schema_version = 1", "schema_version = 1\nrun = 3"}, {runs, ""}})),
      Mistakes{"trial.toml:2: run = 3"});
}

TEST(CaseParserComplaints, AreOfTheRowsOnRunsAndGaugesThatCouldBeReadAlone) {
  const std::string row = valid_text.substr(valid_text.find("[[gate]]"));
  const auto row_on = [&](const Edit& edit) {
    std::string text = row;
    text.replace(text.find(edit.from), edit.from.size(), edit.to);
    text.replace(text.find("\"1\""), 3, "\"%\"");
    return text;
  };
  const std::string refused_run =
      with_edits({{"cells_x = 50", "cells_x = 1"}, {row, row_on({"\"coarse\"", "\"mesh\""})}}) +
      row_on({"elevation@right", "elevation@left"});
  EXPECT_EQ(mistakes_in(refused_run),
            (Mistakes{"trial.toml:50: run.cells_x = 1", "trial.toml:68: gate.unit = \"%\""}));
  const std::string refused_gauge =
      with_edits({{"x_m = 0.05", "x_m = 5.0"}, {row, row_on({"@right", "@left"})}}) +
      row_on({"@right", "@right"});
  EXPECT_EQ(mistakes_in(refused_gauge),
            (Mistakes{"trial.toml:30: gauge.x_m = 5.0", "trial.toml:68: gate.unit = \"%\""}));
}

TEST(CaseParserComplaints, AreTheFirstTwentyAndSaySo) {
  std::string text = valid_text;
  for (int i = 0; i < 30; ++i) text += "[[gauge]]\nname = \"g\"\nx_m = -1\n";
  const Mistakes told = mistakes_in(text);
  ASSERT_EQ(told.size(), 21u);
  EXPECT_EQ(told[0], "trial.toml:64: gauge.x_m = -1");
  EXPECT_EQ(told[20], "these are the first 20; there may be more");
}

TEST(CaseParserComplaints, AreOneALine) {
  const std::string message = complaint_about({"length_m = 2\nheight_m", "length_m = 2\nhigh_m"});
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_STREQ(CaseFileErrors({"one", "two"}).what(), "one\ntwo");
}

}  // namespace
}  // namespace slosh::case_parser_complaints_test
