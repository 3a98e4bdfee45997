// What Slosh removes and replaces is what it has made, whatever other files are called.
#include "verification/files/own_files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/protected_inputs.hpp"
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

TEST_F(OwnFiles, AreThoseThatAreAsSloshHasLeftThem) {
  const fs::path file = path() / "work/table";
  replace_own(file, "old");
  EXPECT_NO_THROW(replace_own(file, "new")) << "again";
  EXPECT_NO_THROW(require_own(path() / "work")) << "the directory with its list";
  EXPECT_EQ(read_bytes(file), "new");
  made("work/table");
  EXPECT_EQ(foreign_at(path()), file);
  EXPECT_THROW(require_own(file), fs::filesystem_error);
  std::ofstream(file, std::ios::trunc).flush();
  EXPECT_NO_THROW(require_own(file)) << "nothing is lost with an empty file";
}

// Edited or left by others.
TEST_F(OwnFiles, ReplaceNoOther) {
  const fs::path file = path() / "work/table";
  for (const char* kept : {"work/table.kept-1", "work/table.kept-2"}) {
    made("work/table");
    replace_own(file, "new");
    EXPECT_EQ(read_bytes(file), "new");
    EXPECT_EQ(read_bytes(path() / kept), "a week of work");
  }
  replace_own(path() / "work", "a file");
  EXPECT_EQ(read_bytes(path() / "work.kept-1/table.kept-2"), "a week of work");
  EXPECT_EQ(told_of_set_aside().back(), (path() / "work").string() +
                                            " is not as Slosh has left it; it is kept as "
                                            "work.kept-1");
}

TEST_F(OwnFiles, AreThoseOfTheSameContentToo) {
  replace_own(path() / "table", "new");
  fs::remove(path() / ".slosh");
  replace_own(path() / "table", "new");
  EXPECT_FALSE(foreign_at(path() / "table"));
  EXPECT_FALSE(fs::exists(path() / "table.kept-1"));
}

TEST_F(OwnFiles, LieBehindNoLinkAndAreNone) {
  const fs::path target = made("elsewhere/file");
  fs::create_directory_symlink(path() / "elsewhere", path() / "out");
  EXPECT_THROW(replace_own(path() / "out/new", "new"), fs::filesystem_error);
  fs::create_symlink(target, path() / "link");
  fs::create_symlink("nowhere", path() / "dangling");
  for (const char* link : {"link", "dangling"})
    EXPECT_THROW(replace_own(path() / link, "new"), fs::filesystem_error) << link;
  EXPECT_THROW(require_room(path() / "link"), fs::filesystem_error);
  link_own("here", path() / "shown");
  link_own("there", path() / "shown");
  EXPECT_EQ(fs::read_symlink(path() / "shown"), "there");
  EXPECT_THROW(link_own("here", path() / "link"), fs::filesystem_error);
  EXPECT_EQ(read_bytes(target), "a week of work");
  EXPECT_FALSE(fs::exists(path() / "elsewhere/new") || fs::exists(path() / "nowhere"));
}

TEST_F(OwnFiles, AreAllOfADirectoryButWhatWasAdded) {
  for (const char* file : {"report/index.html", "report/figures/a.svg"}) made(file);
  EXPECT_TRUE(foreign_at(path() / "report"));
  list_all_in(path() / "report");
  EXPECT_FALSE(foreign_at(path() / "report"));
  const fs::path mine = made("report/figures/mine.svg");
  EXPECT_EQ(foreign_at(path() / "report"), mine);
}

TEST_F(OwnFiles, AreNotToldByAListThatIsALinkOrACopy) {
  replace_own(path() / "a/table", "new");
  made("b/table");
  fs::create_symlink(path() / "a/.slosh", path() / "b/.slosh");
  EXPECT_TRUE(foreign_at(path() / "b/table"));
  EXPECT_THROW(replace_own(path() / "b/other", "new"), fs::filesystem_error);
  EXPECT_THROW(replace_named(path() / "b/.slosh", "new", "export"), OutputError);
}

