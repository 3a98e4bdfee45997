// How a gauge of the case becomes a series of interFoam's own files.
#include <gtest/gtest.h>

#include "verification/peers/tests/handed.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::openfoam_case_test {
namespace {

// In the test's mesh of 20 x 12 cells of 50 mm.
std::string with_gauge_at(const std::string& x, const std::string& more = "") {
  return replaced(moving(surges), "x_m = 0.95", "x_m = " + x) + more;
}

SeriesSource first_series(const Handed& handed) { return handed.run().series.front(); }

const std::string baffle =
    "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.5\nright_m = 0.55\nbottom_m = 0\ntop_m = 0.1\n";

TEST(OpenFoamCase, ReadsAGaugeInTheMiddleOfAColumnAsThatColumnsFilling) {
  Handed handed(with_gauge_at("0.925"));
  const SeriesSource source = first_series(handed.to("openfoam"));
  EXPECT_EQ(source.quantity, "elevation@right");
  EXPECT_EQ(source.file, "postProcessing/column_18/0/volFieldValue.dat");
  EXPECT_EQ(source.format, "openfoam_field_value");
  EXPECT_NEAR(source.scale, 0.6, 1e-12);
  EXPECT_NEAR(source.offset, -0.35, 1e-12);
  EXPECT_FALSE(holds(handed.file("README.md"), "its place"));
}

TEST(OpenFoamCase, SaysHowFarAGaugeIsFromTheColumnThatIsRead) {
  Handed handed(with_gauge_at("0.94"));
  EXPECT_EQ(first_series(handed.to("openfoam")).file,
            "postProcessing/column_18/0/volFieldValue.dat");
  EXPECT_TRUE(holds(handed.file("README.md"), "`elevation@right` is read 0.015 m to the left of"));
}

TEST(OpenFoamCase, CountsAnObstacleUnderAGaugeAndRefusesOneThatHangs) {
  Handed handed(with_gauge_at("0.525", baffle));
  const SeriesSource source = first_series(handed.to("openfoam"));
  EXPECT_NEAR(source.scale, 0.5, 1e-12);
  EXPECT_NEAR(source.offset, 0.1 - 0.35, 1e-12);
  Handed hanging(with_gauge_at(
      "0.525",
      replaced(replaced(baffle, "bottom_m = 0\n", "bottom_m = 0.4\n"), "0.1\n", "0.45\n")));
  const std::string message = message_of<CaseFileError>([&] { hanging.to("openfoam"); });
  EXPECT_TRUE(holds(message, "gauge: expected gauges in whose column"));
}

TEST(OpenFoamCase, NamesAllFilesOfTheCaseAsInputsOfTheRun) {
  Handed handed(with_gauge_at("0.925"));
  const ExternalRun run = handed.to("openfoam").run();
  const auto is_input = [&](const char* file) {
    return std::find(run.inputs.begin(), run.inputs.end(), handed.directory() / file) !=
           run.inputs.end();
  };
  for (const char* file :
       {"0/alpha.liquid", "constant/acceleration", "system/controlDict", "Allrun"})
    EXPECT_TRUE(is_input(file)) << file;
}

}  // namespace
}  // namespace slosh::openfoam_case_test
