#include "verification/results/result_store.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/result_error.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_seals.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/results/timings.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::result_store_test {
namespace {

namespace fs = std::filesystem;

class Store : public ::testing::Test {
 protected:
  void put(const std::string& key, const char* extension) const {
    fs::create_directories(store.file(key, "").parent_path());
    std::ofstream(store.file(key, extension)) << "x";
  }

  TemporaryDirectory directory;
  ResultStore store{directory.path()};
};

TEST_F(Store, FindsTheResultOfAKeyBeforeAnotherBuilds) {
  EXPECT_FALSE(store.newest_file("q-a", ".h5"));
  put("q-old", ".h5");
  put("q-new", ".h5");
  put("other-a", ".h5");
  put("q-new", ".timings.json");
  fs::last_write_time(store.file("q-old", ".h5"),
                      fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(store.newest_file("q-a", ".h5"), store.file("q-new", ".h5"));
  EXPECT_EQ(store.newest_file("q-old", ".h5"), store.file("q-old", ".h5"));
  EXPECT_FALSE(store.newest_file("q-a", ".json")) << "timings are no result";
}

// A store may come from a cache or a commit: what it writes at its own names stays in it.
TEST_F(Store, WritesThroughNoLinkAtAKeyOrItsDirectory) {
  const fs::path outside = directory.path() / "outside";
  fs::create_directories(outside);
  std::ofstream(outside / "mine") << "mine";
  const auto refused = [&](const std::string& key, const fs::path& link) {
    try {
      StoreLock(store, key);
      ADD_FAILURE() << link << " was followed";
    } catch (const ResultError& error) {
      EXPECT_NE(std::string(error.what()).find(link.string() + ": is a link"), std::string::npos)
          << error.what();
    }
  };
  put("q-other", ".h5");
  for (const char* extension : {".h5", ".failure.json", ".work", ".timings.json", ".lock"}) {
    const fs::path link = store.file("q-a", extension);
    fs::create_symlink(outside / (std::string(extension) == ".work" ? "" : "mine"), link);
    if (std::string(extension) == ".lock")
      EXPECT_ANY_THROW(StoreLock(store, "q-a"));
    else
      refused("q-a", link);
    fs::remove(link);
  }
  fs::create_directory_symlink(outside, directory.path() / "p");
  refused("p-a", directory.path() / "p");
  EXPECT_EQ(std::distance(fs::directory_iterator(outside), {}), 1) << "no lock is made there";
  EXPECT_NO_THROW(StoreLock(store, "q-a"));
}

struct Kept {
  std::string key;
};

TEST_F(Store, ReadsAResultAtThePlaceOfItsWholeKeyAlone) {
  put("q-a", ".h5");
  const auto read = [](const std::string& key) {
    return [key](const fs::path&) { return Kept{key}; };
  };
  EXPECT_EQ(read_stored(store.file("q-a", ".h5"), read("q-a")).key, "q-a");
  for (const char* key : {"q-b", "p-a", "", "q-"})
    EXPECT_THROW(read_stored(store.file("q-a", ".h5"), read(key)), ResultError) << key;
}

TEST_F(Store, FindsAResultThatWasSealedAnewAndRemovesIt) {
  for (const char* key : {"q-a", "q-b", "q-c", "q-d"}) put(key, ".h5");
  const ResultSeals seals({store.file("q-a", ".h5"), store.file("q-b", ".h5"),
                           store.file("q-c", ".h5"), store.file("q-none", ".h5")});
  EXPECT_NO_THROW(seals.require_unchanged());
  fs::last_write_time(store.file("q-a", ".h5"),
                      fs::file_time_type::clock::now() - std::chrono::hours(1));
  std::ofstream(store.file("q-b", ".h5")) << "y";
  fs::remove(store.file("q-c", ".h5"));
  std::ofstream(store.file("q-d", ".h5")) << "not asked for";
  EXPECT_THROW(seals.require_unchanged(), ResultError);
  EXPECT_TRUE(fs::exists(store.file("q-a", ".h5"))) << "a copy or a touch is no change";
  EXPECT_FALSE(fs::exists(store.file("q-b", ".h5")));
  EXPECT_NO_THROW(seals.require_unchanged());
}

TEST_F(Store, ClearsAwayWhatADeadProcessHasHalfWrittenOfTheKeyAlone) {
  put("q-a", ".h5");
  const fs::path half = store.file("q-a", "").parent_path() / ".a.h5.123.partial",
                 mine = store.file("q-a", "").parent_path() / ".a.h5.124.partial",
                 others = store.file("q-a", "").parent_path() / ".b.h5.123.partial";
  for (const fs::path& file : {half, others}) std::ofstream(file) << "\x89HDF\r\n half";
  std::ofstream(mine) << "a week of work";
  const StoreLock lock(store, "q-a");
  EXPECT_FALSE(fs::exists(half));
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_TRUE(fs::exists(others));
  EXPECT_TRUE(fs::exists(store.file("q-a", ".h5")));
}

TEST_F(Store, LetsOneProcessAtATimeHoldAKeyAndForgetsADeadOne) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t holder = fork();
  if (holder == 0) {
    const StoreLock lock(store, "q-a");
    (void)!write(ready[1], "x", 1);
    for (;;) pause();
  }
  char byte;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  bool waited = false;
  std::thread killer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    waited = true;
    kill(holder, SIGKILL);
  });
  const StoreLock other(store, "q-b");
  EXPECT_FALSE(waited) << "another key waits for none";
  const StoreLock lock(store, "q-a");
  EXPECT_TRUE(waited);
  killer.join();
  waitpid(holder, nullptr, 0);
}

