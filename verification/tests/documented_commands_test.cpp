// Every command line of the documents is one that the tool or the launcher takes. Those of the tool
// are run here, in the order in which a user would get to them, on a small campaign; those of
// shipped campaigns are planned (--dry-run), and an option that writes into the source tree
// (--record) is left out.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "reports/model/report_files.hpp"
#include "verification/tests/documents.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::documented_commands_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = SLOSH_SOURCE_DIR;

class DocumentedCommands : public SmallCampaign {
 protected:
  // The command lines of a document: in code spans, and lines of code that begin with ./slosh.
  static std::vector<std::string> command_lines(const std::string& text) {
    std::vector<std::string> lines = documents::all_matches(text, R"(`(\./slosh [^`\n]*)`)");
    for (const std::string& line :
         documents::all_matches(text, R"(\n *(?:- run: )?(\./slosh (?:[^`\n\\]|\\[^\n]|\\\n)*))"))
      lines.push_back(line);
    return lines;
  }

  std::string help_of(std::vector<std::string> command) {
    std::string name;
    for (const std::string& word : command) name += word + " ";
    if (const auto known = helps_.find(name); known != helps_.end()) return known->second;
    command.push_back("--help");
    const Ended run = tool(command);
    // Beside a wrong word --help gives the help of what is above it.
    return helps_[name] = holds(run.out, "Usage: ./slosh " + name) ? run.out : "";
  }

  // The path of the first state of an SPH run in the directory, "" where there is none.
  std::string saved_state() const {
    for (const auto& entry : fs::recursive_directory_iterator(directory()))
      if (entry.path().filename().string().ends_with(".state.h5")) return entry.path().string();
    return "";
  }

  // What is wrong with a command line, "" where nothing is.
  std::string wrong_in(const std::string& line) {
    const std::string typed = line.substr(0, line.find(" #"));
    std::istringstream stream(typed);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    if (words.size() < 2) return "";
    const std::string command = words[1].substr(0, words[1].find_first_of(",|"));
    if (std::set<std::string>{"test", "fuzz", "bench", "doctor"}.contains(command)) return "";
    if (command.starts_with('-')) return "";
    std::vector<std::string> path{command};
    if (command == "baseline" && words.size() > 2)
      path.push_back(words[2].substr(0, words[2].find_first_of(",|\\")));
    const std::string help = help_of(path);
    if (help.empty()) return "no such command";
    for (const std::string& option : documents::all_matches(typed, R"([\s\[|](--?[a-z][a-z-]*))"))
      if (!std::regex_search(help, std::regex("[\\s,]" + option + "[\\s,]")))
        return "no option " + option;
    return "";
  }

 private:
  std::map<std::string, std::string> helps_;
};

TEST_F(DocumentedCommands, AreThoseOfTheToolAndTheirOptionsToo) {
  std::size_t count = 0;
  for (const fs::path& document : documents::files(source))
    for (const std::string& line : command_lines(reports::read_text(document))) {
      ++count;
      EXPECT_EQ(wrong_in(line), "") << document << ": " << line;
    }
  EXPECT_GE(count, 80u);
}

TEST_F(DocumentedCommands, ThatDoNotExistAreFound) {
  EXPECT_EQ(wrong_in("./slosh campain small_amplitude"), "no such command");
  EXPECT_EQ(wrong_in("./slosh campaign NAME [--qick]"), "no option --qick");
  EXPECT_EQ(wrong_in("./slosh baseline aprove NAME"), "no such command");
  EXPECT_EQ(wrong_in("./slosh campaign NAME [--quick] -o DIR"), "");
}

// A documented command line, and what is run for it: the placeholders filled in, a shipped campaign
// planned in place of run (--dry-run).
struct CommandRun {
  std::string documented;
  std::vector<std::vector<std::string>> typed;
  int status = 0;
};

const std::string here = "./surges.toml", out = "out";

// The result of a run of DualSPHysics, as its tools write it.
const std::string gauge_file =
    (source / "verification/tests/imports/dualsphysics/GaugesSWL_right.csv").string();

// Positions of particles, as any program may write them.
const std::string particle_file =
    (source / "verification/tests/imports/particles/surface.csv").string();

