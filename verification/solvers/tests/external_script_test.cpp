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

// What its text names beside it, whatever `inputs` lists.
TEST_F(UnlistedScript, IsAFileThatAScriptNames) {
  std::filesystem::create_directories(directory_.path() / "pack/sub");
  for (const char* file : {"mine.py", "rates.json", "pack/__init__.py", "pack/sub/deep.py"})
    write(file, "");
  const std::filesystem::path gen = directory_.path() / "gen.py";
  const std::vector<std::pair<std::string, std::string>> texts{
      {"import sys\nimport mine\n", "mine.py"},
      {"from .mine import k, s\n", "mine.py"},
      {"from pack import k\n", "pack/__init__.py"},
      {"import pack.sub.deep as d\n", "pack/sub/deep.py"},
      {"k = json.load(open(here + \"/rates.json\"))\n", "rates.json"},
      {"exec(open('rates.json').read())\n", "rates.json"},
      {"subprocess.run(['./solve'])\n", "solve"}};
  for (const auto& [text, named] : texts) {
    write("gen.py", text.c_str());
    EXPECT_EQ(script({"python3", "gen.py"}, {gen}), named) << text;
    EXPECT_EQ(script({"nice", "python3", "gen.py"}, {gen}, directory_.path()), named) << text;
    EXPECT_EQ(
        script({"python3", "gen.py"}, {gen, directory_.path() / named, directory_.path() / "pack"}),
        "")
        << text;
  }
  write("run.sh", "#!/bin/sh\nHERE=$(dirname $0)\nexec python3 \"$HERE/gen.py\" \"$@\"\n");
  EXPECT_EQ(script({"./run.sh"}, {directory_.path() / "rates.json"}), "gen.py");
  write("run.sh", ("exec " + (directory_.path() / "solve").string() + "\n").c_str());
  EXPECT_EQ(script({"sh", "run.sh"}, {directory_.path() / "rates.json"}), "solve") << "whole path";
}

TEST_F(UnlistedScript, IsNoneOfAScriptThatStandsForItself) {
  const std::filesystem::path gen = directory_.path() / "gen.py";
  write("notes.txt", "");
  write("small.toml", "[[run]] file = \"notes.txt\"");
  for (const char* text :
       {"import sys, os, numpy as np\nwork, k = sys.argv[1:3]\nopen(work + '/e.csv', 'w')\n",
        "x = 1  # as notes.txt says, beside mine.py\n", "# notes.txt\n#notes.txt\n",
        "#!/usr/bin/env python3\n", "run('gen.py', '/bin/sh', 'small.toml', 'run')\n"}) {
    write("gen.py", text);
    EXPECT_EQ(script({"python3", "gen.py", "{case_file}"}, {gen}), "") << text;
  }
}

TEST_F(UnlistedScript, IsAFileThatAnArgumentNamesInPart) {
  const std::vector<std::filesystem::path> inputs{directory_.path() / "solve"};
  for (const char* file : {"Tank.xml", "rates.txt", "mine.py"}) write(file, "1");
  const std::vector<std::pair<std::vector<std::string>, std::string>> commands{
      {{"./solve", "Tank"}, "Tank.xml"},
      {{"./solve", "{case_directory}/Tank"}, "Tank.xml"},
      {{"./solve", "-prates.txt"}, "rates.txt"},
      {{"./solve", "-prates"}, "rates.txt"},
      {{"./solve", "a.txt,rates.txt"}, "rates.txt"},
      {{"./solve", "--in=a.txt:rates.txt"}, "rates.txt"},
      {{"python3", "-m", "mine"}, "mine.py"},
      {{"bash", "-c", "cd x && ./solve <rates.txt"}, "rates.txt"}};
  for (const auto& [command, named] : commands) {
    EXPECT_EQ(script(command, inputs), named) << command.back();
    EXPECT_EQ(script(command, {inputs[0], directory_.path() / named}), "") << command.back();
  }
  for (const char* word : {"rates.txt", "Other", "0.02", "--rates", "{work_directory}/Tank", "*"})
    EXPECT_EQ(script({"./solve", word}, inputs), "") << word;
}

}  // namespace
}  // namespace slosh::external_script_test
