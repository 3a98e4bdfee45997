// What a code cannot say is refused with its key and place, and nothing is left of the directory.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/files/atomic_file.hpp"
#include "verification/peers/tests/handed.hpp"

namespace slosh::refused_case_test {
namespace {

namespace fs = std::filesystem;

const std::string rolls =
    "[motion.roll]\ntype = \"sine\"\namplitude_deg = 4\nangular_frequency_rad_s = 2\n"
    "axis_x_m = 0.5\naxis_z_m = 0.3\n";
const std::string baffle =
    "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.5\nright_m = 0.62\nbottom_m = 0\ntop_m = 0.1\n";
const std::string wave = "[initial_wave]\nmode = 1\namplitude_m = 0.01\n";

// The refusal from the file's line on; empty where the case is written.
std::string refusal(const std::string& text, const std::string& code, double spacing = 0.05) {
  Handed handed(text);
  try {
    handed.to(code, spacing);
    return "";
  } catch (const CaseFileError& error) {
    EXPECT_FALSE(fs::exists(handed.directory()));
    for (const auto& entry : fs::directory_iterator(handed.directory().parent_path()))
      EXPECT_EQ(entry.path().filename(), "case.toml");
    const std::string message = error.what();
    return message.substr(message.rfind('/') + 1);
  }
}

// The number of the line in the text.
std::string at(const std::string& text, const std::string& line) {
  const std::size_t place = text.find(line);
  return "case.toml:" +
         std::to_string(1 +
                        std::count(text.begin(), text.begin() + static_cast<long>(place), '\n')) +
         ": ";
}

TEST(RefusedCase, TellsWhatPySphCannotBeTold) {
  const std::string rolling = moving(rolls), blocked = plain_case + baffle,
                    narrow = replaced(
                        replaced(plain_case, "height_m = 0.6", "height_m = 0.6\nbreadth_m = 0.1"),
                        "solver = \"potential\"",
                        "solver = \"interfoam\"\ncells_x = 20\ncells_z = 12"),
                    dam = replaced(plain_case, "fill_depth_m = 0.35",
                                   "fill_depth_m = 0.35\ncolumn_width_m = 0.3");
  EXPECT_EQ(refusal(rolling, "pysph"), at(rolling, "[motion.roll]") +
                                           "motion.roll: expected a tank that does not roll, for "
                                           "PySPH");
  EXPECT_EQ(refusal(blocked, "pysph"),
            at(blocked, "[[obstacle]]") + "obstacle: expected a tank without obstacles, for PySPH");
  EXPECT_EQ(refusal(narrow, "pysph"), at(narrow, "breadth_m") +
                                          "tank.breadth_m = 0.1: expected a tank whose gap "
                                          "walls do not count, for PySPH");
  EXPECT_EQ(refusal(dam, "pysph"),
            at(dam, "column_width_m") +
                "liquid.column_width_m = 0.3: expected a liquid that fills the "
                "tank from wall to wall, for PySPH");
  EXPECT_TRUE(refusal(plain_case, "pysph", 0.03).starts_with("--spacing: 0.03: expected"));
  EXPECT_EQ(refusal(plain_case + wave, "pysph"), "");
}

TEST(RefusedCase, TellsWhatDualSphysicsCannotBeTold) {
  const std::string waves = plain_case + wave, off = moving(rolls), thick = plain_case + baffle;
  EXPECT_EQ(refusal(waves, "dualsphysics"),
            at(waves, "[initial_wave]") +
                "initial_wave: expected a liquid that starts under a level surface, as GenCase "
                "fills boxes, for DualSPHysics");
  EXPECT_EQ(refusal(off, "dualsphysics"), at(off, "start =") +
                                              "time.start = \"earth\": expected \"tank\" where the "
                                              "roll begins at a rate, as the liquid "
                                              "starts with one velocity, for DualSPHysics");
  EXPECT_EQ(refusal(thick, "dualsphysics"),
            at(thick, "[[obstacle]]") +
                "obstacle: expected edges that are whole multiples of the spacing, 0.05 m, for "
                "DualSPHysics: baffle has one at 0.62 m");
  EXPECT_TRUE(refusal(plain_case, "dualsphysics", 0.03).starts_with("--spacing: 0.03: expected"));
  EXPECT_EQ(refusal(replaced(off, "\"earth\"", "\"tank\""), "dualsphysics"), "");
}

TEST(RefusedCase, TellsWhatInterFoamCannotBeTold) {
  // Its edge at 0.62 m is not on a face of 20 cells.
  EXPECT_NE(refusal(plain_case + baffle, "openfoam").find("obstacle"), std::string::npos);
  for (const std::string& sayable : {plain_case + wave, moving(rolls), plain_case + baffle})
    EXPECT_EQ(refusal(sayable, "csv"), "");
}

TEST(RefusedCase, IsADirectoryWithFilesWhichStayAsTheyAre) {
  Handed handed(plain_case);
  fs::create_directory(handed.directory());
  handed.to("csv");  // an empty one is taken
  std::ofstream(handed.directory() / "mine.txt") << "mine";
  const std::string before = handed.file("numbers.csv");
  EXPECT_THROW(handed.to("pysph"), fs::filesystem_error);
  EXPECT_EQ(handed.file("mine.txt"), "mine");
  EXPECT_EQ(handed.file("numbers.csv"), before);
  EXPECT_FALSE(fs::exists(handed.directory() / "pysph_tank.py"));
}

TEST(WholeDirectory, IsNotThereWhereItsFillingFails) {
  const TemporaryDirectory home;
  const fs::path wanted = home.path() / "above" / "wanted";
  EXPECT_THROW(make_whole_directory(wanted,
                                    [](const fs::path& directory) {
                                      std::ofstream(directory / "half.txt") << "half";
                                      throw std::runtime_error("the disk is full");
                                    }),
               std::runtime_error);
  EXPECT_TRUE(fs::is_empty(home.path() / "above"));
  make_whole_directory(
      wanted, [](const fs::path& directory) { std::ofstream(directory / "all.txt") << "all"; });
  EXPECT_EQ(read_bytes(wanted / "all.txt"), "all");
  std::ofstream(home.path() / "a_file") << "mine";
  EXPECT_THROW(make_whole_directory(home.path() / "a_file", [](const fs::path&) {}),
               fs::filesystem_error);
}

// Each is read by our parser together with the case.
TEST(WrittenRun, IsReadByTheParserOfCaseFilesForShippedCases) {
  const std::pair<const char*, double> cases[] = {{"li2010_small_amplitude", 0.05},
                                                  {"zhao2021_mild_roll", 0.005},
                                                  {"walls_rolling", 0.02},
                                                  {"surge_with_baffle", 0.01}};
  for (const auto& [name, spacing] : cases)
    for (const PeerCode& code : peer_codes()) {
      if (code.name == std::string("pysph") && name != cases[0].first) continue;
      if (code.name == std::string("openfoam") && name == cases[3].first) continue;  // its cells
      Handed written(name);
      written.to(code.name, spacing);
      EXPECT_FALSE(written.run().series.empty()) << name << " for " << code.name;
      EXPECT_NE(written.file("README.md").find(name), std::string::npos);
    }
}

// Every code but the tables is told rectangles alone.
TEST(RefusedCase, TellsThatACodeKnowsRectanglesAlone) {
  const std::string outline = "outline_m = [[0, 0], [1, 0], [1, 0.6], [0.1, 0.6]]";
  std::string sloped =
      replaced(replaced(plain_case, "length_m = 1.0\nheight_m = 0.6", outline),
               "solver = \"potential\"", "solver = \"interfoam\"\ncells_x = 20\ncells_z = 12");
  for (const PeerCode& code : peer_codes()) {
    const std::string message = refusal(sloped, code.name);
    if (code.takes_outline)
      EXPECT_EQ(message, "") << code.name;
    else
      EXPECT_EQ(message, at(sloped, outline) + "tank." + outline +
                             ": expected a rectangle, length_m and height_m, for " + code.title);
  }
  const std::string round = replaced(sloped, outline, "diameter_m = 1.1");
  EXPECT_EQ(refusal(round, "dualsphysics"),
            at(round, "diameter_m") +
                "tank.diameter_m = 1.1: expected a rectangle, length_m and "
                "height_m, for DualSPHysics 5.4");
}

}  // namespace
}  // namespace slosh::refused_case_test
