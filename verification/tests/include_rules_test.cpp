// The rooms of the project and what each may include: the leaves include no other room, the gate
// includes no report, and no room includes itself by way of others.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace slosh::include_rules_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = SLOSH_SOURCE_DIR;
const std::set<std::string> leaves{"sph",
                                   "reference",
                                   "openfoam_cases",
                                   "reports",
                                   "verification/files",
                                   "verification/case_file",
                                   "verification/metrics"};

// "verification/gate/gate.hpp" -> "verification/gate", "sph/terms/viscosity.hpp" -> "sph"
std::string room_of(const fs::path& file) {
  auto part = file.begin();
  const fs::path first = *part++;
  return (first == "verification" && std::next(part) != file.end() ? first / *part : first)
      .string();
}

// Tests and examples stand outside the rooms: they may use any.
bool is_code(const fs::path& file) {
  for (const fs::path& part : file)
    if (part == "tests" || part == "fuzz" || part == "example" || part == "benchmarks" ||
        part == "counts")
      return false;
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

// Room -> the rooms that it includes, each with a file that does.
using Rooms = std::map<std::string, std::map<std::string, std::string>>;

Rooms rooms_of_project() {
  Rooms rooms;
  for (const char* top : {"sph", "reference", "openfoam_cases", "verification", "reports"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / top)) {
      const fs::path file = fs::relative(entry.path(), source);
      if (!entry.is_regular_file() || !is_code(file)) continue;
      auto& included = rooms[room_of(file)];
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with("#include \"")) continue;
        const std::string name = line.substr(10, line.rfind('"') - 10);
        if (fs::exists(source / name) && room_of(name) != room_of(file))
          included.emplace(room_of(name), file.string());
      }
    }
  }
  return rooms;
}

bool reaches(const Rooms& rooms, const std::string& from, const std::string& to,
             std::set<std::string>& seen) {
  const auto found = rooms.find(from);
  if (found == rooms.end() || !seen.insert(from).second) return false;
  for (const auto& [next, file] : found->second)
    if (next == to || reaches(rooms, next, to, seen)) return true;
  return false;
}

// One line for each rule that is broken.
std::string broken_rules(const Rooms& rooms) {
  std::string broken;
  for (const auto& [room, included] : rooms) {
    for (const auto& [other, file] : included)
      if (leaves.contains(room)) broken += room + " includes " + other + " in " + file + "\n";
    std::set<std::string> seen;
    if (room == "verification/gate" && reaches(rooms, room, "reports", seen))
      broken += "the gate includes reports\n";
    seen.clear();
    if (reaches(rooms, room, room, seen)) broken += room + " includes itself by way of others\n";
  }
  return broken;
}

TEST(IncludeRules, AreKept) {
  const Rooms rooms = rooms_of_project();
  EXPECT_GE(rooms.size(), 14u);
  EXPECT_EQ(broken_rules(rooms), "");
}

TEST(IncludeRules, FindALeafThatKnowsTheHarnessAndRoomsThatKnowEachOther) {
  EXPECT_EQ(broken_rules({{"sph", {{"verification/files", "sph/a.hpp"}}}}),
            "sph includes verification/files in sph/a.hpp\n");
  EXPECT_EQ(broken_rules({{"verification/gate", {{"reports", "a.cpp"}}}}),
            "the gate includes reports\n");
  EXPECT_EQ(broken_rules({{"a", {{"b", "x"}}}, {"b", {{"c", "y"}}}, {"c", {{"a", "z"}}}}),
            "a includes itself by way of others\nb includes itself by way of others\nc includes "
            "itself by way of "
            "others\n");
  EXPECT_EQ(broken_rules({{"a", {{"b", "x"}}}, {"b", {}}}), "");
}

}  // namespace
}  // namespace slosh::include_rules_test
