// [impacts] of a case: it is read with the table of the repeats if that is supplied, and every
// mistake is refused with its line.
#include <gtest/gtest.h>

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
const std::string peaks = "mbar\n1st 2nd 3rd 4th\n30 40 50 60\n31 41 51 61\n";

std::string text_with(const std::string& section) {
  return edited({"[comparison]", gauge + section + "[comparison]"});
}

ImpactsDefinition read_impacts_of(const std::string& section, const Workspace& experiments) {
  const Workspace workspace;
  return read_case(workspace.write("trial.toml", text_with(section)), experiments.path())
      .impacts.value();
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
}

TEST(Impacts, AreOnlyWhereACaseSaysSo) { EXPECT_FALSE(read_text(valid_text).impacts); }

TEST(Impacts, HaveTheRepeatsOfATableThatIsSuppliedForTheirTimes) {
  const Workspace experiments;
  experiments.write("peaks.txt", peaks);
  const ImpactsDefinition read =
      read_impacts_of(impacts + "peak_table = \"peaks.txt\"\n", experiments);
  EXPECT_EQ(read.repeats,
            (std::vector<std::vector<double>>{{3000, 3100}, {4000, 4100}, {5000, 5100}}));
}

TEST(Impacts, HaveNoRepeatsWhereTheTableIsNotSupplied) {
  const Workspace experiments;
  const std::string section = impacts + "peak_table = \"peaks.txt\"\n";
  const ImpactsDefinition absent = read_impacts_of(section, experiments);
  EXPECT_TRUE(absent.repeats.empty());
  EXPECT_EQ(absent.peak_table, experiments.path() / "peaks.txt");
  const ImpactsDefinition unnamed = read_text(text_with(section)).impacts.value();
  EXPECT_TRUE(unnamed.repeats.empty());
  EXPECT_EQ(unnamed.peak_table, "SLOSH_EXPERIMENTS/peaks.txt");
}

TEST(Impacts, AreRefusedByTheTablesOwnLine) {
  const Workspace workspace;
  workspace.write("peaks.txt", "mbar\n1st 2nd 3rd 4th\n30 40 50\n");
  const std::string message =
      complaint(workspace.write("trial.toml", text_with(impacts + "peak_table = \"peaks.txt\"\n")),
                workspace.path());
  EXPECT_TRUE(message.starts_with("peaks.txt:3: row = 30 40 50: expected four numbers")) << message;
}

struct Wrong {
  Edit edit;
  std::string message;
};

