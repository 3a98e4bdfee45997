// What the documents say is so: every link leads somewhere, and the files that a page shows are
// those that are shipped. documented_commands_test.cpp checks their command lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "reports/model/report_files.hpp"
#include "verification/tests/documents.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_documents_test {
namespace {

namespace fs = std::filesystem;
using reports::read_text;

using documents::all_matches;

const fs::path source = SLOSH_SOURCE_DIR;

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

TEST(Documents, LinkToWhatIsThere) {
  int links = 0;
  for (const fs::path& document : documents::files(source))
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
  EXPECT_LT(fs::file_size(source / "README.md"), 10'000u) << "a page that is read in minutes";
}

TEST(Documents, AreReachedFromTheirIndex) {
  const std::string index = read_text(source / "docs/README.md");
  for (const fs::path& document : documents::files(source)) {
    const std::string name = document.filename().string();
    const bool is_page = document.parent_path().filename() == "docs" && name != "README.md";
    EXPECT_TRUE(!is_page || holds(index, "(" + name + ")")) << name;
  }
}

TEST(Documents, ShowTheFilesOfTheTutorialAsTheyAre) {
  const std::string tutorial = read_text(source / "docs/tutorial.md");
  for (const char* file : {"own_tank.toml", "campaign.toml"})
    EXPECT_TRUE(
        holds(tutorial, "```toml\n" + read_text(source / "docs/tutorial" / file) + "```\n"));
}

// Returns the paragraph before each block of verdicts, and the sentences that tell where a table's
// figures come from.
std::vector<std::string> words_of_printed(const std::string& text) {
  std::vector<std::string> words =
      all_matches(text, R"((The figures of this table are of [^.]*\.))");
  const std::regex verdict("^    (pass|violated|inconclusive|PASS|FAIL)\\b");
  std::istringstream lines(text);
  std::string paragraph;
  bool is_over = true, in_block = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_verdict = std::regex_search(line, verdict);
    if (is_verdict && !in_block) words.push_back(paragraph);
    in_block = line.starts_with("    ") && (in_block || is_verdict);
    if (line.starts_with("    ")) continue;
    if (is_over) paragraph.clear();
    is_over = line.empty() && !paragraph.empty();
    if (!line.empty()) paragraph += line + "\n";
  }
  return words;
}

bool is_dated(const std::string& words) {
  return std::regex_search(words, std::regex(R"(\d+ \w+ \d{4}, commit\s[0-9a-f]{8}\b)"));
}

TEST(Documents, TellTheDateAndTheCommitOfVerdictsAndTables) {
  std::size_t count = 0;
  for (const fs::path& document : documents::files(source))
    for (const std::string& words : words_of_printed(read_text(document))) {
      ++count;
      EXPECT_TRUE(is_dated(words)) << document << ": " << words;
    }
  EXPECT_GE(count, 5u);
  EXPECT_FALSE(is_dated(words_of_printed("# A\n\nIt prints:\n\n    pass  a\n").at(0)));
}

}  // namespace
}  // namespace slosh::tool_documents_test