const std::vector<CommandRun> runs{
    {"list", {{"list"}}},
    {"list [PATTERN...] [--tag TAG] [--json] [--names KIND]",
     {{"list", "li2010*", "--json"}, {"list", "--tag", "surge"}, {"list", "--names", "cases"}}},
    {"explain --keys", {{"explain", "--keys"}}},
    {"explain --keys > docs/case_file.md", {{"explain", "--keys"}}},
    {"explain --schema case\\|campaign",
     {{"explain", "--schema", "case"}, {"explain", "--schema", "campaign"}}},
    {"explain --schema case", {{"explain", "--schema", "case"}}},
    {"explain --schema campaign", {{"explain", "--schema", "campaign"}}},
    {"explain CASE", {{"explain", "./small.toml"}}},
    {"new NAME --like CASE -o FILE",
     {{"new", "wave", "--like", "./small.toml", "-o", "wave.toml"}}},
    {"new NAME --like CASE [-o FILE]",
     {{"new", "my_tank", "--like", "./small.toml"},
      {"new", "other_tank", "--like", "./small.toml", "-o", "tank.toml"}}},
    {"case CASE --for CODE -o DIRECTORY [--spacing DP]",
     {{"case", "./small.toml", "--for", "csv", "-o", "tables"},
      {"case", "./small.toml", "--for", "pysph", "--spacing", "0.05", "-o", "for_pysph"},
      {"case", "./small.toml", "--for", "openfoam", "-o", "for_openfoam"}}},
    {"case li2010_small_amplitude --for dualsphysics --spacing 0.01 -o li2010_dualsphysics",
     {{"case", "li2010_small_amplitude", "--for", "dualsphysics", "--spacing", "0.01", "-o",
       "li2010_dualsphysics"}}},
    {"check CASE", {{"check", "./small.toml"}, {"check", "./my_tank.toml"}}},
    {"explain docs/tutorial/own_tank.toml", {{"explain", "docs/tutorial/own_tank.toml"}}},
    {"run CASE RUN [-o FILE]",
     {{"run", "./small.toml", "theory"}, {"run", "./small.toml", "theory", "-o", "theory.h5"}}},
    {"run CASE RUN", {{"run", "./small.toml", "particles", "-o", "particles.h5"}}},
    {"run CASE RUN --states SECONDS",
     {{"run", "./small.toml", "particles", "--states", "4", "-o", "saved.h5"}}},
    {"run CASE RUN --snapshots SECONDS",
     {{"run", "./small.toml", "particles", "--snapshots", "4", "-o", "shot.h5"}}},
    {"run CASE RUN --resume FILE --snapshots SECONDS",
     {{"run", "./small.toml", "particles", "--resume", "STATE", "--snapshots", "4", "-o",
       "resumed.h5"}}},
    {"run CASE RUN --time-limit SECONDS",
     {{"run", "./small.toml", "mesh", "--time-limit", "300", "-o", "mesh.h5"}}},
    {"export RUN.h5 --csv", {{"export", "particles.h5", "--csv"}}},
    {"export RUN.h5 -o FILE.csv", {{"export", "particles.h5", "-o", "p.csv"}}},
    {"reference CASE -o FILE.csv\\|FILE.h5",
     {{"reference", "./small.toml", "-o", "truth.csv"},
      {"reference", "./small.toml", "-o", "truth.h5"}}},
    {"reference CASE -o FILE.csv|FILE.h5", {{"reference", "./small.toml", "-o", "truth.csv"}}},
    {"compare A.h5 B.h5 [--gauge NAME] [--limit METRIC=VALUE]",
     {{"compare", "particles.h5", "theory.h5", "--gauge", "right"},
      {"compare", "particles.h5", "theory.h5", "--case", "./small.toml", "--gauge", "right",
       "--limit", "amplitude_error=0.5"}}},
    {"surface FILE --case CASE --spacing DP -o OUT.h5",
     {{"surface", particle_file, "--case", "li2010_small_amplitude", "--spacing", "0.1", "-o",
       "surface.h5"}}},
    {"surface particles.csv --case li2010_small_amplitude --spacing 0.01 --frame earth -o mine.h5",
     {{"surface", particle_file, "--case", "li2010_small_amplitude", "--spacing", "0.1", "--frame",
       "earth", "-o", "mine_surface.h5"}}},
    {"import FILE --format FORMAT --series QUANTITY=COLUMN -o OUT.h5",
     {{"import", gauge_file, "--format", "dualsphysics_gauge", "--series", "elevation@right=swlz",
       "-o", "imported.h5"}}},
    {"import out/GaugesSWL_right.csv --format dualsphysics_gauge --series elevation@right=swlz "
     "--datum first -o mine.h5",
     {{"import", gauge_file, "--format", "dualsphysics_gauge", "--series", "elevation@right=swlz",
       "--datum", "first", "-o", "mine.h5"}}},
    {"show CASE [-o FILE.png\\|.svg\\|.html] [--quantity Q]",
     {{"show", "./small.toml", "-o", "small.png"},
      {"show", "./small.toml", "-o", "small.svg", "--quantity", "elevation@right"},
      {"show", "./small.toml", "-o", "small.html"}}},
    {"converge CASE --family NAME --spacings 0.05,0.035,0.025",
     {{"converge", "./small.toml", "--family", "recommended", "--spacings", "0.07,0.05,0.035"}}},
    {"problem NAME", {{"problem", "kernels"}}},
    {"problem NAME [--quick] [-o FILE]", {{"problem", "kernels", "--quick", "-o", "kernels.json"}}},
    {"campaign NAME --dry-run", {{"campaign", here, "-o", out, "--dry-run"}}},
    {"campaign NAME", {{"campaign", here, "-o", out}}},
    {"campaign NAME --quick", {{"campaign", here, "-o", out, "--quick", "--dry-run"}}},
    {"campaign NAME [--quick]", {{"campaign", here, "-o", out}}},
    {"campaign NAME [--quick] [-j N] [-o DIR]", {{"campaign", here, "-o", out, "-j", "1"}}},
    {"campaign ./mine.toml -o results", {{"campaign", here, "-o", "results"}}},
    {"report NAME", {{"report", here, "-o", out}}},
    {"report NAME [--quick] [-o DIR]", {{"report", here, "-o", "results"}}},
    {"report --all", {{"report", "--all", "-o", "."}}},
    {"report --all [-o DIR]", {{"report", "--all", "-o", "."}}},
    {"gate NAME", {{"gate", here, "-o", out}}},
    {"gate \"$CAMPAIGN\" --quick --output gate",
     {{"campaign", here, "--quick", "--output", "gate"},
      {"gate", here, "--quick", "--output", "gate"}}},
    // The rows of the small case miss what every case must detect. --record would write into the
    // source tree.
    {"selftest NAME [--quick] [--record]", {{"selftest", here, "-o", out}}, 1},
    {"selftest NAME [--quick] --record", {{"selftest", here, "-o", out}}, 1},
    {"selftest CAMPAIGN --record", {{"selftest", here, "-o", out}}, 1},
    {"baseline propose NAME [--quick] --new",
     {{"baseline", "propose", here, "-o", out, "--new", "--ledger", "ledger.jsonl"}}},
    {"baseline approve NAME [--quick] --new --who 'A. Name' --reason 'The first figures.'",
     {{"baseline", "approve", here, "-o", out, "--new", "--ledger", "ledger.jsonl", "--who",
       "A. Name", "--reason", "The first figures."}}},
    {"gate NAME [--quick] [--ledger FILE]",
     {{"gate", here, "-o", out, "--ledger", "ledger.jsonl"}}},
    {"baseline diff NAME", {{"baseline", "diff", here, "-o", out, "--ledger", "ledger.jsonl"}}},
    // Nothing has changed since: there is nothing to approve.
    {"baseline propose NAME",
     {{"baseline", "propose", here, "-o", out, "--ledger", "ledger.jsonl"}}},
    {"baseline approve NAME --who 'A. Name' --reason 'Why.'",
     {{"baseline", "approve", here, "-o", out, "--ledger", "ledger.jsonl", "--who", "A. Name",
       "--reason", "Why."}},
     4},
    {"baseline diff\\|propose\\|approve NAME [--quick] [--ledger FILE] [--new]",
     {{"baseline", "diff", here, "-o", out, "--ledger", "ledger.jsonl"}}},
    {"store", {{"store"}}},
    {"store --remove", {{"store", "--remove"}}},
    {"store [--remove]", {{"store"}}},
    {"campaign codes", {{"campaign", "codes", "--dry-run"}}},
    {"campaign codes --quick", {{"campaign", "codes", "--quick", "--dry-run"}}},
    {"campaign small_amplitude", {{"campaign", "small_amplitude", "--dry-run"}}},
    {"campaign stability", {{"campaign", "stability", "--dry-run"}}},
    {"campaign verification", {{"campaign", "verification", "--dry-run"}}},
    {"campaign zhao2021 --experiments DIR",
     {{"campaign", "zhao2021", "--experiments", ".", "--dry-run"}}},
};

