// [impacts] of a case: it is read with the table of the repeats if that is supplied, and every
// mistake is refused with its line.
#include <gtest/gtest.h>

#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::impacts_section_test {
namespace {

const std::string gauge =
    "[[pressure_gauge]]\nname = \"B\"\nwall = \"left\"\nposition_m = 0.1\n";  // from line 31 on
const std::string impacts = R"([impacts]
gauge = "B"
times_s = [2.375, 4.073, 5.718]
period_s = 1.6
peaks_Pa = [3710, 4816, 4691.5]
peaks_sd_Pa = [732, 1501, 1706]
plateau_begin_s = 2.45
plateau_end_s = 2.65
plateau_Pa = 670
source = "a paper"
)";
const std::string arrivals = "arrival_share = 0.3\narrivals_s = [2.37, 4.06, 5.7]\n";

std::string text_with(const std::string& section) {
  return edited({"[comparison]", gauge + section + "[comparison]"});
}

TEST(Impacts, AreReadAsPublished) {
  const ImpactsDefinition read = read_text(text_with(impacts)).impacts.value();
  EXPECT_EQ(read.gauge, "B");
  EXPECT_EQ(read.times, (std::vector<double>{2.375, 4.073, 5.718}));
  EXPECT_EQ(read.period, 1.6);
  EXPECT_EQ(read.peak_means, (std::vector<double>{3710, 4816, 4691.5}));
  EXPECT_EQ(read.peak_deviations, (std::vector<double>{732, 1501, 1706}));
  EXPECT_EQ(read.plateau_begin, 2.45);
  EXPECT_EQ(read.plateau_end, 2.65);
  EXPECT_EQ(read.plateau, 670);
  EXPECT_TRUE(read.peak_table.empty());
  EXPECT_TRUE(read.repeats.empty());
  EXPECT_EQ(read.source, "a paper");
  EXPECT_FALSE(read_text(valid_text).impacts);
}

TEST(Impacts, HaveTheRepeatsOfATableWhereItIsSupplied) {
  const std::string text = with_keys(text_with(impacts), "impacts.peak_table = \"peaks.txt\"");
  const std::string peaks = "mbar\n1st 2nd 3rd 4th\n30 40 50 60\n31 41 51 61\n";
  EXPECT_EQ(read_trial({text, {{"peaks.txt", peaks}}}).impacts->repeats,
            (std::vector<std::vector<double>>{{3000, 3100}, {4000, 4100}, {5000, 5100}}));
  const ImpactsDefinition absent = read_trial(text).impacts.value();
  EXPECT_TRUE(absent.repeats.empty());
  EXPECT_EQ(absent.peak_table.filename(), "peaks.txt");
  const ImpactsDefinition unnamed = read_text(text).impacts.value();
  EXPECT_TRUE(unnamed.repeats.empty());
  EXPECT_EQ(unnamed.peak_table, "SLOSH_EXPERIMENTS/peaks.txt");
  expect_refusals_of(
      "peaks.txt", text,
      "mbar | 1st 2nd 3rd 4th | 30 40 50 -> 3: row = 30 40 50: expected four numbers");
}

TEST(Impacts, AreRefusedByTheirLine) {
  expect_refusals(text_with(impacts), R"(
impacts.gauge = "C": expected a pressure gauge, which is B
impacts.times_s = [0.3, 4.073, 5.718] -> impacts.times_s = 0.3: expected a number from 0.4 to 19.6,
  in s: a quarter of the period inside the run
impacts.times_s = [] -> impacts.times_s = (an array): expected an array of at least one number
impacts.times_s = [2.375, 2.9, 5.718] -> impacts.times_s = (an array): expected numbers at least half
  a period (0.8) apart, in s
impacts.peaks_Pa = [3710, 4816] -> impacts.peaks_Pa = (an array): expected as many numbers as times_s
  has, 3, in Pa
impacts.peaks_Pa = [3710, "4816", 4691.5] -> impacts.peaks_Pa = "4816": expected a number > 0, in Pa
impacts.plateau_end_s = 2.45: expected a number above plateau_begin_s (2.45) and <= duration_s (20),
  in s
impacts.peak_table = "../peaks.txt": expected a peak table's path below the directory of the
  experiments
)");
  expect_refusals(with_keys(text_with(impacts),
                            "impacts.times_s = [2, 4, 6, 8, 10] & impacts.peaks_Pa = [1, 1, 1, 1, "
                            "1] & impacts.peaks_sd_Pa = [1, 1, 1, 1, 1]"),
                  R"(
impacts.source = "five": accepted
impacts.peak_table = "p": expected at most 4 times_s beside it, one for each impact of a row; here
  are 5
)");
  expect_refusals(valid_text + impacts, R"(
-> impacts.gauge = "B": expected a pressure gauge, of which there is none
)");
}

std::string gate_row(const std::string& keys) {
  return "[[gate]]\ncandidate = \"coarse\"\n" + keys + "reason = \"r\"\nsource = \"s\"\n";
}

std::string row_on(const std::string& quantity, const std::string& mode, const std::string& metric,
                   const std::string& unit, const std::string& bound) {
  return gate_row("quantity = \"" + quantity + "\"\nmode = \"" + mode + "\"\nmetric = \"" + metric +
                  "\"\nunit = \"" + unit + "\"\n" + bound + "\n");
}

constexpr const char* limit = "limit = 0.1";
constexpr const char* bounds = "lower = 0.05\nupper = 0.95";

