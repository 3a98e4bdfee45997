// docs/your_code.md gates a small SPH code from outside: its blocks are the shipped files, and its
// commands end as it says. Those of the fine run and of the study are in your_code_study_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "verification/tests/page_commands.hpp"

namespace slosh::your_code_test {
namespace {

namespace fs = std::filesystem;

const std::string compile = "g++ -O2 -o ../my_sph/small_sph ../my_sph/small_sph.cpp";
const std::string gate = "./slosh gate ../my_sph/campaign.toml --quick -o ../my_sph/gated";
const std::string of_ledger =
    " ../my_sph/campaign.toml --quick -o ../my_sph/gated --ledger ../my_sph/figures.jsonl";

// The page's commands but those of the study.
const std::vector<TypedLine> typed_lines{
    {"cp -r docs/your_code ../my_sph"},
    {compile},
    {gate},
    {"cp ../my_sph/small_sph.cpp ../my_sph/good.cpp"},
    {"sed -i 's/(b.rho - a.rho - hydrostatic)/(b.rho - a.rho)/' ../my_sph/small_sph.cpp"},
    {compile},
    {gate, 1},
    {"cp ../my_sph/good.cpp ../my_sph/small_sph.cpp"},
    {compile},
    {gate},
    {"./slosh baseline propose" + of_ledger + " --new"},
    {"./slosh baseline approve" + of_ledger +
     " --new --who 'A. Name' --reason 'The first figures.'"},
    {"sed -i 's/alpha = 0.01/alpha = 0.02/' ../my_sph/small_sph.cpp"},
    {compile},
    {"./slosh gate" + of_ledger},
    {"./slosh baseline diff" + of_ledger, 1},
};

bool is_of_the_study(const std::string& line) {
  return line.starts_with("./slosh campaign") || line.starts_with("./slosh converge");
}

class YourCode : public PageCommands {
 protected:
  // Replaces the program's text, which must be there, and compiles it.
  void change_program(const std::string& from, const std::string& to) const {
    const std::string file = "../my_sph/small_sph.cpp";
    write(file, with(read(file), from, to));
    const Ended compiled = shell(compile);
    ASSERT_EQ(compiled.status, 0) << compiled.err;
  }
};

// The rows that the page shows and another compiler must find too, up to their values. What is
// inconclusive, and what has moved by little more than its uncertainty, belongs to one machine.
std::vector<std::string> rows_of(const std::string& text) {
  std::vector<std::string> rows;
  for (const char* pattern :
       {R"(\n    ((?:pass|violated) [^:\n]*@right:))", R"(\n    (PASS: [^:\n]*:))",
        R"(\n    (wave: [^:\n]* decay_rate of elevation@right:))"})
    for (const std::string& row : documents::all_matches(text, pattern)) rows.push_back(row);
  return rows;
}

TEST_F(YourCode, IsShownByThePageAsItsFilesAre) {
  const std::string text = page("your_code.md");
  for (const char* file : {"wave.toml", "campaign.toml"})
    EXPECT_TRUE(holds(text, "```toml\n" + read(directory() / "docs/your_code" / file) + "```\n"))
        << file;
  const std::string program = read(directory() / "docs/your_code/small_sph.cpp");
  const auto lines = std::count(program.begin(), program.end(), '\n');
  EXPECT_TRUE(holds(text, "(your_code/small_sph.cpp) of " + std::to_string(lines) + " lines"));
}

TEST_F(YourCode, PassesTheGateAndDoesNotWhereItIsBroken) {
  const std::string text = page("your_code.md");
  std::vector<std::string> shown = command_lines(text), typed_here;
  std::erase_if(shown, is_of_the_study);
  for (const TypedLine& typed : typed_lines) typed_here.push_back(typed.line);
  EXPECT_EQ(shown, typed_here);
  std::string printed;
  for (const TypedLine& typed : typed_lines) {
    const std::string before = read("../my_sph/small_sph.cpp");
    const Ended ended = shell(typed.line);
    EXPECT_EQ(ended.status, typed.status) << typed.line << "\n" << ended.out << ended.err;
    if (typed.line.starts_with("sed")) {
      EXPECT_NE(read("../my_sph/small_sph.cpp"), before) << typed.line;
    }
    printed += ended.out;
  }
  EXPECT_EQ(rows_of(text).size(), 9u);
  for (const std::string& row : rows_of(text)) EXPECT_TRUE(holds(printed, row));
  EXPECT_TRUE(holds(read("../my_sph/figures.jsonl"), "The first figures."));
  const std::string selftest =
      "./slosh gate ../my_sph/campaign.toml --selftest --quick -o ../my_sph/gated";
  EXPECT_TRUE(holds(text, "`" + selftest + "`"));
  const Ended tried = shell(selftest);
  EXPECT_EQ(tried.status, 0) << tried.out << tried.err;
}

// The program ends with status 0, and its log tells.
TEST_F(YourCode, FailsWhereItLosesParticles) {
  ASSERT_EQ(shell(typed_lines[0].line).status, 0);
  change_program("-2 * delta * h", "2 * delta * h");
  const Ended ended = shell(gate);
  EXPECT_EQ(ended.status, 3) << ended.out << ended.err;
  EXPECT_TRUE(holds(ended.out + ended.err, "fail_on = \"particles excluded\""));
}

// As the workflow does, from the root of the code's own repository.
TEST_F(YourCode, IsMarkedInItsOwnRepositoryByThePullRequest) {
  ASSERT_EQ(shell(typed_lines[0].line).status, 0);
  change_program("(b.rho - a.rho - hydrostatic)", "(b.rho - a.rho)");
  const std::string workflow = read("../my_sph/gate.yml");
  const auto lines = documents::all_matches(workflow, R"(- run: (\./slosh/slosh [^\n]*))");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(holds(workflow, "- run: " + with(with(compile, "../my_sph/", ""), "../my_sph/", "")));
  // The figures that are approved are those of the program as it is now: none has moved.
  const std::string of_campaign = " ./campaign.toml --quick -o gate";
  EXPECT_EQ(shell("./slosh gate" + of_campaign, "../my_sph").status, 1);
  for (const char* command : {"propose", "approve --who 'A. Name' --reason 'Why.'"})
    EXPECT_EQ(shell("./slosh baseline " + std::string(command) + of_campaign +
                        " --ledger figures.jsonl --new",
                    "../my_sph")
                  .status,
              0);
  const Ended ended = shell(lines[0], "../my_sph");
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_TRUE(holds(read("../my_sph/gate/gate/junit.xml"), "file=\"wave.toml\""));
  EXPECT_TRUE(holds(read("../my_sph/gate/gate/gate.md"), "| **violated** |"));
}

}  // namespace
}  // namespace slosh::your_code_test