const std::string question(32, 'a'), answer(32, 'b'),
    other_answer(32, 'c'), kept_key = question + "-" + other_answer,
                           removed_key = question + "-" + answer;

TEST_F(Store, ListsItsKeysAndNothingElseThatLiesThere) {
  EXPECT_TRUE(ResultStore(directory.path() / "absent").keys().empty());
  put(kept_key, ".h5");
  put(removed_key, ".failure.json");
  put(question + "-" + std::string(32, 'd'), ".lock");
  put(question + "-notes", ".txt");
  put("letters-" + answer, ".h5");
  EXPECT_EQ(store.keys(), (std::vector<std::string>{removed_key, kept_key}));
}

// A result that lies under one key and holds one.
void put_result(const ResultStore& store, const std::string& under, const std::string& key) {
  RunResult result{};
  result.key = key;
  result.series = {{"elevation", "m", {0, 1}, {0, 1}}};
  write_result(result, store.file(under, ".h5"));
}

TEST_F(Store, RemovesAllThatItHasMadeUnderAKeyAndNothingOfAnother) {
  put_result(store, kept_key, kept_key);
  put_result(store, removed_key, removed_key);
  add_timing({}, store.file(removed_key, ".timings.json"));
  write_failure({}, store.file(removed_key, ".failure.json"));
  put(removed_key, ".lock");
  const fs::path half =
      store.file(removed_key, "").parent_path() / ("." + answer + ".h5.1.partial");
  std::ofstream(half) << "{\n \"body\": ";
  const fs::path work = store.file(removed_key, ".work");
  replace_own(work / "case/log", "0123456789");
  EXPECT_EQ(store.contents(removed_key).made.size(), 5u);
  EXPECT_EQ(store.contents(removed_key).size, store.size(removed_key));
  EXPECT_TRUE(store.remove(removed_key));
  EXPECT_EQ(store.keys(), std::vector<std::string>{kept_key});
  EXPECT_FALSE(fs::exists(work));
  EXPECT_EQ(store.size(removed_key), 0u);
}