TEST(GateOnImpacts, TakesThePressureAtTheirGauge) {
  std::string text = text_with(impacts + arrivals);
  text.replace(text.find("position_m = 0.1\n"), 16, "position_m = 0.1\nfilter_cutoff_Hz = 20");
  const CaseDefinition definition =
      read_text(text + row_on("wall_pressure@B", "impact_3", "impact_arrival", "s", limit) +
                row_on("wall_pressure@B/filtered", "whole", "plateau_error", "1", limit) +
                row_on("wall_pressure@B", "impact_1", "impact_peak_error", "1", bounds));
  EXPECT_EQ(definition.gate.at(1).metric, Metric::impact_arrival);
  EXPECT_EQ(definition.gate[1].mode, "impact_3");
  EXPECT_TRUE(definition.gate[1].reference.empty());
  EXPECT_EQ(definition.gate.at(2).quantity, "wall_pressure@B/filtered");
  EXPECT_EQ(definition.gate.at(3).between, (std::pair{0.05, 0.95}));
}

TEST(GateOnImpacts, IsRefusedByItsLine) {
  const std::string arrival = row_on("wall_pressure@B", "impact_1", "impact_arrival", "s", limit);
  expect_refusals(text_with(impacts + arrivals) + arrival, R"(
gate.quantity = "wall_pressure@C": expected the pressure at the gauge of [impacts], which is
  wall_pressure@B
gate.mode = "impact_4": expected what impact_arrival is measured on, one of impact_1, impact_2,
  impact_3
gate.metric = "plateau_error" & gate.unit = "1" -> gate.mode = "impact_1": expected what
  plateau_error is measured on, which is whole
gate.unit = "ms": expected the unit of impact_arrival, which is s
gate.reference = "theory": expected no reference: impact_arrival is measured on the published impacts
)");
  expect_refusals(valid_text + arrival, R"(
gate.quantity = "elevation@right" -> gate.metric = "impact_arrival": expected a metric that needs no
  [impacts]
)");
}

TEST(GateOnImpacts, TakesThePeaksOfAnEnsembleAgainstTheTableOfRepeats) {
  const std::string pressure = "wall_pressure@B", table = impacts + "peak_table = \"p.txt\"\n";
  const CaseDefinition definition =
      read_text(text_with(table) + "[[gate]]\ncandidate = \"coarse\"\nquantity = \"" + pressure +
                "\"\nmodes = [\"impact_1\", \"impact_3\"]\n"
                "limits.peak_ks_p_value = { lower = 0.05, upper = 1 }\n"
                "limits.peak_median_error = 0.2\nreason = \"r\"\nsource = \"s\"\n");
  ASSERT_EQ(definition.gate.size(), 5u);
  EXPECT_EQ(definition.gate[1].between, (std::pair{0.05, 1.0}));
  EXPECT_TRUE(definition.gate[1].reference.empty());
  const std::string median = row_on(pressure, "impact_1", "peak_median_error", "1", limit);
  expect_refusals(text_with(table) + median, R"(
gate.metric = "peak_ks_p_value" -> gate = a row on peak_ks_p_value: expected lower with upper
gate.mode = "whole": expected what peak_median_error is measured on, one of impact_1
)");
  expect_refusals(text_with(impacts) + median, R"(
-> gate.metric = "peak_median_error": expected a metric that needs no peak_table in [impacts], which
  this case does not have
)");
}

const std::string single = R"([impacts]
gauge = "B"
times_s = [2.375]
sought_within_s = 0.2
peaks_Pa = [3710]
arrival_share = 0.3
arrivals_s = [2.36]
arrivals_half_width_s = 0.001
impulse_duration_s = 0.07
impulses_Pa_s = [120]
rise_times_s = [0.004]
rise_times_half_width_s = 0.0005
source = "a paper"
)";

TEST(Impacts, MayBeASingleOneWithItsArrivalAndItsImpulse) {
  const ImpactsDefinition read = read_text(text_with(single)).impacts.value();
  EXPECT_EQ(read.period, 0.8);
  EXPECT_EQ(read.plateau, 0);
  EXPECT_TRUE(read.peak_deviations.empty());
  ASSERT_TRUE(read.arrivals && read.impulses);
  EXPECT_EQ(read.arrivals->share, 0.3);
  EXPECT_EQ(read.arrivals->times, std::vector<double>{2.36});
  EXPECT_EQ(read.arrivals->half_width, 0.001);
  EXPECT_EQ(read.impulses->duration, 0.07);
  EXPECT_EQ(read.impulses->values, std::vector<double>{120});
  EXPECT_FALSE(read.impulses->half_width);
  EXPECT_EQ(read.rise_times.value().values, std::vector<double>{0.004});
  EXPECT_EQ(read.rise_times->half_width, 0.0005);
}

TEST(Impacts, AreRefusedWhereASingleOneIsMistaken) {
  expect_refusals(text_with(single), R"(
impacts.period_s = 1 -> impacts.sought_within_s = 0.2: expected no such key beside period_s
impacts.arrivals_s = [2.36, 3] -> impacts.arrivals_s = (an array): expected as many numbers as
  times_s has, 1, in s
impacts.arrival_share is missing & impacts.arrivals_s is missing -> impacts.arrivals_half_width_s =
  0.001: expected no such key without arrival_share and arrivals_s
impacts.rise_times_s is missing -> impacts.rise_times_half_width_s = 0.0005: expected no such key
  without rise_times_s
impacts.sought_within_s is missing & impacts.period_s = 1 -> impacts.peaks_sd_Pa is missing: expected
)");
}

}  // namespace
}  // namespace slosh::impacts_section_test
