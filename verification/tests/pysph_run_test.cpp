// PySPH in a campaign, by the driver that Slosh ships: its wave is judged, its cost is told, and a
// missing PySPH is a failure of the run that names the package.
#include <nlohmann/json.hpp>

#include "verification/tests/small_campaign.hpp"

namespace slosh::pysph_run_test {
namespace {

bool has_pysph() {
  namespace bp = boost::process;
  return bp::system("/usr/bin/python3", "-c", "import pysph", bp::std_out > bp::null,
                    bp::std_err > bp::null) == 0;
}

// The window tells the tank's period from that of the free wave.
std::string pysph_case() {
  return with(with(small_case, "duration_s = 8.0", "duration_s = 4.5"), "window_end_s = 8.0",
              "window_end_s = 4.5") +
         R"([[run]]
name = "peer"
solver = "pysph"
scheme = "edac"
particle_spacing_m = 0.05
[[gate]]
candidate = "peer"
reference = "theory"
quantity = "elevation@right"
mode = "whole"
metric = "normalised_rms"
unit = "1"
limit = 0.9
reason = "A level surface has the error 1, so the run explains something of the wave."
source = "made for a test"
)";
}

class PysphRun : public SmallCampaign {
 protected:
  nlohmann::json peer() const {
    const auto results = nlohmann::json::parse(read("out/report/results.json"));
    for (const auto& run : results.at("cases").at(0).at("runs"))
      if (run.at("name") == "peer") return run;
    throw std::logic_error("no run peer");
  }
};

TEST_F(PysphRun, IsJudgedAndTellsItsVersionItsCountsAndItsCompilation) {
  if (!has_pysph()) GTEST_SKIP() << "python3-pysph is not installed";
  write_campaign(pysph_case());
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto run = peer();
  EXPECT_EQ(run.at("method"), "pysph_edac");
  EXPECT_EQ(run.at("particle_spacing_m"), 0.05);
  EXPECT_EQ(run.at("elements"), 140);
  EXPECT_GT(run.at("steps"), 1000);
  EXPECT_EQ(run.at("provenance").at("external_version").get<std::string>().substr(0, 6), "PySPH ");
  const auto& facts = run.at("diagnostics");
  EXPECT_GT(facts.at("compile_processor_time_s"), 0);
  const std::string words = report_words();
  EXPECT_TRUE(holds(words, "Cost of a particle's step"));
  EXPECT_TRUE(holds(words, "external program pysph_tank.py, method pysph_edac"));
  // What the run cost is without the compilation, but with the start of Python.
  const double cost = run.at("user_time_s").get<double>() + run.at("system_time_s").get<double>();
  EXPECT_GT(cost, facts.at("loop_processor_time_s").get<double>());
}

TEST_F(PysphRun, FailsByThePackageThatIsMissing) {
  write("pysph.py", "raise ImportError('none is here')\n");
  write("numpy.py", "");
  write_campaign(pysph_case());
  const Ended ended = tool({"campaign", "./surges.toml", "--output", "out"},
                           {{"PYTHONPATH", directory().string()}});
  EXPECT_EQ(ended.status, 3) << ended.out << ended.err;
  EXPECT_TRUE(holds(peer().at("message").get<std::string>(), "python3-pysph"));
}

}  // namespace
}  // namespace slosh::pysph_run_test
