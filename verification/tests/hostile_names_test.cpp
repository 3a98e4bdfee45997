// Texts and paths that a shell, gnuplot or OpenFOAM would run or trip over.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::hostile_names_test {
namespace {

namespace fs = std::filesystem;

const std::string hostile =
    "it's $(touch trap) `touch trap` \";touch trap;\" | touch trap\\\n#calc";

class HostileNames : public SmallCampaign {
 protected:
  HostileNames() { fs::create_directories(place()); }
  fs::path place() const { return directory() / hostile; }

  // As of an `artist` with an apostrophe: TOML's literal of several lines.
  static std::string literal(const std::string& text) { return "'''" + text + "'''"; }

  bool sprung() const {
    for (const auto& entry : fs::recursive_directory_iterator(directory()))
      if (entry.path().filename() == "trap") return true;
    return false;
  }
};

TEST_F(HostileNames, RunNothingFromTextsAndPathsOfACampaign) {
  std::string text = particles_case + (has_interfoam() ? mesh_run + gate_on("mesh") : "");
  text = with(text, "\"A small surge\"", literal(hostile));
  text = with(text, "\"made for a test\"", literal(hostile));
  text = with(text, "\"The runs are coarse.\"", literal(hostile));
  write(hostile + "/small.toml", text);
  write(hostile + "/surges.toml",
        "schema_version = 1\nname = \"surges\"\ntitle = " + literal(hostile) +
            "\nsource = " + literal(hostile) + "\ncases = [\"./small.toml\"]\n");
  const std::string campaign = hostile + "/surges.toml", out = hostile + "/out";
  const Ended run = tool({"campaign", campaign, "--output", out});
  EXPECT_EQ(run.status, 0) << run.err << run.out;
  const std::string ledger = hostile + "/ledger";
  const auto on_ledger = [&](std::vector<std::string> words) {
    words.insert(words.end(), {campaign, "--output", out, "--ledger", ledger});
    return tool(words);
  };
  EXPECT_EQ(on_ledger({"baseline", "propose", "--new"}).status, 0);
  EXPECT_EQ(
      on_ledger({"baseline", "approve", "--new", "--who", hostile, "--reason", hostile}).status, 0);
  for (const char* option : {"--who", "--reason"}) {
    std::vector<std::string> words{"baseline", "approve", "--who", "A", "--reason", "B"};
    *(std::find(words.begin(), words.end(), option) + 1) = "Jos\xe9";
    const Ended latin = on_ledger(words);
    EXPECT_EQ(latin.status, 2) << latin.err;
    EXPECT_TRUE(holds(latin.err, option + std::string(": Jos\uFFFD: expected a text in UTF-8")));
  }
  const Ended gate = on_ledger({"gate"});
  EXPECT_EQ(gate.status, 0) << gate.err << gate.out;
  EXPECT_TRUE(fs::exists(place() / "out/report/index.html"));
  EXPECT_TRUE(fs::exists(place() / "out/gate/junit.xml"));
  EXPECT_FALSE(sprung());
}

TEST_F(HostileNames, StandInTheCommandThatRepeatsARunAsAShellReadsThem) {
  write(hostile + "/small.toml", small_case);
  ASSERT_EQ(tool({"run", hostile + "/small.toml", "theory"}).status, 0);
  const std::string command = read_result(directory() / "theory.h5").provenance.at("command");
  const Ended shell = end_of(start("/bin/sh", {"-c", "set -- " + command + "; printf %s \"$3\""}));
  EXPECT_EQ(shell.status, 0) << shell.err;
  EXPECT_EQ(shell.out, (place() / "small.toml").string());
  EXPECT_FALSE(sprung());
}

TEST_F(HostileNames, MayHoldBytesThatAreNoUtf8) {
  const std::string latin = "l\xe4tin";
  fs::create_directory(directory() / latin);
  write(latin + "/small.toml", particles_case);
  write(latin + "/surges.toml",
        "schema_version = 1\nname = \"surges\"\ntitle = \"Small\"\nsource = \"a test\"\n"
        "cases = [\"./small.toml\"]\n");
  const Ended run = tool({"gate", latin + "/surges.toml", "--output", latin + "/out"});
  EXPECT_EQ(run.status, 0) << run.err << run.out;
}

TEST_F(HostileNames, AreRefusedWhereTheyBecomeArgumentsOrFiles) {
  for (const char* name : {"--help", "-o", "$(x)", "a b", "`x`", "../x", ""}) {
    write("small.toml", with(small_case, "\"theory\"", "\"" + std::string(name) + "\""));
    const Ended run = tool({"run", "./small.toml", "theory"});
    EXPECT_EQ(run.status, 2) << name;
    EXPECT_NE(run.err.find("expected a name of letters, digits, _ and -"), std::string::npos)
        << run.err;
  }
}

}  // namespace
}  // namespace slosh::hostile_names_test
