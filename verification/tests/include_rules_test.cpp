// What the rooms of the project may include. The table in docs/architecture.md states it; this test
// holds these rules:
// - a room includes exactly the rooms that the table names for it;
// - the leaves include nothing of the harness, directly or indirectly, and those that write reports
//   only how files are written;
// - what judges includes nothing of what draws, directly or indirectly;
// - no room and no unit (a header and its source) includes itself indirectly;
// - a folder holds at most `most_files` source files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "reports/model/report_files.hpp"
#include "verification/tests/documents.hpp"

namespace slosh::include_rules_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = SLOSH_SOURCE_DIR;
constexpr int most_files = 22;

// These rooms never include more of verification/, whatever the table says.
const std::set<std::string> leaves{"sph",           "reference",       "openfoam_cases",
                                   "reports/model", "reports/drawing", "reports/pages"};
const std::set<std::string> judges{"verification/gate", "verification/evidence"};

// "verification/gate/gate.hpp" -> "verification/gate", "sph/terms/viscosity.hpp" -> "sph"
std::string room_of(const fs::path& file) {
  auto part = file.begin();
  const fs::path first = *part++;
  const bool has_rooms = first == "verification" || first == "reports";
  return (has_rooms && std::next(part) != file.end() ? first / *part : first).string();
}

// "sph/terms/viscosity.hpp" -> "sph/terms/viscosity"
std::string unit_of(const fs::path& file) { return fs::path(file).replace_extension().string(); }

// Tests and examples stand outside the rooms: they may use any.
bool is_code(const fs::path& file) {
  for (const fs::path& part : file)
    if (part == "tests" || part == "fuzz" || part == "example" || part == "benchmarks" ||
        part == "counts")
      return false;
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

// What includes -> what it includes, each with a file that does.
using Includes = std::map<std::string, std::map<std::string, std::string>>;

struct Project {
  Includes rooms = {}, units = {};
  std::map<std::string, int> files = {};  // by folder
};

Project read_project() {
  Project project;
  for (const char* top : {"sph", "reference", "openfoam_cases", "verification", "reports"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / top)) {
      const fs::path file = fs::relative(entry.path(), source);
      if (!entry.is_regular_file() || !is_code(file)) continue;
      ++project.files[file.parent_path().string()];
      project.rooms[room_of(file)];  // even where it includes no other
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with("#include \"")) continue;
        const std::string name = line.substr(10, line.rfind('"') - 10);
        if (!fs::exists(source / name)) continue;
        if (room_of(name) != room_of(file))
          project.rooms[room_of(file)].emplace(room_of(name), file.string());
        if (unit_of(name) != unit_of(file))
          project.units[unit_of(file)].emplace(unit_of(name), file.string());
      }
    }
  }
  return project;
}

// Everything that `from` includes, directly or indirectly.
std::set<std::string> reached(const Includes& includes, const std::string& from) {
  std::set<std::string> seen;
  std::vector<std::string> open{from};
  while (!open.empty()) {
    const auto found = includes.find(open.back());
    open.pop_back();
    if (found == includes.end()) continue;
    for (const auto& [next, file] : found->second)
      if (seen.insert(next).second) open.push_back(next);
  }
  return seen;
}

// Room -> the rooms that it may include; nothing for a room that may include any.
using Allowed = std::map<std::string, std::optional<std::set<std::string>>>;

// "`case`, `sph`; `reports/`: `model`" -> verification/case, sph, reports/model
std::set<std::string> rooms_in(const std::string& cell) {
  const std::set<std::string> outside{"sph", "reference", "openfoam_cases"};
  std::set<std::string> rooms;
  std::string group = "verification/";
  for (const std::string& name : documents::all_matches(cell, "`([a-z_/]+)`")) {
    if (name == "reports/")
      group = name;
    else
      rooms.insert(outside.contains(name) ? name : group + name);
  }
  return rooms;
}

// The rows "| `room` | question | rooms |" of the table.
Allowed allowed_by(const std::string& table) {
  Allowed allowed;
  const std::regex row(R"(\n\| `([a-z_/]+)` \| [^|\n]* \| ([^|\n]*) \|)");
  for (std::sregex_iterator at(table.begin(), table.end(), row), end; at != end; ++at)
    allowed[(*at)[1]] =
        (*at)[2] == "any room" ? std::nullopt : std::optional(rooms_in((*at)[2].str()));
  return allowed;
}

// One line for each way in which the rooms and the table differ.
std::string differences(const Includes& rooms, const Allowed& allowed) {
  std::string found;
  for (const auto& [room, included] : rooms) {
    const auto row = allowed.find(room);
    if (row == allowed.end()) {
      found += room + " is not in the table\n";
      continue;
    }
    if (!row->second) continue;
    for (const auto& [other, file] : included)
      if (!row->second->contains(other))
        found += room + " includes " + other + " in " + file + "\n";
    for (const std::string& other : *row->second)
      if (!included.contains(other)) found += room + " does not include " + other + "\n";
  }
  for (const auto& [room, others] : allowed)
    if (!rooms.contains(room)) found += room + " is in the table alone\n";
  return found;
}

