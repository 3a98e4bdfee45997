// The shipped campaign with the real solvers: its quick form passes, and a candidate of another
// gravity never does. Takes minutes.
#include "verification/tests/small_campaign.hpp"

namespace slosh::small_amplitude_campaign_test {
namespace {

namespace fs = std::filesystem;

const std::string case_name = "li2010_small_amplitude";
const std::string candidate = "interfoam_50x50";
const std::string reference = "linear_two_layer";

// The shipped case with these two runs and the candidate's gate rows alone.
std::string trimmed(const std::string& text) {
  std::string kept = text.substr(0, text.find("\n[[run]]"));
  for (std::size_t at = kept.size(); at != std::string::npos;) {
    const std::size_t next = text.find("\n[[", at + 1);
    const std::string section = text.substr(at, next - at);
    for (const std::string& line :
         {"\nname = \"" + candidate + "\"\n", "\nname = \"" + reference + "\"\n",
          "\ncandidate = \"" + candidate + "\"\n"})
      if (section.find(line) != std::string::npos) kept += section + "\n";
    at = next;
  }
  return kept;
}

class SmallAmplitudeCampaign : public SmallCampaign {
 protected:
  fs::path result_of(const std::string& output, const std::string& run) const {
    return directory() / output / "runs" / case_name / (run + ".h5");
  }
  Ended report() const {
    return tool({"campaign", "--report-only", "./surges.toml", "--output", "gated"});
  }
};

TEST_F(SmallAmplitudeCampaign, PassesAndNeverWithACandidateOfAnotherGravity) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  const Ended quick = tool({"campaign", "small_amplitude", "--quick", "--output", "quick"});
  EXPECT_EQ(quick.status, 0) << quick.err << quick.out;
  EXPECT_NE(quick.out.find("\nPASS: "), std::string::npos) << quick.out;

  // The campaign's own result passes where the case judges it alone ...
  const std::string text =
      trimmed(read(SLOSH_SOURCE_DIR "/verification/cases/" + case_name + ".toml"));
  write_campaign(text);
  fs::create_directories(result_of("gated", candidate).parent_path());
  for (const std::string& run : {candidate, reference})
    fs::copy_file(result_of("quick", run), result_of("gated", run));
  const Ended own = report();
  EXPECT_EQ(own.status, 0) << own.err << own.out;

  // ... and one of another gravity is no candidate in its place.
  write("light.toml", with(text, "gravity_m_s2 = 9.81", "gravity_m_s2 = 9.0"));
  const Ended light =
      tool({"run", "./light.toml", candidate, "--output", result_of("gated", candidate).string()});
  ASSERT_EQ(light.status, 0) << light.err;
  const Ended refused = report();
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_NE(refused.err.find("was made for another state of the case file"), std::string::npos)
      << refused.err;
  EXPECT_NE(refused.out.find("0 of 3 gate rows hold"), std::string::npos) << refused.out;
  EXPECT_EQ(refused.out.find("pass "), std::string::npos) << refused.out;
}

}  // namespace
}  // namespace slosh::small_amplitude_campaign_test
