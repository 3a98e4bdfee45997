// What leaves the tool for other programs and for eyes: tables and pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_export_test {
namespace {

namespace fs = std::filesystem;

class ToolExport : public SmallCampaign {
 protected:
  ToolExport() { write_campaign(particles_case); }

  // A program that notes the file it is to show, and its content's first letters.
  Environment browser() const {
    write("browser", "#!/bin/sh\necho \"$1\" >shown\n");
    fs::permissions(directory() / "browser", fs::perms::owner_all);
    return {{"BROWSER", (directory() / "browser").string() + ":another"}};
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_F(ToolExport, WritesEveryNumberOfAResultSoThatItReadsAsTheSame) {
  ASSERT_EQ(run("theory").status, 0);
  const Ended table = tool({"export", "theory.h5", "--csv"}, {{"LC_ALL", "de_DE.UTF-8"}});
  ASSERT_EQ(table.status, 0) << table.err;
  ASSERT_EQ(tool({"export", "theory.h5", "--csv", "-o", "theory.csv"}).status, 0);
  EXPECT_EQ(read("theory.csv"), table.out);
  ASSERT_EQ(tool({"import", "theory.csv", "--format", "csv", "--time", "time", "--series",
                  "elevation@right=elevation@right", "-o", "back.h5"})
                .status,
            0);
  const TimeSeries before = read_result(directory() / "theory.h5").at("elevation@right"),
                   after = read_result(directory() / "back.h5").at("elevation@right");
  EXPECT_EQ(before.time, after.time);
  EXPECT_EQ(before.value, after.value);
}

TEST_F(ToolExport, TakesTheFormFromTheNameOfTheFile) {
  ASSERT_EQ(run("theory").status, 0);
  ASSERT_EQ(tool({"export", "theory.h5", "-o", "theory.csv"}).status, 0);
  EXPECT_TRUE(read("theory.csv").starts_with("time [s],elevation@right [m],"));
  const Ended wrong = tool({"export", "theory.h5", "-o", "theory.xls"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(holds(wrong.err, "theory.xls: expected a name that ends in .csv"));
  const Ended none = tool({"export", "theory.h5"});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(holds(none.err, "expected --output FILE.csv, or --csv"));
}

TEST_F(ToolExport, RefusesWhatIsNoResult) {
  write("no.h5", "no result");
  const Ended table = tool({"export", "no.h5", "--csv"});
  EXPECT_EQ(table.status, 4);
  EXPECT_TRUE(holds(table.err, "no.h5"));
  EXPECT_EQ(table.out, "");
}

TEST_F(ToolExport, LeavesTheTheoriesOfACaseWithTheirRangesAndNoOtherRun) {
  ASSERT_EQ(tool({"export", "./small.toml", "-o", "truth.csv"}).status, 0);
  const std::vector<std::string> lines = lines_of(read("truth.csv"));
  ASSERT_GT(lines.size(), 800u);
  EXPECT_EQ(lines[0], "# Case small: A small surge");
  EXPECT_TRUE(lines[3].starts_with("# theory, range: an elevation of at most 0.2 fill depths"));
  EXPECT_TRUE(lines[4].starts_with("# theory, uncertainty: "));
  EXPECT_TRUE(lines[5].starts_with("time [s],elevation@right/theory [m]"));
  EXPECT_EQ(files_of_store(".h5").size(), 1u) << "only theory is computed";
  ASSERT_EQ(tool({"export", "./small.toml", "-o", "truth.h5"}).status, 0);
  ASSERT_EQ(run("theory").status, 0);
  const RunResult truth = read_result(directory() / "truth.h5");
  EXPECT_EQ(truth.at("elevation@right/theory").value,
            read_result(directory() / "theory.h5").at("elevation@right").value);
  EXPECT_TRUE(truth.provenance.contains("theory_range"));
  EXPECT_TRUE(truth.provenance.contains("theory_uncertainty"));
}

TEST_F(ToolExport, LeavesTheoriesThatCompareReads) {
  ASSERT_EQ(tool({"export", "./small.toml", "-o", "truth.h5"}).status, 0);
  ASSERT_EQ(run("theory").status, 0);
  for (const std::vector<std::string>& files :
       {std::vector<std::string>{"theory.h5", "truth.h5"}, {"truth.h5", "theory.h5"}})
    for (const std::vector<std::string>& of :
         {std::vector<std::string>{"--gauge", "right"}, {"--quantity", "elevation@right/theory"}}) {
      const Ended ended = tool({"compare", files[0], files[1], of[0], of[1], "--case",
                                "./small.toml", "--limit", "normalised_rms=0.001"});
      EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
      EXPECT_TRUE(of[0] == "--quantity" || holds(ended.out, "truth.h5 (elevation@right/theory)"))
          << ended.out;
    }
  EXPECT_EQ(tool({"compare", "theory.h5", "truth.h5", "--gauge", "left"}).status, 4);
  EXPECT_EQ(tool({"compare", "theory.h5", "theory.h5", "--quantity", "elevation@right/x"}).status,
            4);
}

TEST_F(ToolExport, LeavesATheoryThatPassesNothingOnceItsCaseHasChanged) {
  ASSERT_EQ(run("theory").status, 0);
  const auto compared = [&] {
    return tool({"compare", "theory.h5", "theory.h5", "--gauge", "right", "--case", "./small.toml",
                 "--limit", "normalised_rms=0.001"});
  };
  const std::string doubt = "were read from different texts of a case";
  const Ended same = compared();
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_FALSE(holds(same.out, doubt));
  write_campaign(with(particles_case, "length_m = 1.0", "length_m = 1.1"));
  const Ended other = compared();
  EXPECT_EQ(other.status, 5) << other.out << other.err;
  EXPECT_TRUE(holds(other.out, doubt));
}

TEST_F(ToolExport, LeavesATheoryOutsideItsRangeAndSaysSo) {
  write_campaign(with(particles_case, "valid_elevation_over_depth = 0.2",
                      "valid_elevation_over_depth = 0.001"));
  const Ended ended = tool({"export", "./small.toml", "-o", "truth.csv"});
  EXPECT_EQ(ended.status, 4);
  EXPECT_TRUE(holds(ended.err, "theory is outside its range: it predicts an elevation of "));
  EXPECT_EQ(tool({"export", "./small.toml", "-o", "truth.h5"}).status, 4);
  for (const std::vector<std::string>& references :
       {std::vector<std::string>{"truth.h5"}, {"--case", "./small.toml"}}) {
    std::vector<std::string> arguments{"compare", "truth.h5", "--gauge",
                                       "right",   "--limit",  "normalised_rms=0.001"};
    arguments.insert(arguments.begin() + 2, references.begin(), references.end());
    const Ended compared = tool(arguments);
    EXPECT_EQ(compared.status, 5) << compared.out << compared.err;
    EXPECT_TRUE(holds(compared.out, "inconclusive: ")) << compared.out;
    EXPECT_TRUE(holds(compared.out, "doubtful: theory is outside its range: it predicts"));
  }
  EXPECT_TRUE(holds(read("truth.csv"), "# theory is outside its range: it predicts"));
}

TEST_F(ToolExport, RefusesReferencesOfAnotherFormOrOfACaseWithoutAny) {
  const Ended form = tool({"export", "./small.toml", "-o", "truth.xls"});
  EXPECT_EQ(form.status, 2);
  EXPECT_TRUE(holds(form.err, "truth.xls: expected a name that ends in .csv or .h5"));
  const Ended none = tool({"export", "walls_still", "-o", "truth.csv"});
  EXPECT_EQ(none.status, 4);
  EXPECT_TRUE(holds(none.err, "the case has no such reference"));
  EXPECT_FALSE(fs::exists(directory() / "truth.csv"));
}

TEST_F(ToolExport, ShowsTheHistoriesThatAreThereAndTellsHowToComputeTheOthers) {
  ASSERT_EQ(run("theory").status, 0);
  const Ended shown = tool({"show", "./small.toml"}, browser());
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_TRUE(holds(tool({"show", "--help"}).out, "shown/CASE.html beside the store"));
  EXPECT_TRUE(holds(read("shown"), "/shown/small.html"));
  EXPECT_TRUE(holds(shown.err, "particles is not there: `./slosh run "));
  EXPECT_TRUE(holds(shown.err, "small.toml' particles` computes it"));
  const std::string page = read(lines_of(read("shown")).at(0));
  EXPECT_TRUE(holds(page, "<h1>A small surge</h1>"));
  EXPECT_TRUE(holds(page, "Surface elevation 0.95 m from the left wall"));
  EXPECT_TRUE(holds(page, "theory: linear potential theory, 500 modes"));
  EXPECT_TRUE(holds(page, "particles is not there"));
}

// The name of no case ends in ".tank".
TEST_F(ToolExport, LeavesTheDrawingsOfACaseWhereNoPictureOfAnotherGoes) {
  const Ended explained = tool({"explain", "./small.toml"});
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_TRUE(holds(explained.out, "shown/small.tank.html")) << explained.out;
}

TEST_F(ToolExport, DrawsThePictureIntoAFile) {
  ASSERT_EQ(run("theory").status, 0);
  ASSERT_EQ(tool({"show", "./small.toml", "-o", "a.png"}).status, 0);
  EXPECT_TRUE(read("a.png").starts_with("\x89PNG"));
  ASSERT_EQ(tool({"show", "./small.toml", "-o", "new/a.svg"}).status, 0);
  EXPECT_TRUE(holds(read("new/a.svg"), "elevation [mm]"));
  const Ended other =
      tool({"show", "./small.toml", "-o", "b.svg", "--quantity", "highest_surface@right"});
  EXPECT_TRUE(other.status == 0 || holds(other.err, "no result that is there has it"));
  const Ended wrong = tool({"show", "./small.toml", "-o", "b.svg", "--quantity", "colour"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(holds(wrong.err, "--quantity: colour: expected one of elevation@right"));
  EXPECT_EQ(tool({"show", "./small.toml", "-o", "a.gif"}).status, 2);
  for (const auto& entry : fs::directory_iterator(directory()))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".drawing")) << entry.path();
}

TEST_F(ToolExport, HasNothingToShowWhereNoResultIsThere) {
  const Ended shown = tool({"show", "./small.toml", "-o", "a.png"});
  EXPECT_EQ(shown.status, 4);
  EXPECT_TRUE(holds(shown.err, "theory is not there: "));
  EXPECT_TRUE(holds(shown.err, "small: no result is there to be shown"));
}

TEST_F(ToolExport, TellsWhereThePictureIsWithoutABrowser) {
  ASSERT_EQ(run("theory").status, 0);
  const Ended shown = tool({"show", "./small.toml"}, {{"BROWSER", "no_such_browser"}});
  EXPECT_EQ(shown.status, 0);
  EXPECT_TRUE(holds(shown.out, "picture: "));
  EXPECT_TRUE(holds(shown.err, "there is no program no_such_browser"));
}

}  // namespace
}  // namespace slosh::tool_export_test