// One line for each of the other rules that is broken.
std::string broken_rules(const Project& project) {
  std::string broken;
  for (const std::string& leaf : leaves)
    for (const std::string& room : reached(project.rooms, leaf))
      if (room.starts_with("verification") &&
          !(leaf.starts_with("reports") && room == "verification/files"))
        broken += leaf + " reaches " + room + "\n";
  for (const std::string& judge : judges)
    for (const std::string& room : reached(project.rooms, judge))
      if (room.starts_with("reports")) broken += judge + " reaches " + room + "\n";
  for (const Includes* includes : {&project.rooms, &project.units})
    for (const auto& [one, others] : *includes)
      if (reached(*includes, one).contains(one)) broken += one + " includes itself indirectly\n";
  for (const auto& [folder, count] : project.files)
    if (count > most_files) broken += folder + " has " + std::to_string(count) + " files\n";
  return broken;
}

TEST(IncludeRules, AreKept) {
  const Project project = read_project();
  EXPECT_GE(project.rooms.size(), 30u);
  EXPECT_GE(project.units.size(), 200u);
  for (const std::string& judge : judges)
    EXPECT_FALSE(project.rooms.at(judge).empty()) << judge << " is no room of the project";
  EXPECT_EQ(broken_rules(project), "");
}

TEST(IncludeRules, AreThoseOfTheArchitecturePage) {
  const std::string page = reports::read_text(source / "docs/architecture.md");
  EXPECT_EQ(differences(read_project().rooms, allowed_by(page)), "");
}

TEST(IncludeRules, FindWhatTheTableDoesNotAllowAndWhatItAllowsInVain) {
  const Allowed allowed = allowed_by(
      "x\n| `sph` | How? | none |\n| `verification/gate` | Why? | `case`; `reports/`: `model` |\n"
      "| `verification/cli` | What? | any room |\n");
  const auto found = [&](const Includes& rooms) { return differences(rooms, allowed); };
  const Includes right{
      {"sph", {}},
      {"verification/gate", {{"verification/case", "a.cpp"}, {"reports/model", "b.cpp"}}},
      {"verification/cli", {{"sph", "c.cpp"}}}};
  EXPECT_EQ(found(right), "");
  Includes wrong = right;
  wrong["sph"] = {{"verification/case", "sph/a.hpp"}};
  EXPECT_EQ(found(wrong), "sph includes verification/case in sph/a.hpp\n");
  wrong = right;
  wrong["verification/gate"].erase("reports/model");
  EXPECT_EQ(found(wrong), "verification/gate does not include reports/model\n");
  wrong = right;
  wrong["reports/pages"] = {};
  EXPECT_EQ(found(wrong), "reports/pages is not in the table\n");
  wrong.erase("reports/pages");
  wrong.erase("verification/cli");
  EXPECT_EQ(found(wrong), "verification/cli is in the table alone\n");
}

TEST(IncludeRules, FindALeafThatKnowsTheHarness) {
  EXPECT_EQ(broken_rules({.rooms = {{"sph", {{"verification/files", "sph/a.hpp"}}}}}),
            "sph reaches verification/files\n");
}

TEST(IncludeRules, FindAJudgeThatKnowsReportsByWayOfAnotherRoom) {
  EXPECT_EQ(broken_rules({.rooms = {{"verification/gate", {{"verification/texts", "a.cpp"}}},
                                    {"verification/texts", {{"reports/tables", "b.cpp"}}}}}),
            "verification/gate reaches reports/tables\n");
}

TEST(IncludeRules, FindRoomsAndUnitsThatKnowEachOther) {
  const Includes circle{{"a", {{"b", "x"}}}, {"b", {{"c", "y"}}}, {"c", {{"a", "z"}}}};
  const std::string all =
      "a includes itself indirectly\nb includes itself indirectly\n"
      "c includes itself indirectly\n";
  EXPECT_EQ(broken_rules({.rooms = circle}), all);
  EXPECT_EQ(broken_rules({.units = circle}), all);
  EXPECT_EQ(broken_rules({.rooms = {{"a", {{"b", "x"}}}, {"b", {}}}}), "");
}

TEST(IncludeRules, FindARoomOfTooManyFiles) {
  EXPECT_EQ(broken_rules({.files = {{"reports/pages", most_files + 1}, {"sph", most_files}}}),
            "reports/pages has 23 files\n");
}

}  // namespace
}  // namespace slosh::include_rules_test