TEST_F(Store, RemovesNothingThatOnlyLooksLikeWhatItHasMade) {
  put_result(store, removed_key, kept_key);  // another key's
  for (const char* extension : {".json", ".timings.json", ".failure.json", ".txt", ""})
    put(removed_key, extension);
  put(removed_key, ".lock");
  for (const char* extension : {".work", ".notes"}) {  // not on the list of what Slosh has made
    fs::create_directories(store.file(removed_key, extension));
    std::ofstream(store.file(removed_key, extension) / "mine") << "x";
  }
  fs::create_symlink("elsewhere", store.file(removed_key, ".timing.work"));
  const auto count = [&] {
    return std::distance(fs::directory_iterator(directory.path() / question), {});
  };
  const auto before = count();
  EXPECT_EQ(store.contents(removed_key).foreign.size(), static_cast<std::size_t>(before) - 1);
  EXPECT_TRUE(store.contents(removed_key).made.empty());
  EXPECT_TRUE(store.remove(removed_key));
  EXPECT_EQ(count(), before);
}

TEST_F(Store, RemovesNoWorkDirectoryWithAFileOfAUsers) {
  put_result(store, removed_key, removed_key);
  const fs::path work = store.file(removed_key, ".work");
  replace_own(work / "log", "0123456789");
  std::ofstream(work / "mine") << "a week of work";
  EXPECT_TRUE(store.remove(removed_key));
  EXPECT_TRUE(fs::exists(work / "mine"));
  EXPECT_FALSE(fs::exists(store.file(removed_key, ".h5")));
}

TEST_F(Store, TakesNoResultForItsOwnThatWasCutAlteredOrFollowedByMore) {
  put_result(store, removed_key, removed_key);
  const fs::path file = store.file(removed_key, ".h5");
  const std::string whole = read_bytes(file);
  std::string altered = whole;
  altered[altered.size() / 2] ^= 1;
  for (const std::string& text :
       {whole.substr(0, whole.size() - 1), altered, whole + "x", std::string(), removed_key}) {
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_TRUE(store.contents(removed_key).made.empty());
  }
  std::ofstream(file, std::ios::binary) << whole;
  EXPECT_EQ(store.contents(removed_key).made.size(), 1u);
}

TEST_F(Store, RemovesNothingOfAKeyThatIsHeld) {
  put_result(store, removed_key, removed_key);
  {
    const StoreLock holder(store, removed_key);
    EXPECT_FALSE(store.remove(removed_key));
    EXPECT_TRUE(fs::exists(store.file(removed_key, ".h5")));
  }
  EXPECT_TRUE(store.remove(removed_key));
  EXPECT_FALSE(fs::exists(store.file(removed_key, ".h5")));
}

TEST_F(Store, KeepsTimingsAndComparesThoseOfOneProcessor) {
  const fs::path file = directory.path() / "a.timings.json";
  EXPECT_TRUE(read_timings(file).empty());
  const auto timing = [](double user, const char* processor) {
    return Timing{{.user_time = user, .peak_memory = 1e6}, processor, "2026-01-01T00:00:00Z"};
  };
  add_timing(timing(1, "old"), file);
  add_timing(timing(2, "new"), file);
  add_timing(timing(3, "new"), file);
  ASSERT_EQ(read_timings(file).size(), 3u);
  const std::vector<RunCost> costs = comparable_costs(read_timings(file));
  ASSERT_EQ(costs.size(), 2u);
  EXPECT_EQ(costs[0].user_time, 2);
  EXPECT_EQ(costs[1].user_time, 3);
  EXPECT_EQ(costs[1].peak_memory, 1e6);
  EXPECT_TRUE(comparable_costs({}).empty());
  const std::string whole = read_bytes(file);
  std::string altered = whole;
  altered.replace(altered.find("\"user_time_s\": 2"), 16, "\"user_time_s\": 1");
  std::ofstream(file) << altered;
  EXPECT_TRUE(read_timings(file).empty()) << "a time that was altered counts for nothing";
  std::ofstream(file) << whole.substr(0, whole.size() / 2);
  EXPECT_TRUE(read_timings(file).empty()) << "they are made again";
}

}  // namespace
}  // namespace slosh::result_store_test
