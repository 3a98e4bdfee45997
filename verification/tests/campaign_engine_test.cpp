// What a campaign computes, and that it computes nothing twice, whatever befalls it.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "verification/results/result_file.hpp"
#include "verification/tests/comes_true.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::campaign_engine_test {
namespace {

namespace fs = std::filesystem;

const std::string sweep = R"([[sweep]]
cases = ["small"]
name = "{scheme}_{courant_number}"
solver = "sph"
scheme = ["recommended", "delta_sph"]
particle_spacing_m = 0.05
courant_number = [0.3, 0.4]
)";

class CampaignEngine : public SmallCampaign {
 protected:
  void write_swept(const std::string& more = "") const {
    write_campaign(particles_case);
    write("surges.toml", read("surges.toml") + sweep + more);
  }
  // By file of the store: when it was written.
  std::map<fs::path, fs::file_time_type> written() const {
    std::map<fs::path, fs::file_time_type> times;
    for (const fs::path& file : files_of_store(".h5")) times[file] = fs::last_write_time(file);
    return times;
  }
  static int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      ++n;
    return n;
  }
};

TEST_F(CampaignEngine, ComputesEveryRunOfASweepOnce) {
  write_swept();
  const Ended first = campaign();
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(count(first.err, "finished small/"), 6);
  EXPECT_EQ(files_of_store(".h5").size(), 6u);
  EXPECT_NO_THROW(read_result(result("delta_sph_0p4")));
  EXPECT_EQ(read_result(result("delta_sph_0p4")).provenance.at("command"),
            "./slosh run '" + (directory() / "small.toml").string() +
                "' delta_sph_0p4 --output delta_sph_0p4.h5 --campaign '" +
                (directory() / "surges.toml").string() + "'");
  const auto times = written();
  const Ended second = campaign();
  EXPECT_EQ(second.out, first.out);
  EXPECT_EQ(second.err, "");
  EXPECT_EQ(written(), times);
}

TEST_F(CampaignEngine, SharesWhatAnotherCampaignHasComputed) {
  write_swept();
  ASSERT_EQ(campaign().status, 0);
  const auto times = written();
  write("small.toml", with(read("small.toml"), "name = \"small\"", "name = \"twin\""));
  write("surges.toml", with(with(read("surges.toml"), "\"surges\"", "\"twins\""),
                            "cases = [\"small\"]", "cases = [\"twin\"]"));
  const Ended twin = tool({"campaign", "./surges.toml", "--output", "out2"});
  EXPECT_EQ(twin.status, 0) << twin.err;
  EXPECT_EQ(twin.err, "");
  EXPECT_EQ(written(), times);
  EXPECT_TRUE(fs::exists(directory() / "out2/runs/twin/delta_sph_0p3.h5"));
}