TEST_F(OwnFiles, AreWhatAProgramHasLeft) {
  const std::vector places{path() / "work/log", path() / "work/run"};
  {
    const OpenOutputs outputs(places);
    for (const char* file : {"work/log", "work/run/deep/result"}) made(file);
  }
  EXPECT_FALSE(foreign_at(path() / "work"));
  { const OpenOutputs again(places); }
  EXPECT_FALSE(fs::exists(path() / "work/log.kept-1"));
  std::ofstream(path() / "work/log", std::ios::app) << "s";
  EXPECT_EQ(foreign_at(path() / "work"), places[0]);
  made("work/run/deep/mine");
  { const OpenOutputs again(places); }
  EXPECT_EQ(read_bytes(path() / "work/log.kept-1"), "a week of works");
  EXPECT_EQ(read_bytes(path() / "work/run.kept-1/deep/mine"), "a week of work");
}

// As of a process that was killed: nothing is listed, and the next start loses nothing.
TEST_F(OwnFiles, AreNotThoseOfAnInterruptedProgram) {
  const fs::path run = path() / "work/run", result = path() / "result";
  auto* const killed = new OpenOutputs({run});
  auto* const named = new OpenOutputs(result, "run");
  made("work/run/part");
  made("work/run/notes");
  made("result");
  { const OpenOutputs again({run}); }
  EXPECT_EQ(read_bytes(path() / "work/run.kept-1/notes"), "a week of work");
  EXPECT_FALSE(fs::exists(run));
  EXPECT_THROW(OpenOutputs(result, "run"), fs::filesystem_error);
  named->make_room();
  EXPECT_EQ(read_bytes(path() / "result.kept-1"), "a week of work");
  delete killed;
  delete named;
}

TEST_F(OwnFiles, OfAUsersNamingBelongToTheCommandThatLeftThem) {
  const fs::path file = path() / "truth.csv";
  replace_named(file, "old", "reference");
  replace_named(file, "new", "reference");
  EXPECT_EQ(read_bytes(file), "new");
  EXPECT_THROW(replace_named(file, "newer", "export"), fs::filesystem_error);
  EXPECT_THROW(OpenOutputs(file, "run"), fs::filesystem_error);
  EXPECT_THROW(replace_named(made("record.csv"), "new", "reference"), fs::filesystem_error);
  fs::create_directory(path() / "disk");
  fs::create_symlink("disk/big.csv", path() / "big.csv");
  replace_named(path() / "big.csv", "new", "reference");
  EXPECT_EQ(read_bytes(path() / "disk/big.csv"), "new");
  EXPECT_TRUE(fs::is_symlink(path() / "big.csv"));
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

// A stored result that another run reads as well.
TEST_F(OwnFiles, AreLinksThatLeadToAnInput) {
  const fs::path first = made("store/first"), second = made("store/second");
  link_own(first, path() / "runs/one");
  protect_input(first);
  EXPECT_NO_THROW(link_own(second, path() / "runs/one"));
  EXPECT_EQ(fs::read_symlink(path() / "runs/one"), second);
  EXPECT_EQ(read_bytes(first), "a week of work");
  EXPECT_THROW(replace_own(first, "new"), OutputError);
}

// As of `--json /dev/stdout >> log`.
TEST_F(OwnFiles, GoWhereAStandardStreamWritesToTheSameFile) {
  const fs::path log = made("log");
  const int kept = ::dup(STDOUT_FILENO), appending = ::open(log.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(appending, 0);
  ::dup2(appending, STDOUT_FILENO);
  EXPECT_NO_THROW(replace_named("/dev/stdout", "; a result", "compare"));
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  ::close(appending);
  EXPECT_EQ(read_bytes(log), "a week of work; a result");
  EXPECT_FALSE(fs::exists(path() / ".slosh"));
}

}  // namespace
}  // namespace slosh::own_files_test
