// A gnuplot of our own, which counts how often it is started and answers with its script's text.
#include "verification/campaign/known_drawings.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "reports/model/report_files.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::known_drawings_test {
namespace {

namespace fs = std::filesystem;

class KnownDrawingsTest : public ::testing::Test {
 protected:
  KnownDrawingsTest() : path_((directory_.path() / "bin").string() + ":" + std::getenv("PATH")) {
    fs::create_directory(directory_.path() / "bin");
    install("");
  }
  void install(const std::string& comment) const {
    const fs::path program = directory_.path() / "bin/gnuplot";
    std::ofstream(program) << "#!/bin/sh\n"
                           << comment << "echo started >> "
                           << (directory_.path() / "starts").string() << "\ncat \"$2\"\n";
    fs::permissions(program, fs::perms::owner_all);
  }
  fs::path kept() const { return directory_.path() / "drawings"; }
  std::string draw(KnownDrawings& drawings, const std::string& script) const {
    return drawings.draw(script, "a", directory_.path());
  }
  // Draws it for a report that is then complete.
  std::string draw(const std::string& script) const {
    KnownDrawings drawings(kept());
    const std::string drawing = draw(drawings, script);
    drawings.write();
    return drawing;
  }
  std::size_t starts() const {
    return fs::exists(directory_.path() / "starts")
               ? reports::read_text(directory_.path() / "starts").size() / 8
               : 0;
  }
  std::size_t files() const {
    const auto count = std::distance(fs::directory_iterator(kept()), {});
    return static_cast<std::size_t>(count) - 1;  // without the list
  }

 private:
  TemporaryDirectory directory_;
  reports::PathVariable path_;
};

TEST_F(KnownDrawingsTest, AreNotDrawnAgain) {
  EXPECT_EQ(draw("plot x\n"), "plot x\n");
  EXPECT_EQ(draw("plot x\n"), "plot x\n");
  EXPECT_EQ(starts(), 1u);
}

TEST_F(KnownDrawingsTest, AreDrawnAgainOfAnotherScript) {
  draw("plot x\n");
  EXPECT_EQ(draw("plot 2 * x\n"), "plot 2 * x\n");
  EXPECT_EQ(starts(), 2u);
}

TEST_F(KnownDrawingsTest, AreDrawnAgainByAnotherGnuplot) {
  draw("plot x\n");
  install("# of another version\n");
  draw("plot x\n");
  EXPECT_EQ(starts(), 2u);
}

TEST_F(KnownDrawingsTest, AreDrawnAgainWhereTheirFileWasCutOrChanged) {
  draw("plot x\n");
  fs::path file;
  for (const auto& entry : fs::directory_iterator(kept()))
    if (entry.path().extension() == ".svg") file = entry.path();
  const std::string whole = reports::read_text(file);
  for (const std::string& spoilt : {whole.substr(0, whole.size() - 1), whole.substr(0, 3),
                                    std::string(), whole + "more", "0" + whole.substr(1)}) {
    reports::write_text(file, spoilt);
    EXPECT_EQ(draw("plot x\n"), "plot x\n");
    EXPECT_EQ(reports::read_text(file), spoilt);
  }
  EXPECT_EQ(starts(), 6u);
}

TEST_F(KnownDrawingsTest, AreThoseOfTheLastReportAlone) {
  draw("plot x\n");
  draw("plot 2 * x\n");
  EXPECT_EQ(files(), 1u);
  draw("plot x\n");
  EXPECT_EQ(starts(), 3u);
}

TEST_F(KnownDrawingsTest, LeaveTheUsersOwnFilesAlone) {
  fs::create_directories(kept() / "of the tank");
  const std::string like_a_drawing(32, 'a');
  for (const std::string& own : {std::string("tank.svg"), like_a_drawing + ".svg"})
    reports::write_text(kept() / own, "a week of work");
  draw("plot x\n");
  draw("plot 2 * x\n");
  for (const std::string& own : {std::string("tank.svg"), like_a_drawing + ".svg"})
    EXPECT_EQ(reports::read_text(kept() / own), "a week of work");
  EXPECT_TRUE(fs::exists(kept() / "of the tank"));
  EXPECT_EQ(files(), 4u);
}

TEST_F(KnownDrawingsTest, AreNotKeptOfAReportThatFailed) {
  KnownDrawings drawings(kept());
  draw(drawings, "plot x\n");
  EXPECT_FALSE(fs::exists(kept()));
}

}  // namespace
}  // namespace slosh::known_drawings_test
