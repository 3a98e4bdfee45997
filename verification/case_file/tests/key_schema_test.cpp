// The schema of case and campaign files, by a validator that others use, on all shipped files and
// on broken ones.
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "verification/case_file/key_table.hpp"

namespace slosh::key_schema_test {
namespace {

using nlohmann::json;

const std::filesystem::path source = SLOSH_SOURCE_DIR;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

json document_of(const std::string& toml_text) {
  std::ostringstream stream;
  stream << toml::json_formatter{toml::parse(toml_text)};
  return json::parse(stream.str());
}

// Checks documents by one schema, which is parsed once.
class Checker {
 public:
  explicit Checker(const std::string& text) {
    const json parsed = json::parse(text);
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(parsed),
                                            schema_);
  }
  // What is wrong with the file, one line a complaint.
  std::string complaints(const std::string& toml_text) const {
    const json document = document_of(toml_text);
    valijson::ValidationResults results;
    valijson::Validator().validate(schema_, valijson::adapters::NlohmannJsonAdapter(document),
                                   &results);
    std::string told;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
      for (const std::string& place : error.context) told += place;
      told += ": " + error.description + "\n";
    }
    return told;
  }

 private:
  valijson::Schema schema_;
};

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return text.replace(at, from.size(), to);
}

int checked_files(const Checker& checker, const std::filesystem::path& directory) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(checker.complaints(text_of(entry.path())), "") << entry.path();
    ++files;
  }
  return files;
}

TEST(KeySchema, HoldsForAllShippedCasesAndCampaigns) {
  EXPECT_GE(checked_files(Checker(case_schema()), source / "verification/cases"), 30);
  const Checker campaigns(campaign_schema());
  EXPECT_GE(checked_files(campaigns, source / "verification/campaigns"), 6);
  EXPECT_EQ(campaigns.complaints(text_of(source / "docs/tutorial/campaign.toml")), "");
}

TEST(KeySchema, FindsWhatIsWrongInACase) {
  const Checker checker(case_schema());
  const std::string sound = text_of(source / "verification/cases/li2010_small_amplitude_ramp.toml");
  ASSERT_EQ(checker.complaints(sound), "");
  const std::vector<std::pair<std::string, std::string>> edits{
      {"length_m = 1.0", "length_m = -1.0"},
      {"length_m = 1.0", "length_m = \"1.0\""},
      {"length_m = 1.0", "lenght_m = 1.0"},
      {"length_m = 1.0", "length_m = 1.0\nwidth_m = 1.0"},
      {"type = \"sine\"", "type = \"saw\""},
      {"type = \"sine\"", "type = \"table\""},
      {"amplitude_m = 0.02\n", ""},
      {"schema_version = 1", "schema_version = 2"},
      {"solver = \"linear\"", "solver = \"linnear\""},
      {"solver = \"linear\"", "solver = \"linear\"\nparticle_spacing_m = 0.1"},
      {"modes = ", "modes = 1.5 #"},
      {"[[gauge]]", "[[gage]]"},
      {"angular_frequency_rad_s = ", "period_s = 1.0\nangular_frequency_rad_s = "},
      {"angular_frequency_rad_s = ", "# "},
      {"particle_spacing_m = 0.01", "particle_spacing_m = [0.01, \"fine\"]"},
      {"limits.phase_lag = {", "limit = 1.0\nlimits.phase_lag = {"},
      {"limits.phase_lag = {", "limmits.phase_lag = {"}};
  for (const auto& [from, to] : edits)
    EXPECT_NE(checker.complaints(with(sound, from, to)), "") << from << " -> " << to;
}

TEST(KeySchema, TakesOneShapeOfATank) {
  const Checker checker(case_schema());
  const std::string shipped =
      text_of(source / "verification/cases/li2010_small_amplitude_ramp.toml");
  const auto complaints = [&](const std::string& shape) {
    return checker.complaints(with(shipped, "length_m = 1.0\nheight_m = 1.0", shape));
  };
  EXPECT_EQ(complaints("outline_m = [[0, 0], [1.0, 0], [0.5, 1]]"), "");
  EXPECT_EQ(complaints("diameter_m = 1.0"), "");
  for (const char* wrong :
       {"", "length_m = 1.0\nheight_m = 1.0\ndiameter_m = 1.0", "diameter_m = 0",
        "outline_m = [[0, 0], [1, 0]]", "outline_m = [[0, 0], [1, 0], [0.5, 1, 2]]",
        "outline_m = [0, 0, 1, 0, 0, 1]", "outline_m = [[0, 0], [1, \"a\"], [0.5, 1]]"})
    EXPECT_NE(complaints(wrong), "") << wrong;
}

TEST(KeySchema, FindsWhatIsWrongInACampaign) {
  const Checker checker(campaign_schema());
  const std::string sound = text_of(source / "verification/campaigns/small_amplitude.toml");
  ASSERT_EQ(checker.complaints(sound), "");
  EXPECT_NE(checker.complaints(with(sound, "cases = ", "casses = ")), "");
  EXPECT_NE(checker.complaints(with(sound, "name = ", "nam = ")), "");
  EXPECT_NE(checker.complaints(with(sound, "repeats = ", "repeats = 0 #")), "");
}

}  // namespace
}  // namespace slosh::key_schema_test
