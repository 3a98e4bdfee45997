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
                     const std::vector<std::filesystem::path>& inputs = {},
                     const std::filesystem::path& place = {}) const {
    CaseDefinition definition = sample_case();
    definition.file = directory_.path() / "small.toml";
    ExternalRun external;
    external.command = command;
    external.inputs = inputs;
    external.directory = place;
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

TEST_F(UnlistedScript, IsAlsoADirectoryThatAProgramStartsInOrIsGiven) {
  std::filesystem::create_directory(directory_.path() / "tables");
  const std::filesystem::path tables = directory_.path() / "tables";
  EXPECT_EQ(script({"./solve"}, {}, tables), tables);
  EXPECT_EQ(script({"./solve"}, {directory_.path() / "solve"}, tables), tables)
      << "an input elsewhere says nothing of this directory";
  EXPECT_EQ(script({"./solve", "tables"}, {directory_.path() / "solve"}), tables);
  write("tables/rates", "1");
  for (const std::filesystem::path& input :
       {tables, tables / "rates", directory_.path() / "tab*/*"})
    EXPECT_EQ(script({"./solve", "--in=tables"}, {input}, tables / "."), "") << input;
  EXPECT_EQ(script({"./solve"}, {directory_.path() / "solve"}, directory_.path()), "");
  for (const char* word : {"tables", "--tables=tables", "{case_directory}/tables", "-T=@tables"})
    EXPECT_NE(script({"./solve", word}).find("tables"), std::string::npos) << word;
  EXPECT_EQ(script({"./solve", "absent", "", "--tables=", "@"}), "");
}

TEST_F(UnlistedScript, ACommandWithoutTheSpacingThatItsRunsDifferInIsDoubtful) {
  CaseDefinition definition = sample_case();
  const auto add = [&](double spacing, std::vector<std::string> command) {
    ExternalRun external;
    external.command = std::move(command);
    external.method = "mine";
    external.particle_spacing = spacing;
    RunDefinition run{};
    run.name = "mine";
    run.solver = external;
    definition.runs.push_back(run);
    return script_doubt(definition.runs.back(), definition);
  };
  EXPECT_EQ(add(0.02, {"./solve"}), "") << "a single spacing";
  EXPECT_NE(add(0.01, {"./solve"}).find("no {particle_spacing_m}"), std::string::npos);
  EXPECT_EQ(add(0.01, {"./solve", "--dx={particle_spacing_m}"}), "");
  EXPECT_EQ(add(0.005, {"./solve", "fine.cfg"}), "") << "a command of its own";
}

}  // namespace
}  // namespace slosh::external_script_test