TEST(Impacts, AreRefusedByTheirLine) {
  const std::vector<Wrong> mistakes{
      {{"\"B\"", "\"C\""},
       "trial.toml:36: impacts.gauge = \"C\": expected a pressure gauge, which is B"},
      {{"[2.375,", "[0.3,"},
       "trial.toml:37: impacts.times_s = 0.3: expected a number from 0.4 to 19.6, in s: a quarter "
       "of the period inside the run"},
      {{"5.718]", "19.7]"}, "trial.toml:37: impacts.times_s = 19.7: expected a number from 0.4"},
      {{"[2.375, 4.073, 5.718]", "[]"},
       "trial.toml:37: impacts.times_s = (an array): expected an array of at least one number"},
      {{"times_s = [2.375, 4.073, 5.718]\n", ""},
       "trial.toml:35: impacts.times_s is missing: expected an array of at least one number"},
      {{"4.073", "2.9"},
       "trial.toml:37: impacts.times_s = (an array): expected numbers at least half a period "
       "(0.8) apart, in s"},
      {{"4.073", "nan"}, "trial.toml:37: impacts.times_s = nan: expected"},
      {{"period_s = 1.6", "period_s = 0"},
       "trial.toml:38: impacts.period_s = 0: expected a number > 0, in s"},
      {{"[3710, 4816, 4691.5]", "[3710, 4816]"},
       "trial.toml:39: impacts.peaks_Pa = (an array): expected as many numbers as times_s has, 3, "
       "in Pa"},
      {{"4816", "\"4816\""},
       "trial.toml:39: impacts.peaks_Pa = \"4816\": expected a number > 0, in Pa"},
      {{"peaks_Pa = [3710, 4816, 4691.5]\n", ""},
       "trial.toml:35: impacts.peaks_Pa is missing: expected an array of numbers, each a number > "
       "0, in Pa"},
      {{"[732, 1501, 1706]", "732"},
       "trial.toml:40: impacts.peaks_sd_Pa = 732: expected an array of numbers"},
      {{"1501", "0"}, "trial.toml:40: impacts.peaks_sd_Pa = 0: expected a number > 0, in Pa"},
      {{"= 2.45", "= -1"}, "trial.toml:41: impacts.plateau_begin_s = -1: expected a number >= 0"},
      {{"= 2.65", "= 2.45"},
       "trial.toml:42: impacts.plateau_end_s = 2.45: expected a number above plateau_begin_s "
       "(2.45) and <= duration_s (20), in s"},
      {{"= 2.65", "= 21"}, "trial.toml:42: impacts.plateau_end_s = 21: expected"},
      {{"= 670", "= inf"}, "trial.toml:43: impacts.plateau_Pa = inf: expected a number > 0, in Pa"},
      {{"source = \"a paper\"\n", ""},
       "trial.toml:35: impacts.source is missing: expected a text that is not empty"},
      {{"source", "colour = 1\nsource"},
       "trial.toml:44: impacts.colour = 1: expected only these keys here: gauge, times_s, "},
      {{"source", "peak_table = \"../peaks.txt\"\nsource"},
       "trial.toml:44: impacts.peak_table = \"../peaks.txt\": expected a peak table's path below "
       "the directory of the experiments"},
      {{"source = ", "peak_table = 3\nsource = "},
       "trial.toml:44: impacts.peak_table = 3: expected a peak table's path"}};
  for (const Wrong& mistake : mistakes) {
    std::string section = impacts;
    const std::size_t at = section.find(mistake.edit.from);
    ASSERT_NE(at, section.npos) << mistake.edit.from;
    section.replace(at, mistake.edit.from.size(), mistake.edit.to);
    const Workspace workspace;
    const std::string message = complaint(workspace.write("trial.toml", text_with(section)));
    EXPECT_TRUE(message.starts_with(mistake.message))
        << "got:    " << message << "\nwanted: " << mistake.message;
  }
}

TEST(Impacts, OfMoreTimesThanTheTableHoldsTakeNoTable) {
  const std::string five = R"([impacts]
gauge = "B"
times_s = [2, 4, 6, 8, 10]
period_s = 1.6
peaks_Pa = [1, 1, 1, 1, 1]
peaks_sd_Pa = [1, 1, 1, 1, 1]
plateau_begin_s = 2.45
plateau_end_s = 2.65
plateau_Pa = 670
source = "a paper"
)";
  EXPECT_EQ(read_text(text_with(five)).impacts->times.size(), 5u);
  const Workspace workspace;
  EXPECT_TRUE(complaint(workspace.write("trial.toml", text_with(five + "peak_table = \"p\"\n")))
                  .starts_with("trial.toml:45: impacts.peak_table = \"p\": expected at most 4 "
                               "times_s beside it, one for each impact of a row; here are 5"));
}

