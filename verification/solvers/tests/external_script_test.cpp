#include "verification/solvers/external/external_script.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::external_script_test {
namespace {

class UnlistedScript : public ::testing::Test {
 protected:
  UnlistedScript() {
    write("gen.py", "import mine\n");
    write("run.sh", "#!/bin/sh\nexec ./solve\n");
    write("solve",
          "\x7f"
          "ELF");
  }
  void write(const char* name, const char* text) {
    std::ofstream(directory_.path() / name) << text;
  }
  std::string script(const std::vector<std::string>& command,
                     const std::vector<std::filesystem::path>& inputs = {}) const {
    CaseDefinition definition = sample_case();
    definition.file = directory_.path() / "small.toml";
    ExternalRun external;
    external.command = command;
    external.inputs = inputs;
    return unlisted_script(external, definition);
  }

  TemporaryDirectory directory_;
};

TEST_F(UnlistedScript, IsThatOfAnInterpreterOrOfAFileThatNamesOne) {
  EXPECT_EQ(script({"python3", "gen.py"}), "python3");
  EXPECT_EQ(script({"/usr/bin/python3.11", "-m", "mine"}), "/usr/bin/python3.11");
  EXPECT_EQ(script({"mpirun", "-n", "2", "python3", "gen.py"}), "python3");
  EXPECT_EQ(script({"./run.sh"}), "run.sh");
  EXPECT_EQ(script({"nice", "./run.sh"}), "run.sh");
}

TEST_F(UnlistedScript, IsNoneOfAProgramOfADeclaredInputOrOfOurDriver) {
  EXPECT_EQ(script({"./solve", "gen.py"}), "");
  EXPECT_EQ(script({"python3", "gen.py"}, {directory_.path() / "gen.py"}), "");
  EXPECT_EQ(script({"./run.sh"}, {directory_.path() / "solve"}), "");
  EXPECT_EQ(script({"{peers_directory}/pysph_tank.py"}), "");
}

}  // namespace
}  // namespace slosh::external_script_test
