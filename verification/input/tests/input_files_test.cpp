#include "verification/input/input_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::input_files_test {
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

TEST(DefinitionFile, IsNotCalledMissingWhereItIsADirectory) {
  const TemporaryDirectory directory;
  const auto refused = [&](const char* name) {
    return message_of<CaseFileError>(
        [&] { find_definition_file("case", "./" + std::string(name), "", directory.path()); });
  };
  std::filesystem::create_directory(directory.path() / "tank");
  EXPECT_TRUE(refused("tank").ends_with("expected a file; " + (directory.path() / "tank").string() +
                                        " is a directory"));
  EXPECT_TRUE(refused("bank").ends_with("there is no " + (directory.path() / "bank").string()));
}

TEST(PlainPath, LosesItsDotsWhereItNamesTheSameFile) {
  EXPECT_EQ(plain_path("a/././b"), "a/b");
  EXPECT_EQ(plain_path("/not/there/../file"), "/not/file");
}

namespace fs = std::filesystem;

class InputFiles : public ::testing::Test {
 protected:
  InputFiles() {
    fs::create_directories(in() / "src" / "deep");
    fs::create_directories(in() / "src" / "__pycache__");
    fs::create_directories(in() / "src" / ".git");
    for (const char* file : {"src/b.py", "src/a.py", "src/deep/c.py", "src/__pycache__/a.pyc",
                             "src/.git/index", "src/.hidden", "one.cfg", "two.cfg"})
      std::ofstream(in() / file) << file;
  }
  const fs::path& in() const { return directory_.path(); }
  std::vector<std::string> names(const char* path) const {
    std::vector<std::string> found;
    for (const InputFile& one : input_files(in() / path)) found.push_back(one.name);
    return found;
  }
  using Names = std::vector<std::string>;

 private:
  TemporaryDirectory directory_;
};

TEST_F(InputFiles, OfADirectoryAreAllBelowItInOrderWithoutHiddenOnesAndCaches) {
  EXPECT_EQ(names("src"), (Names{"a.py", "b.py", "deep/c.py"}));
  EXPECT_EQ(names("src/"), (Names{"a.py", "b.py", "deep/c.py"}));
  EXPECT_EQ(names("src/.hidden"), Names{".hidden"});
}

TEST_F(InputFiles, OfAPatternAreThoseThatMatchIt) {
  EXPECT_EQ(names("*.cfg"), (Names{"one.cfg", "two.cfg"}));
  EXPECT_EQ(names("s?c"), (Names{"a.py", "b.py", "deep/c.py"}));
  EXPECT_EQ(names("*.absent"), Names{});
  EXPECT_EQ(names("absent"), Names{});
  std::ofstream(in() / "odd[1].cfg") << "";
  EXPECT_EQ(names("odd[1].cfg"), Names{"odd[1].cfg"});
}

TEST_F(InputFiles, BehindLinksCountAndACircleOfLinksEnds) {
  fs::create_directory_symlink(in() / "src", in() / "src" / "deep" / "again");
  fs::create_directories(in() / "elsewhere");
  std::ofstream(in() / "elsewhere" / "d.py") << "";
  fs::create_directory_symlink(in() / "elsewhere", in() / "src" / "linked");
  fs::create_symlink(in() / "nowhere", in() / "src" / "dangling.py");
  EXPECT_EQ(names("src"), (Names{"a.py", "b.py", "deep/c.py", "linked/d.py"}));
}

TEST_F(InputFiles, OfADirectoryThatCannotBeListedAreRefusedWithItsName) {
  const fs::path before = fs::current_path();
  fs::current_path(in() / "src/deep");
  for (int i = 0; i < 20; ++i) {  // more than a path may be long
    fs::create_directory(std::string(250, 'd'));
    fs::current_path(std::string(250, 'd'));
  }
  fs::current_path(before);
  try {
    input_files(in() / "src");
    FAIL();
  } catch (const fs::filesystem_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot list all files below"), std::string::npos);
    EXPECT_EQ(error.path1(), in() / "src");
  }
}

}  // namespace
}  // namespace slosh::input_files_test
