// Every command line of the documents is one that the tool or the launcher takes, with its options.
// Every command of the tool is run here, on a small campaign.
#include <gtest/gtest.h>

#include <algorithm>
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

// The result of a run of DualSPHysics, as its tools write it, and positions of particles.
const std::string gauge_file =
    (source / "verification/tests/imports/dualsphysics/GaugesSWL_right.csv").string();
const std::string particle_file =
    (source / "verification/tests/imports/particles/surface.csv").string();

// A line of each command of the tool, in the order in which a user gets to it, with what it needs
// from those before.
const std::vector<std::string> lines{
    "list li2010* --json",
    "explain --keys",
    "explain ./small.toml",
    "explain --schema campaign",
    "new my_tank --like ./small.toml",
    "explain ./my_tank.toml",
    "new my_surge --minimal",
    "case ./small.toml --for csv -o tables",
    "case ./small.toml --for pysph --spacing 0.05 -o for_pysph",
    "case ./small.toml --for openfoam -o for_openfoam",
    "case li2010_small_amplitude --for dualsphysics -o for_dualsphysics",
    "run ./small.toml theory -o theory.h5",
    "run ./small.toml particles -o particles.h5",
    "run ./small.toml particles --states 4 -o saved.h5",
    "run ./small.toml particles --resume STATE --snapshots 4 -o resumed.h5",
    "run ./small.toml mesh --time-limit 300 -o mesh.h5",
    "export particles.h5 -o p.csv",
    "export ./small.toml -o truth.csv",
    "compare particles.h5 theory.h5 --case ./small.toml --gauge right --limit amplitude_error=0.5",
    "import PARTICLES --format particles --case li2010_small_amplitude --spacing 0.1 --frame earth "
    "-o surface.h5",
    "import GAUGES --format dualsphysics_gauge --series elevation@right=swlz --datum first -o "
    "imported.h5",
    "show ./small.toml -o small.png",
    "show ./small.toml -o small.html --quantity elevation@right",
    "converge ./small.toml --family recommended --spacings 0.07,0.05,0.035",
    "run gamma_map --quick -o gamma_map.json",
    "campaign ./surges.toml -o out --dry-run",
    "campaign ./surges.toml -o out -j 1",
    "campaign ./surges.toml -o out --quick",
    "campaign ./surges.toml -o out --report-only",
    "campaign --report-only --all -o .",
    "gate ./surges.toml -o out",
    "gate ./surges.toml -o out --selftest",
    "baseline propose ./surges.toml -o out --new --ledger ledger.jsonl",
    "baseline approve ./surges.toml -o out --new --ledger ledger.jsonl --who A._Name --reason "
    "The_first_figures.",
    "baseline diff ./surges.toml -o out --ledger ledger.jsonl",
    "store",
    "store --remove",
    "campaign zhao2021 --experiments . --dry-run"};

TEST_F(DocumentedCommands, EndAsTheyShouldAndNoCommandIsLeftOut) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  write_campaign(small_case + particles_run + "quick = true\n" + mesh_run + gate_on("particles") +
                 gate_on("mesh"));
  std::set<std::string> left;
  const std::string help = tool({"--help"}).out;
  for (const std::string& command :
       documents::all_matches(help.substr(0, help.find("The launcher")), R"(\n  ([a-z]+) {5,})"))
    left.insert(command);
  EXPECT_GE(left.size(), 12u);
  for (const std::string& line : lines) {
    std::vector<std::string> words = words_of(line);
    left.erase(words.front());
    // A state that `run --states` left, and files of other programs.
    for (std::string& word : words)
      word = word == "STATE"       ? saved_state()
             : word == "GAUGES"    ? gauge_file
             : word == "PARTICLES" ? particle_file
                                   : word;
    const Ended ended = tool(words);
    // The small case misses what every case must detect.
    EXPECT_EQ(ended.status, words.back() == "--selftest" ? 1 : 0) << line << "\n"
                                                                  << ended.out << ended.err;
  }
  EXPECT_EQ(left, std::set<std::string>{});
}

}  // namespace
}  // namespace slosh::documented_commands_test
