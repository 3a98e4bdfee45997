// Nothing waits at a pipe, reads a device or follows a link in the place of a lock or a log.
#include "verification/files/foreign/plain_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "verification/files/child_process.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::plain_file_test {
namespace {

namespace fs = std::filesystem;

class PlainFile : public ::testing::Test {
 protected:
  PlainFile() {
    ::mkfifo((place() / "pipe").c_str(), 0600);
    std::ofstream(place() / "text") << "kept";
    fs::create_symlink("text", place() / "link");
    fs::create_symlink("none", place() / "dangling");
    fs::create_symlink("pipe", place() / "link_to_pipe");
  }
  fs::path place() const { return directory_.path(); }

 private:
  const TemporaryDirectory directory_;
};

TEST_F(PlainFile, IsAFileOfADiskAlone) {
  EXPECT_TRUE(is_plain_file(place() / "text"));
  EXPECT_TRUE(is_plain_file(place() / "link"));
  const fs::path others[] = {place() / "pipe",     place() / "link_to_pipe",
                             place() / "dangling", place(),
                             "/dev/zero",          "/proc/self/environ",
                             "/proc/version",      "/sys/kernel/mm/transparent_hugepage/enabled"};
  for (const fs::path& other : others) {
    EXPECT_FALSE(is_plain_file(other)) << other;
    EXPECT_THROW(read_bytes(other), fs::filesystem_error) << other;
  }
}

TEST_F(PlainFile, IsWhatALockIs) {
  for (const char* other : {"pipe", "link", "dangling"})
    EXPECT_THROW(FileLock(place() / other), fs::filesystem_error) << other;
  const FileLock lock(place() / "new.lock");
  EXPECT_EQ(fs::status(place() / "new.lock").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(PlainFile, IsWhatALogIs) {
  for (const char* other : {"pipe", "link", "dangling"})
    EXPECT_THROW(ChildProcess({"/bin/echo", "x"}, {.log_file = place() / other}), std::system_error)
        << other;
  EXPECT_EQ(read_bytes(place() / "text"), "kept");
  EXPECT_FALSE(fs::exists(place() / "none"));
}

// The lock for the choice of cores is held by another process for ever.
TEST_F(PlainFile, IsNotWaitedForWhereItIsTheLockOfTheCores) {
  ::setenv("TMPDIR", place().c_str(), 1);
  const fs::path directory = place() / ("slosh-" + std::to_string(::getuid()));
  ChildProcess first({"/bin/true"}, {.log_file = place() / "log", .cores = 1});
  EXPECT_EQ(fs::status(directory).permissions(), fs::perms::owner_all);
  const int other = ::open((directory / "cores.lock").c_str(), O_RDWR);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  ChildProcess held({"/bin/true"}, {.log_file = place() / "log", .cores = 1});
  ::close(other);
  fs::permissions(directory, fs::perms::all);
  fs::remove(directory / "cores.lock");
  ChildProcess open_to_all({"/bin/true"}, {.log_file = place() / "log", .cores = 1});
  EXPECT_FALSE(fs::exists(directory / "cores.lock")) << "others may write there";
  ::unsetenv("TMPDIR");
}

TEST(JsonText, IsRefusedWhereItIsNestedTooDeep) {
  for (const auto& [open, close] : {std::pair{"[", "]"}, std::pair{"{\"a\":", "}"}}) {
    const auto nested = [&](int depth) {
      std::string text, end;
      for (int i = 0; i < depth; ++i) {
        text += open;
        end += close;
      }
      return text + "1" + end;
    };
    EXPECT_NO_THROW(parsed_json<nlohmann::json>(nested(100)));
    for (const int depth : {102, 20'000, 200'000}) {
      EXPECT_THROW(parsed_json<nlohmann::json>(nested(depth)), nlohmann::json::exception);
      EXPECT_THROW(parsed_json<nlohmann::ordered_json>(nested(depth)), nlohmann::json::exception);
    }
  }
}

}  // namespace
}  // namespace slosh::plain_file_test
