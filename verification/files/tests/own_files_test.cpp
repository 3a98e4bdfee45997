// What Slosh removes and replaces is what it has made, whatever other files are called.
#include "verification/files/own_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::own_files_test {
namespace {

namespace fs = std::filesystem;

class OwnFiles : public ::testing::Test {
 protected:
  fs::path made(const std::string& name) const {
    const fs::path file = temporary_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "a week of work";
    return file;
  }
  fs::path path() const { return temporary_.path(); }

 private:
  TemporaryDirectory temporary_;
};

TEST_F(OwnFiles, AreThoseThatWereClaimedBeforeTheyWereMade) {
  claim(path() / "work/run.external");
  EXPECT_TRUE(is_own(made("work/run.external/log").parent_path()));
  EXPECT_NO_THROW(claim(path() / "work/run.external")) << "again";
  const fs::path mine = made("work/mine.external/log").parent_path();
  EXPECT_FALSE(is_own(mine));
  EXPECT_THROW(claim(mine), fs::filesystem_error);
  fs::create_symlink("nowhere", path() / "work/link");
  EXPECT_THROW(claim(path() / "work/link"), fs::filesystem_error);
  EXPECT_FALSE(is_own(path() / "nowhere/file"));
}

TEST_F(OwnFiles, AreAllOfADirectoryButWhatWasAdded) {
  for (const char* file : {"report/index.html", "report/figures/a.svg"}) made(file);
  claim_all_in(path() / "report");
  EXPECT_FALSE(foreign_in(path() / "report"));
  const fs::path mine = made("report/figures/mine.svg");
  EXPECT_EQ(foreign_in(path() / "report"), mine);
}

TEST_F(OwnFiles, AreReplacedBesideOthersOfATemporaryName) {
  const std::string process = std::to_string(::getpid());
  const fs::path mine = made(".a." + process + ".partial"),
                 directory = made(".b." + process + ".partial/notes");
  replace_file(path() / "a", "new", Durability::process_crash);
  make_whole_directory(path() / "b", [](const fs::path&) {});
  EXPECT_EQ(read_bytes(path() / "a"), "new");
  EXPECT_TRUE(fs::is_directory(path() / "b"));
  for (const fs::path& file : {mine, directory}) EXPECT_EQ(read_bytes(file), "a week of work");
}

}  // namespace
}  // namespace slosh::own_files_test
