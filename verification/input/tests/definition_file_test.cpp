#include <gtest/gtest.h>

#include <fstream>

#include "verification/input/input_files.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::definition_file_test {
namespace {

// `link` leads two directories deep: link/.. is real/one, not the directory that `link` stands in.
TEST(DefinitionFile, IsFoundBesideALinkToADirectory) {
  const TemporaryDirectory directory;
  const std::filesystem::path top = directory.path();
  std::filesystem::create_directories(top / "real/one/two");
  std::filesystem::create_directory_symlink(top / "real/one/two", top / "link");
  std::ofstream(top / "real/one/small.toml") << "name = 1\n";
  const auto file = find_definition_file("case", "../small.toml", top, top / "link");
  EXPECT_EQ(read_definition_text("case", file), "name = 1\n");
}

TEST(PlainPath, LosesItsDotsWhereItNamesTheSameFile) {
  EXPECT_EQ(plain_path("a/././b"), "a/b");
  EXPECT_EQ(plain_path("/not/there/../file"), "/not/file");
}

}  // namespace
}  // namespace slosh::definition_file_test
