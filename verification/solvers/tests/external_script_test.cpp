#include "verification/solvers/external/external_script.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "verification/files/content_hash.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/solvers/external/shared_libraries.hpp"
#include "verification/tests/messages.hpp"
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
    EXPECT_TRUE(holds(script({"./solve", word}), "tables")) << word;
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

// Programs that are compiled here, whose libraries the system's loader finds too.

namespace fs = std::filesystem;

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  for (std::array<char, 256> piece; std::fgets(piece.data(), piece.size(), pipe);)
    text += piece.data();
  return pclose(pipe) == 0 ? text : "failed: " + command;
}

class OwnLibraries : public ::testing::Test {
 protected:
  OwnLibraries() {
    fs::create_directories(home / "lib");
    fs::create_directories(home / "other");
    fs::create_directories(home / "builds");
    std::ofstream(home / "builds/external") << "one build of it";
    // prog needs libfirst, which needs libsecond.
    library("second", 1, "");
    library("first", 1, "-L" + (home / "lib").string() + " -lsecond -Wl,-rpath,'$ORIGIN'");
    program("prog", "-lfirst -Wl,-rpath,'$ORIGIN/lib' -Wl,-rpath-link," + (home / "lib").string());
  }
  ~OwnLibraries() override {
    unsetenv("LD_LIBRARY_PATH");
    unsetenv("LD_PRELOAD");
  }
  void compile(const std::string& text, const std::string& to, const std::string& options) const {
    std::ofstream(home / "source.cpp") << text;
    const std::string command = SLOSH_COMPILER " -o " + (home / to).string() + " " +
                                (home / "source.cpp").string() + " " + options;
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  void library(const std::string& name, int value, const std::string& options,
               const std::string& in = "lib") const {
    compile("extern \"C\" int " + name + "_value() { return " + std::to_string(value) + "; }\n" +
                (name == "first" ? "extern \"C\" int second_value();\nint used() { return "
                                   "second_value(); }\n"
                                 : ""),
            in + "/lib" + name + ".so", "-shared -fPIC " + options);
  }
  void program(const std::string& name, const std::string& options) const {
    compile("extern \"C\" int first_value();\nint main() { return first_value() - 1; }\n", name,
            "-L" + (home / "lib").string() + " " + options);
  }
  CaseDefinition definition() const {
    CaseDefinition one = sample_case();
    one.file = home / "small.toml";
    return one;
  }
  static ExternalRun started(std::vector<std::string> command) {
    ExternalRun external;
    external.command = std::move(command);
    return external;
  }
  std::vector<std::string> found(std::vector<std::string> command = {"./prog"}) const {
    std::vector<std::string> names;
    for (const fs::path& file : own_libraries(started(std::move(command)), definition()))
      names.push_back(file.lexically_relative(home).string());
    return names;
  }
  std::string key() const {
    return run_key(definition(), sample_run(started({"./prog"})), home / "builds", home);
  }

  using Names = std::vector<std::string>;
  TemporaryDirectory directory;
  const fs::path home = fs::canonical(directory.path());
};

TEST_F(OwnLibraries, AreThoseThatTheLoaderFindsOutsideTheSystem) {
  const Names both{"lib/libfirst.so", "lib/libsecond.so"};
  EXPECT_EQ(found(), both);
  EXPECT_EQ(found({"mpirun", "-n", "2", "./prog"}), both);
  const std::string listed = output_of("ldd " + (home / "prog").string());
  for (const std::string& name : both) EXPECT_TRUE(holds(listed, (home / name).string() + " "));
  for (const char* kind : {"--enable-new-dtags", "--disable-new-dtags"}) {
    program("prog", std::string("-lfirst -Wl,-rpath,'${ORIGIN}/lib' -Wl,") + kind +
                        " -Wl,-rpath-link," + (home / "lib").string());
    EXPECT_EQ(found(), both) << kind;
  }
  fs::create_symlink(home / "prog", home / "other/linked");
  EXPECT_EQ(found({"other/linked"}), both) << "$ORIGIN is that of the file behind the link";
}

TEST_F(OwnLibraries, ChangeTheKeyOfTheRun) {
  const std::string before = key();
  EXPECT_EQ(key(), before);
  library("second", 2, "");
  const std::string changed = key();
  EXPECT_NE(changed, before) << "a library of its library";
  library("first", 2, "", "other");
  EXPECT_EQ(key(), changed) << "not searched";
  setenv("LD_LIBRARY_PATH", (home / "other").c_str(), 1);
  EXPECT_NE(key(), changed) << "one that comes before it";
}

TEST_F(OwnLibraries, AreThoseOfTheEnvironmentToo) {
  program("prog", "-lfirst -Wl,-rpath-link," + (home / "lib").string());
  EXPECT_EQ(found(), Names{});
  setenv("LD_LIBRARY_PATH", ("/nowhere:" + (home / "lib").string()).c_str(), 1);
  EXPECT_EQ(found(), (Names{"lib/libfirst.so", "lib/libsecond.so"}));
  unsetenv("LD_LIBRARY_PATH");
  setenv("LD_PRELOAD", (home / "lib/libsecond.so").c_str(), 1);
  EXPECT_EQ(found(), Names{"lib/libsecond.so"});
}

TEST_F(OwnLibraries, AreNoneOfTheSystemsAndOfWhatIsNoProgram) {
  compile("int main() {}", "plain", "");
  std::ofstream(home / "run.sh") << "#!/bin/sh\n";
  for (const char* program : {"./plain", "sh", "./run.sh", "./absent"})
    EXPECT_EQ(found({program}), Names{}) << program;
  EXPECT_TRUE(is_of_system("/usr/lib/x86_64-linux-gnu/libmpi.so"));
  EXPECT_TRUE(is_of_system("/lib64/ld-linux-x86-64.so.2"));
  for (const char* own : {"/usr/local/lib/libmine.so", "/opt/lib/libmine.so", "/home/me/lib.so"})
    EXPECT_FALSE(is_of_system(own)) << own;
}

// Whatever a file says, nothing outside of it is read.
TEST_F(OwnLibraries, OfABrokenFileAreFewer) {
  const std::string whole = read_bytes(home / "prog");
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole.substr(0, i % 2 ? whole.size() : random() % whole.size());
    for (int changed = 0; changed < 20 && bytes.size() > 4; ++changed)
      bytes[4 + random() % (std::min<std::size_t>(bytes.size(), 1200) - 4)] =
          static_cast<char>(random());
    std::ofstream(home / "broken", std::ios::binary) << bytes;
    EXPECT_LE(found({"./broken"}).size(), 2u);
  }
}

}  // namespace
}  // namespace slosh::external_script_test
