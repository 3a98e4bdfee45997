// The commands and the Python code of docs/results.md, in the order of the page: it reads what the
// tool leaves, and draws it.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "reports/model/report_files.hpp"
#include "verification/tests/documents.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::python_page_test {
namespace {

constexpr const char* python = "/usr/bin/python3";  // Debian's own, which its packages are for

class PythonPage : public SmallCampaign {
 protected:
  PythonPage() {
    write_campaign(particles_case);
    write("slosh", "#!/bin/sh\nexec '" SLOSH_TOOL "' \"$@\"\n");
    std::filesystem::permissions(directory() / "slosh", std::filesystem::perms::owner_all);
  }

  static std::vector<std::string> blocks(const std::string& language) {
    const std::string page = reports::read_text(SLOSH_SOURCE_DIR "/docs/results.md");
    return documents::all_matches(page, "\n```" + language + "\n((?:[^`]|`(?!``))*)```");
  }

  Ended python_code(const std::string& code) const {
    return end_of(start(python, {"-c", code}, {{"MPLBACKEND", "Agg"}}));
  }

  bool imports(const std::string& module) const {
    return std::filesystem::exists(python) && python_code("import " + module).status == 0;
  }
};

TEST_F(PythonPage, ReadsAndDrawsWhatItsCommandsLeave) {
  if (!imports("h5py")) GTEST_SKIP() << "python3-h5py is not installed";
  const std::vector<std::string> commands = blocks("sh"), codes = blocks("python");
  ASSERT_EQ(commands.size(), 1u);
  ASSERT_EQ(codes.size(), 2u);
  ASSERT_EQ(end_of(start("/bin/sh", {"-ec", commands.front()})).status, 0) << commands.front();
  const bool draws = imports("matplotlib");
  std::string printed;
  for (const std::string& code : codes) {
    if (!draws && holds(code, "matplotlib")) continue;
    const Ended ended = python_code(code);
    EXPECT_EQ(ended.status, 0) << code << ended.err;
    printed += ended.out;
  }
  EXPECT_TRUE(holds(printed, "li2010_small_amplitude recommended_25mm by sph\n"));
  EXPECT_TRUE(holds(printed, "\nelevation@right to 20.0 s from -0.0"));
  if (!draws) GTEST_SKIP() << "python3-matplotlib is not installed";
  EXPECT_TRUE(reports::is_whole_png(read("beside_theory.png")));
}

}  // namespace
}  // namespace slosh::python_page_test