// tutorial_test.cpp runs the first three, which take minutes, and compares results of the tutorial
// in the place of those of a shipped campaign.
const std::set<std::string> of_the_tutorial{
    "campaign docs/tutorial/campaign.toml -o own_tank",
    "show docs/tutorial/own_tank.toml -o own_tank.png",
    "selftest docs/tutorial/campaign.toml -o own_tank",
    "compare mine.h5 build/campaigns/small_amplitude/runs/li2010_small_amplitude/linear.h5 --case "
    "li2010_small_amplitude --gauge right --limit amplitude_error=0.03 --limit phase_lag=2 --json "
    "compared.json"};

// your_code_test.cpp runs these, and your_code_study_test.cpp the last two.
const std::string of_my_sph = " ../my_sph/campaign.toml --quick -o ../my_sph/gated";
const std::string of_its_ledger = of_my_sph + " --ledger ../my_sph/figures.jsonl";
const std::set<std::string> of_your_code{
    "gate" + of_my_sph,
    "gate" + of_its_ledger,
    "baseline propose" + of_its_ledger + " --new",
    "baseline approve" + of_its_ledger + " --new --who 'A. Name' --reason 'The first figures.'",
    "baseline diff" + of_its_ledger,
    "selftest" + of_my_sph,
    "campaign ../my_sph/campaign.toml -o ../my_sph/whole",
    "converge ../my_sph/wave.toml --family small_sph --spacings 0.05,0.04,0.02 -o "
    "../my_sph/orders"};

