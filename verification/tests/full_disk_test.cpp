// The tool on a file system of 64 kB: what was there stays, and the message and the exit status
// tell what could not be written.
#include <gtest/gtest.h>

#include "verification/files/content_hash.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::full_disk_test {
namespace {

namespace fs = std::filesystem;

// Starts the tool where `disk` is such a file system, filled from `seed` and taken to `after`.
class FullDisk : public SmallCampaign {
 protected:
  FullDisk() {
    for (const char* name : {"seed", "after", "disk"}) fs::create_directory(directory() / name);
    write_campaign(particles_case);
  }

  // In namespaces of its own; as no file system could be mounted, empty.
  std::optional<Ended> tool_on_full_disk(const std::vector<std::string>& arguments) const {
    const std::string script =
        "mount -t tmpfs -o size=64k none disk || exit 99; cp -R seed/. disk/; "
        "status=0; \"$@\" || status=$?; cp -R disk/. after/; exit $status";
    std::vector<std::string> all{"--user", "--map-root-user", "--mount", "sh", "-c", script,
                                 "sh",     SLOSH_TOOL};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const std::string unshare = boost::process::search_path("unshare").string();
    if (unshare.empty()) return std::nullopt;
    const Ended ended = end_of(start(unshare, all));
    if (ended.status == 99 || ended.err.find("unshare") != std::string::npos) return std::nullopt;
    return ended;
  }

  void expect_only(const std::vector<std::string>& files) const {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(directory() / "after"))
      if (entry.is_regular_file())
        found.push_back(entry.path().lexically_relative(directory() / "after").string());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, files);
  }

  static void expect_in(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
};

#define RUN_ON_FULL_DISK(...)                                      \
  const std::optional<Ended> ran = tool_on_full_disk(__VA_ARGS__); \
  if (!ran) GTEST_SKIP() << "no file system can be mounted here"

TEST_F(FullDisk, KeepsAnEarlierResultAndEndsWithFour) {
  write("seed/theory.h5", "an earlier result");
  write("seed/.slosh", content_hash("runan earlier result") + " theory.h5\n");
  write("seed/filling", std::string(50'000, 'x'));
  RUN_ON_FULL_DISK({"run", "./small.toml", "theory", "--output", "disk/theory.h5"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "cannot write the result file disk/theory.h5");
  expect_in(ran->err, "No space left on device");
  EXPECT_EQ(read("after/theory.h5"), "an earlier result");
  expect_only({".slosh", "filling", "theory.h5"});
}

TEST_F(FullDisk, RemovesTheVerdictOfAnEarlierReportAndEndsWithFour) {
  ASSERT_EQ(campaign().status, 0);
  write_campaign(with(particles_case, "limit = 0.3", "limit = 0.29"));  // or nothing is to be done
  fs::create_directory(directory() / "seed/report");
  write("seed/report/index.html", "an earlier report");
  write("seed/report/.slosh", content_hash("an earlier report") + " index.html\n");
  RUN_ON_FULL_DISK({"campaign", "--report-only", "./surges.toml", "--output", "disk"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  EXPECT_TRUE(ran->err.find("No space left on device") != std::string::npos ||
              ran->err.find("no space left in") != std::string::npos)
      << ran->err;
  EXPECT_NE(read("after/report/index.html"), "an earlier report");
}

TEST_F(FullDisk, RemovesAnEarlierGateDocumentAndEndsWithFour) {
  ASSERT_EQ(campaign().status, 0);
  fs::create_directory(directory() / "seed/gate");
  write("seed/gate/junit.xml", "earlier");
  write("seed/gate/.slosh", content_hash("earlier") + " junit.xml\n");
  write("seed/filling", std::string(57'000, 'x'));
  RUN_ON_FULL_DISK({"gate", "./surges.toml", "--output", "disk"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "No space left on device");
  EXPECT_FALSE(fs::exists(directory() / "after/gate/junit.xml")) << "an earlier verdict is none";
}

TEST_F(FullDisk, EndsARunWhoseSnapshotsDoNotFit) {
  RUN_ON_FULL_DISK(
      {"run", "./small.toml", "particles", "--output", "disk/particles.h5", "--snapshots", "0.1"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "cannot write a snapshot for disk/particles.work");
  EXPECT_FALSE(fs::exists(directory() / "after/particles.h5"));
}

TEST_F(FullDisk, EndsACampaignWithoutRoomForItsResultsWithFourAndSaysWhy) {
  write("seed/filling",
        std::string(4'000, 'x'));  // pages of 4 kB: those of the jobs' own files fit
  RUN_ON_FULL_DISK({"campaign", "./surges.toml", "--output", "disk/out", "--store", "disk/store"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "small/theory: no result: exit status 4: ");
  expect_in(ran->err, "No space left on device");
  expect_in(ran->out, "not compared   small particles");
}

TEST_F(FullDisk, EndsACampaignWhoseStoreIsFullWithFourAndSaysWhy) {
  write("seed/filling", std::string(50'000, 'x'));
  RUN_ON_FULL_DISK({"campaign", "./surges.toml", "--output", "out", "--store", "disk/store"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "small/theory: no result: exit status 4: ");
  expect_in(ran->err, "No space left on device");
}

TEST_F(FullDisk, AStoreThatCannotBeWrittenEndsACampaignWithFourToo) {
  const Ended ran =
      tool({"campaign", "./surges.toml", "--output", "out", "--store", "/proc/store"});
  EXPECT_EQ(ran.status, 4) << ran.out;
  expect_in(ran.err, "small/theory: no result: exit status 4: ");
  expect_in(ran.err, "/proc/store");
  expect_in(ran.out, "not compared   small particles");
}

TEST_F(FullDisk, WithoutRoomForItsListOfJobsACampaignSaysSo) {
  write("seed/filling", std::string(61'000, 'x'));
  RUN_ON_FULL_DISK({"campaign", "./surges.toml", "--output", "disk/out"});
  EXPECT_EQ(ran->status, 4) << ran->out;
  expect_in(ran->err, "No space left on device");
  expect_in(ran->err, "disk/out/");
}

TEST_F(FullDisk, IsToldOfALimitOnTheSizeOfFilesToo) {
  write("theory.h5", "an earlier result");
  write(".slosh", content_hash("runan earlier result") + " theory.h5\n");
  const Ended run = end_of(start("/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 8; exec \"$@\"", "sh",
                                             SLOSH_TOOL, "run", "./small.toml", "theory"}));
  EXPECT_EQ(run.status, 4) << run.out;
  expect_in(run.err, "cannot write the result file theory.h5");
  expect_in(run.err, "File too large");
  EXPECT_EQ(read("theory.h5"), "an earlier result");
}

}  // namespace
}  // namespace slosh::full_disk_test