TEST_F(CampaignEngine, TellsWhatItWouldDoAndStartsNothing) {
  write_swept("[timing]\nrepeats = 2\n");
  const Ended told = tool({"campaign", "./surges.toml", "--output", "out", "--dry-run"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(count(told.out, "run      small/"), 6) << told.out;
  EXPECT_EQ(count(told.out, "time     small/"), 12) << told.out;
  EXPECT_EQ(count(told.out, "slosh run "), 18) << "the commands";
  EXPECT_NE(told.out.find("0 kept, 6 to run, 0 left out; 6 of unknown cost"), std::string::npos)
      << told.out;
  EXPECT_FALSE(fs::exists(store()));
  EXPECT_FALSE(fs::exists(directory() / "out/runs"));
  ASSERT_EQ(tool({"campaign", "./surges.toml", "--output", "out", "--timings", "0"}).status, 0);
  const Ended kept = tool({"campaign", "./surges.toml", "--output", "out", "--dry-run"});
  EXPECT_EQ(count(kept.out, "kept     small/"), 6) << kept.out;
  EXPECT_NE(kept.out.find("6 kept, 0 to run"), std::string::npos) << kept.out;
  EXPECT_NE(kept.out.find("12 timings one after another"), std::string::npos) << kept.out;
}

TEST_F(CampaignEngine, CountsWhatTwoCasesShareOnceBeforeItStarts) {
  write_swept("[timing]\nrepeats = 2\n");
  write("twin.toml", with(read("small.toml"), "name = \"small\"", "name = \"twin\""));
  write("surges.toml",
        with(with(read("surges.toml"), "\"./small.toml\"", "\"./small.toml\", \"./twin.toml\""),
             "cases = [\"small\"]", "cases = [\"small\", \"twin\"]"));
  const Ended told = tool({"campaign", "./surges.toml", "--output", "out", "--dry-run"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(count(told.out, "kept     twin/"), 6) << told.out;
  EXPECT_NE(
      told.out.find("6 kept, 6 to run, 0 left out; 6 of unknown cost, not counted; 12 timings"),
      std::string::npos)
      << told.out;
}

TEST_F(CampaignEngine, ResumesOnlyWhatWasStarted) {
  write_swept();
  const Ended none = tool({"campaign", "./surges.toml", "--output", "out", "--resume"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("--resume: expected an earlier start"), std::string::npos) << none.err;
  ASSERT_EQ(campaign().status, 0);
  EXPECT_EQ(tool({"campaign", "./surges.toml", "--output", "out", "--resume"}).status, 0);
}

TEST_F(CampaignEngine, GoesOnAfterItsProcessWasKilledAndRepeatsWhatIsMissingAlone) {
  write_swept();
  write("small.toml", with(read("small.toml"), "duration_s = 8.0", "duration_s = 40.0"));
  auto child = start_tool({"campaign", "./surges.toml", "--output", "out", "--jobs", "2"});
  ASSERT_TRUE(comes_true([&] { return files_of_store(".h5").size() >= 2; }, patience));
  kill(child.id(), SIGKILL);
  EXPECT_EQ(end_of(std::move(child)).status, -SIGKILL);
  const auto before = written();
  ASSERT_GE(before.size(), 2u);
  ASSERT_LT(before.size(), 6u);
  const Ended again = tool({"campaign", "./surges.toml", "--output", "out", "--resume"});
  EXPECT_EQ(again.status, 0) << again.err;
  const auto after = written();
  EXPECT_EQ(after.size(), 6u);
  for (const auto& [file, time] : before) EXPECT_EQ(after.at(file), time) << file;
}

TEST_F(CampaignEngine, RepeatsWhatWasRemovedCutOrHalfWrittenAlone) {
  write_swept();
  ASSERT_EQ(campaign().status, 0);
  const auto before = written();
  const fs::path removed = fs::read_symlink(result("delta_sph_0p3")),
                 cut = fs::read_symlink(result("particles"));
  const std::string half = read(removed).substr(0, 1000);
  fs::remove(removed);
  fs::resize_file(cut, fs::file_size(cut) / 2);
  write(fs::relative(removed.parent_path(), directory()).string() + "/." +
            removed.filename().string() + ".77.partial",
        half);
  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(count(again.err, "finished small/"), 2) << again.err;
  const auto after = written();
  ASSERT_EQ(after.size(), 6u);
  for (const auto& [file, time] : before)
    EXPECT_EQ(after.at(file) == time, file != removed && file != cut) << file;
  EXPECT_NO_THROW(read_result(cut));
  EXPECT_TRUE(files_of_store(".partial").empty());
}

// Neither the size of a file nor the time it was written tells what it holds.
TEST_F(CampaignEngine, RepeatsNoVerdictOfAResultWhoseBytesHaveChanged) {
  write_swept();
  ASSERT_EQ(campaign().status, 0);
  EXPECT_EQ(campaign().err, "") << "what is left is said again";
  const fs::path altered = fs::read_symlink(result("particles"));
  const auto time = fs::last_write_time(altered);
  std::string bytes = read(altered);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(altered, std::ios::binary) << bytes;
  fs::last_write_time(altered, time);
  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(holds(again.err, "it has been altered"));
  EXPECT_EQ(count(again.err, "finished small/"), 1) << again.err;
  EXPECT_NO_THROW(read_result(altered));
}

TEST_F(CampaignEngine, LetsTwoCampaignsWorkOnOneStoreAtOnce) {
  write_swept();
  namespace bp = boost::process;
  std::vector<bp::child> both;
  for (const char* output : {"out", "out2"}) {
    bp::environment environment = boost::this_process::environment();
    environment["OMP_NUM_THREADS"] = "1";
    environment["SLOSH_STORE"] = store().string();
    both.emplace_back(bp::exe = SLOSH_TOOL,
                      bp::args = {"campaign", "./surges.toml", "--output", output}, environment,
                      bp::start_dir = directory().string(),
                      bp::std_out > (directory() / (output + std::string(".out"))).string(),
                      bp::std_err > bp::null, bp::std_in < bp::null);
  }
  for (bp::child& one : both) {
    one.wait();
    EXPECT_EQ(one.exit_code(), 0);
  }
  EXPECT_EQ(files_of_store(".h5").size(), 6u);
  EXPECT_TRUE(files_of_store(".partial").empty());
  for (const fs::path& file : files_of_store(".h5")) EXPECT_NO_THROW(read_result(file));
  const std::string one = read("out.out"), other = read("out2.out");
  EXPECT_EQ(one.substr(0, one.find("report:")), other.substr(0, other.find("report:")));
}

TEST_F(CampaignEngine, TellsOfAFullDiskAndGoesOnOnceThereIsRoom) {
  write_swept();
  // A limit on the size of files stands for a disk without room: nothing above 16 kB is written.
  const std::string limited = "ulimit -f 32; exec \"$0\" \"$@\"";
  const Ended full = end_of(start(
      "/bin/sh", {"-c", limited, SLOSH_TOOL, "campaign", "./surges.toml", "--output", "out"}));
  EXPECT_EQ(full.status, 4) << full.err;
  EXPECT_NE(full.err.find("cannot write the result file"), std::string::npos) << full.err;
  for (const fs::path& file : files_of_store(".h5")) EXPECT_NO_THROW(read_result(file));
  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(files_of_store(".h5").size(), 6u);
  EXPECT_TRUE(files_of_store(".partial").empty());
}

TEST_F(CampaignEngine, TimesRunsAloneAndOnlyWhereTheAnswerIsTheSame) {
  write_swept("[timing]\nrepeats = 2\n");
  const Ended timed = campaign();
  ASSERT_EQ(timed.status, 0) << timed.err;
  const auto timings = files_of_store(".timings.json");
  EXPECT_EQ(timings.size(), 6u);
  for (const fs::path& file : timings) {
    const auto entries = nlohmann::json::parse(read(file.string())).at("body").at("timings");
    ASSERT_EQ(entries.size(), 2u) << file;
    EXPECT_GT(entries[1].at("wall_time_s"), 0);
  }
  const auto results = nlohmann::json::parse(read("out/report/results.json"));
  EXPECT_EQ(results.at("exit_status"), 0);
  EXPECT_EQ(campaign().err, "") << "timings are kept";

  // Another answer under the same key: its timing is none of that result.
  RunResult other = read_result(result("particles"));
  other.series.at(0).value.back() += 1e-12;
  write_result(other, fs::read_symlink(result("particles")));
  const Ended refused =
      tool({"run", "./small.toml", "particles", "--store", store().string(), "--timing"});
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_NE(refused.err.find("expected the same "), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace slosh::campaign_engine_test
