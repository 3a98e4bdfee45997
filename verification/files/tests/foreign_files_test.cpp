// Nothing waits at a pipe, reads a device or follows a link in the place of a lock or a log.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "verification/files/child_process.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/guarded_reading.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/foreign/self_contained.hpp"
#include "verification/tests/hdf5_attacks.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::foreign_files_test {
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
    const auto nested = [&open = open, &close = close](int depth) {
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

// What a file does to its reader ends the reader's process apart, within its limits, and not this
// one.

std::string refusal(const std::function<void()>& read) try {
  read_guarded(0, read);
  return "";
} catch (const std::runtime_error& error) {
  return error.what();
}

TEST(GuardedReading, ReadsHereWhatAProcessApartHasRead) {
  std::vector<double> numbers;
  EXPECT_EQ(refusal([&] { numbers.push_back(3); }), "");
  EXPECT_EQ(numbers, std::vector<double>{3}) << "the other process has its own numbers";
}

TEST(GuardedReading, TellsTheExceptionAndDoesNotReadHere) {
  int reads = 0;
  const std::string words = refusal([&] {
    ++reads;
    throw std::out_of_range("no such column");
  });
  EXPECT_EQ(words, "no such column");
  EXPECT_EQ(reads, 0);
  EXPECT_EQ(refusal([] { throw std::runtime_error(std::string(1'000'000, 'x')); }).size(),
            1'000'000u);
}

TEST(GuardedReading, OutlivesACrash) {
  // The address sanitizer turns the first ones into a status of its own.
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGKILL})
    EXPECT_TRUE(holds(refusal([&] { ::raise(signal); }), "reading it ends with "));
  EXPECT_TRUE(holds(refusal([] { ::raise(SIGKILL); }), "signal 9 (Killed)"));
  EXPECT_TRUE(holds(refusal([] { ::_exit(9); }), "ends with status 9"));
}

TEST(GuardedReading, EndsWhatAsksForAllMemory) {
  EXPECT_NE(refusal([] {
              std::vector<std::string> held;
              while (true) held.emplace_back(std::size_t{1} << 24, 'x');
            }),
            "");
  EXPECT_NE(refusal([] { const std::vector<double> numbers(std::size_t{1} << 50); }), "");
}

TEST(GuardedReading, EndsWhatDoesNotEnd) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal([] {
              volatile bool goes_on = true;
              while (goes_on) {
              }
            }),
            "reading it does not end within 10 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(105));
}

TEST(GuardedReading, IsSafeBesideOtherThreads) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([] {
      for (int j = 0; j < 20; ++j)
        EXPECT_EQ(refusal([] { const std::vector<double> numbers(100'000, 1); }), "");
    });
  for (std::thread& thread : threads) thread.join();
}

// A file of HDF5 that leads into another file is refused before a value is read; one that only uses
// what HDF5 offers within a file is not.

class SelfContained : public ::testing::Test {
 protected:
  SelfContained() { write_secrets(directory_.path()); }

  // What is said of a file that `write` filled.
  std::string refusal(const std::function<void(hid_t)>& write) const {
    const hdf5::QuietErrors quiet;
    const fs::path file = directory_.path() / "a.h5";
    {
      const hdf5::Handle root(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                              H5Fclose, "make a file");
      write(root);
    }
    const hdf5::Handle root(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open");
    return message_of<hdf5::Hdf5Error>([&] { hdf5::require_self_contained(root); });
  }

  const TemporaryDirectory directory_;
};

TEST_F(SelfContained, RefusesEveryWayIntoAnotherFile) {
  for (const Hdf5Attack& attack : hdf5_attacks(directory_.path()))
    EXPECT_TRUE(holds(refusal([&](hid_t root) { attack.plant(root, "value"); }), attack.refusal))
        << attack.name;
}

TEST_F(SelfContained, TakesLinksLoopsAndFiltersWithinTheFile) {
  EXPECT_EQ(
      refusal([](hid_t root) {
        const hdf5::Handle group = hdf5::create_group(root, "group");
        hdf5::write_numbers(group, "value", {1, 2, 3});
        hdf5::checked(H5Lcreate_hard(root, "/", group, "up", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_hard(group, "value", root, "also", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_soft("/group", root, "soft", H5P_DEFAULT, H5P_DEFAULT), "");
        hdf5::checked(H5Lcreate_soft("/none", root, "dangling", H5P_DEFAULT, H5P_DEFAULT), "");
        const hdf5::Handle properties = made_with();
        hdf5::checked(H5Pset_chunk(properties, 1, &secret_length), "");
        hdf5::checked(H5Pset_shuffle(properties), "");
        hdf5::checked(H5Pset_deflate(properties, 5), "");
        add_data_set(root, "packed", properties);
      }),
      "");
}

// What a program says is shown as text: it commands no terminal and leaves XML well-formed.

TEST(Legible, TakesOutWhatCommandsATerminalOrBreaksXml) {
  const std::pair<std::string, std::string> texts[] = {
      {"\x1b[31mred\x1b[0m", "red"},
      {"\x1b[2J\x1b[1;1H\x1b[?25lPASS", "PASS"},
      {"\x1b]0;title\x07 rest", " rest"},
      {"\x1b]52;c;c2VjcmV0\x1b\\", ""},
      {"\x1bP+q544e\x1b\\", ""},
      {"12 \x1b]8;;http://x\x1b\\particles\x1b]8;;\x07 excluded", "12 particles excluded"},
      {"\x1b]0;unfinished\nnext", "\nnext"},
      {"p\bpart\u00adicles\u200b\u00a0ex\u00b0\b\b\bexcluded", "particles excluded"},
      {"\b\n\b\b.", "\n."},
      {"\x1b", ""},
      {"\x1b[", ""},
      {"\x1b[31", ""},
      {"\x1b[31\nm", "\nm"},
      {"a\x01\x02\x1f\x7f z", "a z"},
      {std::string("nul\0!", 5), "nul!"},
      {"failed\rpassed\b\b", "failedpass"},
      {"\u0085\u009b31mred", "31mred"},
      {"\u202Egnp.exe\u202C \u2066x\u2069\u200F\u061C", "gnp.exe x"},
      {"\xff\xfe latin \xe4", "\uFFFD\uFFFD latin \uFFFD"},
      {"\xed\xa0\x80", "\uFFFD\uFFFD\uFFFD"},
      {"cut \xe2\x82", "cut \uFFFD\uFFFD"},
      {"\uFFFF\uFFFE.", "."}};
  for (const auto& [text, shown] : texts)
    EXPECT_EQ(legible(text), shown) << ::testing::PrintToString(text);
}

TEST(Legible, LeavesWhatPeopleWrite) {
  for (const std::string text : {"", "a\tb\nc", "1 °C, ±0.5 m, π, 波, 🌊", "[31m", "\u200D"})
    EXPECT_EQ(legible(text), text);
}

TEST(LegibleMessage, ShortensALongLineAndNoOther) {
  const std::string as(10'000'000, 'a'), bs(400, 'b');
  EXPECT_EQ(legible_message("x: row = " + as + ": expected 2 values\n" + bs + "\n"),
            "x: row = " + as.substr(0, 491) + " ... (10000028 characters) ... " +
                as.substr(0, 281) + ": expected 2 values\n" + bs + "\n");
  EXPECT_EQ(legible_message("\x1b[31m" + bs), bs);
  EXPECT_EQ(legible_message(""), "");
}

}  // namespace
}  // namespace slosh::foreign_files_test
