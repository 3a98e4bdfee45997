// The user's locale: one that is not installed stops nothing, and one whose decimals are commas
// changes no number of the tool or of a program that it starts.
#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::locale_test {
namespace {

namespace fs = std::filesystem;

// Leaves t [s] and a height [m], the latter as the locale writes numbers.
const std::string shell_run = R"([[run]]
name = "shell"
solver = "external"
command = ["bash", "-c", """
echo 't [s];height [m]' > wave.csv
for ((i = 0; i <= 800; ++i)); do
  printf '%d.%02d;%.2f\n' $((i / 100)) $((i % 100)) $((i % 7)) >> wave.csv
done"""]
[[run.series]]
quantity = "elevation@right"
file = "wave.csv"
format = "csv"
column = "height"
time_column = "t"
)";

class Locale : public SmallCampaign {
 protected:
  // German, generated for the test; empty where it cannot be.
  Environment with_decimal_commas() const {
    const fs::path generated = directory() / "locales";
    fs::create_directory(generated);
    const std::string localedef = boost::process::search_path("localedef").string();
    if (localedef.empty()) return {};
    end_of(start(localedef, {"-i", "de_DE", "-f", "UTF-8", (generated / "de_DE.UTF-8").string()}));
    const Environment german{{"LOCPATH", generated.string()}, {"LC_ALL", "de_DE.UTF-8"}};
    const std::string bash = boost::process::search_path("bash").string();
    const Ended shown = end_of(start(bash, {"-c", "printf %.1f 1"}, german));
    return shown.out == "1,0" ? german : Environment{};
  }
};

TEST_F(Locale, ThatIsNotInstalledStopsNoCampaign) {
  write_campaign(small_case);
  for (const Environment& locale :
       {Environment{{"LC_ALL", "xx_YY.UTF-8"}}, Environment{{"LC_ALL", ""}, {"LANG", "xx_YY"}},
        Environment{{"LC_ALL", "C.UTF-8"}}}) {
    fs::remove_all(directory() / "out");
    const Ended ended = tool({"campaign", "./surges.toml", "--output", "out"}, locale);
    EXPECT_EQ(ended.err.find("locale"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::exists(result("theory")));
    EXPECT_TRUE(fs::exists(report() / "index.html"));
  }
}

TEST_F(Locale, WithDecimalCommasChangesNoNumber) {
  const Environment german = with_decimal_commas();
  if (german.empty()) GTEST_SKIP() << "no locale with decimal commas can be generated here";
  write("small.toml", small_case + shell_run);
  for (const char* run : {"theory", "shell"}) {
    const std::vector<std::string> arguments{"run", "./small.toml", run};
    ASSERT_EQ(tool(arguments, {{"LC_ALL", "C"}}).status, 0);
    const std::string file = run + std::string(".h5");
    const RunResult plain = read_result(directory() / file);
    fs::remove(directory() / file);
    const Ended ended = tool(arguments, german);
    EXPECT_EQ(ended.status, 0) << ended.err;
    const RunResult translated = read_result(directory() / file);
    EXPECT_EQ(translated.at("elevation@right").value, plain.at("elevation@right").value);
  }
  const Ended limits = tool({"compare", "theory.h5", "theory.h5", "--gauge", "right", "--frequency",
                             "0.477", "--limit", "phase_lag=0.5"},
                            german);
  EXPECT_TRUE(holds(limits.out, "≤ 0.5 deg"));
}

}  // namespace
}  // namespace slosh::locale_test