TEST(Impacts, NeedAPressureGauge) {
  EXPECT_TRUE(
      complaint_about({"[comparison]", impacts + "[comparison]"})
          .starts_with("trial.toml:32: impacts.gauge = \"B\": expected a pressure gauge, of "
                       "which there is none"));
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
  const std::string pressure = "wall_pressure@B";
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {row_on(pressure, "impact_1", "impact_time", "s", limit),
       "gate.metric = \"impact_time\": expected a metric, one of amplitude_error, "},
      {row_on("wall_pressure@C", "impact_1", "impact_arrival", "s", limit),
       "gate.quantity = \"wall_pressure@C\": expected the pressure at the gauge of [impacts], "
       "which "
       "is wall_pressure@B"},
      {row_on(pressure, "impact_4", "impact_arrival", "s", limit),
       "gate.mode = \"impact_4\": expected what impact_arrival is measured on, one of impact_1, "
       "impact_2, impact_3"},
      {row_on(pressure, "impact_1", "plateau_error", "1", limit),
       "gate.mode = \"impact_1\": expected what plateau_error is measured on, which is whole"},
      {row_on(pressure, "impact_1", "impact_arrival", "ms", limit),
       "gate.unit = \"ms\": expected the unit of impact_arrival, which is s"},
      {row_on(pressure, "impact_1", "impact_arrival", "s", "limit = 0.1\nreference = \"theory\""),
       "gate.reference = \"theory\": expected no reference: impact_arrival is measured on the "
       "published impacts"}};
  for (const auto& [row, wanted] : mistakes) {
    const Workspace workspace;
    const std::string message =
        complaint(workspace.write("trial.toml", text_with(impacts + arrivals) + row));
    EXPECT_NE(message.find(wanted), message.npos)
        << "got:    " << message << "\nwanted: " << wanted;
  }
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
  const auto said = [&](const std::string& section, const std::string& row) {
    const Workspace workspace;
    return complaint(workspace.write("trial.toml", text_with(section) + row));
  };
  EXPECT_NE(
      said(impacts, row_on(pressure, "impact_1", "peak_median_error", "1", limit))
          .find(
              "gate.metric = \"peak_median_error\": expected a metric that needs no peak_table in "
              "[impacts], which this case does not have"),
      std::string::npos);
  EXPECT_NE(said(table, row_on(pressure, "impact_1", "peak_ks_p_value", "1", limit))
                .find("gate = a row on peak_ks_p_value: expected lower with upper"),
            std::string::npos);
  EXPECT_NE(
      said(table, row_on(pressure, "whole", "peak_median_error", "1", limit))
          .find("gate.mode = \"whole\": expected what peak_median_error is measured on, one of "
                "impact_1"),
      std::string::npos);
}

TEST(GateOnImpacts, NeedsThem) {
  const Workspace workspace;
  const std::string row = row_on("elevation@right", "impact_1", "impact_arrival", "s", limit);
  EXPECT_NE(
      complaint(workspace.write("trial.toml", valid_text + row))
          .find("gate.metric = \"impact_arrival\": expected a metric that needs no [impacts]"),
      std::string::npos);
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
  const auto said = [](const std::string& from, const std::string& to) {
    const Workspace workspace;
    std::string section = single;
    section.replace(section.find(from), from.size(), to);
    return complaint(workspace.write("trial.toml", text_with(section)), workspace.path());
  };
  EXPECT_NE(said("sought_within_s = 0.2\n", "sought_within_s = 0.2\nperiod_s = 1\n")
                .find("no such key beside period_s"),
            std::string::npos);
  EXPECT_NE(said("arrival_share = 0.3", "arrival_share = 1").find("a number > 0 and < 1"),
            std::string::npos);
  EXPECT_NE(said("[2.36]", "[2.36, 3]").find("as many numbers as times_s has, 1, in s"),
            std::string::npos);
  EXPECT_NE(said("arrival_share = 0.3\narrivals_s = [2.36]\n", "")
                .find("no such key without arrival_share and arrivals_s"),
            std::string::npos);
  EXPECT_NE(said("rise_times_s = [0.004]\n", "").find("no such key without rise_times_s"),
            std::string::npos);
  EXPECT_NE(said("[0.004]", "[0]").find("impacts.rise_times_s = 0: expected a number > 0, in s"),
            std::string::npos);
  EXPECT_NE(said("sought_within_s = 0.2\n", "period_s = 1\n").find("peaks_sd_Pa is missing"),
            std::string::npos);
}

}  // namespace
}  // namespace slosh::impacts_section_test
