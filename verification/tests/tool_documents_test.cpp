// What the documents say is so: every command line is one that the tool or the launcher takes,
// every link leads somewhere, and the files that a page shows are those that are shipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "reports/model/text_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_documents_test {
namespace {

namespace fs = std::filesystem;
using reports::read_text;

const fs::path source = SLOSH_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> files{source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : fs::directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  return files;
}

// The anchor that a forge gives a heading: lower case, blanks as '-', no other punctuation than '-'
// and '_'.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char letter : heading) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == ' ') anchor += '-';
    if (std::isalnum(code) || letter == '-' || letter == '_' || code >= 0x80)
      anchor += static_cast<char>(std::tolower(code));
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& file) {
  std::set<std::string> anchors;
  std::istringstream text(read_text(file));
  bool in_code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) in_code = !in_code;
    const std::size_t first = line.find_first_not_of('#');
    if (!in_code && first > 0 && first != line.npos && line[first] == ' ')
      anchors.insert(anchor_of(line.substr(first + 1)));
  }
  return anchors;
}

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

TEST(Documents, LinkToWhatIsThere) {
  int links = 0;
  for (const fs::path& document : documents())
    for (const std::string& link : all_matches(read_text(document), R"(\]\(([^)\s]+)\))")) {
      if (link.starts_with("http")) continue;
      ++links;
      const std::string name = link.substr(0, link.find('#'));
      const fs::path target = name.empty() ? document : document.parent_path() / name;
      EXPECT_TRUE(fs::exists(target)) << document << " links to " << link;
      if (link.find('#') == link.npos) continue;
      EXPECT_TRUE(anchors_of(target).contains(link.substr(link.find('#') + 1)))
          << document << " links to " << link;
    }
  EXPECT_GE(links, 60);
}

TEST(Documents, AreReachedFromTheirIndex) {
  const std::string index = read_text(source / "docs/README.md");
  for (const fs::path& document : documents())
    if (document.parent_path().filename() == "docs" && document.filename() != "README.md")
      EXPECT_TRUE(holds(index, "(" + document.filename().string() + ")"));
}

TEST(Documents, BeginWithAPageThatIsReadInMinutes) {
  EXPECT_LT(fs::file_size(source / "README.md"), 10'000u);
}

TEST(Documents, ShowTheFilesOfTheTutorialAsTheyAre) {
  const std::string tutorial = read_text(source / "docs/tutorial.md");
  for (const char* file : {"own_tank.toml", "campaign.toml"})
    EXPECT_TRUE(
        holds(tutorial, "```toml\n" + read_text(source / "docs/tutorial" / file) + "```\n"));
}

class DocumentedCommands : public SmallCampaign {
 protected:
  // The command lines of a document: in code spans, and lines of code that begin with ./slosh.
  static std::vector<std::string> command_lines(const std::string& text) {
    std::vector<std::string> lines = all_matches(text, R"(`(\./slosh [^`\n]*)`)");
    for (const std::string& line :
         all_matches(text, R"(\n *(?:- run: )?(\./slosh [^`\n]*(?:\\\n[^\n]*)*))"))
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
    for (const std::string& option : all_matches(typed, R"([\s\[|](--?[a-z][a-z-]*))"))
      if (!std::regex_search(help, std::regex("[\\s,]" + option + "[\\s,]")))
        return "no option " + option;
    return "";
  }

 private:
  std::map<std::string, std::string> helps_;
};

TEST_F(DocumentedCommands, AreThoseOfTheToolAndTheirOptionsToo) {
  std::size_t count = 0;
  for (const fs::path& document : documents())
    for (const std::string& line : command_lines(read_text(document))) {
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

}  // namespace
}  // namespace slosh::tool_documents_test