// python_page_test.cpp runs these before the page's code.
const std::set<std::string> of_the_python_page{
    "run li2010_small_amplitude linear -o linear.h5",
    "run li2010_small_amplitude recommended_25mm -o recommended_25mm.h5",
    "export recommended_25mm.h5 -o recommended_25mm.csv"};

// The launcher's own commands: launcher_test.sh and the tests themselves run them.
const std::set<std::string> of_the_launcher{"test", "fuzz", "bench", "doctor"};

// The names of commands that a page speaks of.
const std::set<std::string> mentioned{"baseline approve", "baseline diff", "case",   "compare",
                                      "explain",          "gate",          "import", "new",
                                      "report",           "run",           "show"};

// "./slosh  list   # all" -> "list"; a line that goes on after a backslash is one.
std::string command_of(const std::string& line) {
  std::string typed = std::regex_replace(line, std::regex(R"(\\\n)"), " ");
  typed = typed.substr(0, typed.find(" #"));
  typed = std::regex_replace(typed, std::regex(R"(\s+)"), " ");
  const std::size_t end = typed.find_last_not_of(' ');
  return typed.substr(std::string("./slosh ").size(), end + 1 - std::string("./slosh ").size());
}

TEST_F(DocumentedCommands, HaveEachARunOfTheirOwnAndNoOtherHasOne) {
  std::set<std::string> known = of_the_tutorial, documented;
  known.insert(mentioned.begin(), mentioned.end());
  known.insert(of_the_python_page.begin(), of_the_python_page.end());
  known.insert(of_your_code.begin(), of_your_code.end());
  for (const CommandRun& run : runs) known.insert(run.documented);
  for (const fs::path& document : documents::files(source))
    for (const std::string& line : command_lines(reports::read_text(document))) {
      const std::string command = command_of(line);
      if (of_the_launcher.contains(command.substr(0, command.find(' ')))) continue;
      documented.insert(command);
    }
  for (const std::string& command : known)
    EXPECT_TRUE(documented.contains(command)) << "no page has: ./slosh " << command;
  for (const std::string& command : documented)
    EXPECT_TRUE(known.contains(command)) << "no run of: ./slosh " << command;
}

TEST_F(DocumentedCommands, EndAsTheirPagesSay) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  fs::create_directory_symlink(source / "docs", directory() / "docs");
  write_campaign(small_case + particles_run + "quick = true\n" + mesh_run + gate_on("particles") +
                 gate_on("mesh"));
  for (const CommandRun& run : runs)
    for (std::vector<std::string> typed : run.typed) {
      // A state that `run --states` left.
      for (std::string& word : typed)
        if (word == "STATE") word = saved_state();
      const Ended ended = tool(typed);
      EXPECT_EQ(ended.status, run.status) << run.documented << "\n" << ended.out << ended.err;
    }
}

}  // namespace
}  // namespace slosh::documented_commands_test
