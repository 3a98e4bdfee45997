// Gate rows on impacts: each holds of a run that does as the experiment and turns red on every way
// in which a run can be wrong.
#include "verification/gate/impact_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/gate/gate.hpp"
#include "verification/tests/impact_results.hpp"

namespace slosh::impact_metrics_test {
namespace {

double limit_of(Metric metric) {
  return metric == Metric::impact_arrival ? 0.05 : 0.2;  // [s], 1
}

GateRow row_of(Metric metric, const std::string& mode) {
  GateRow row{};
  row.candidate = "particles";
  row.quantity = impact_pressure;
  row.mode = mode;
  row.metric = metric;
  row.unit = metric_unit(metric, "Pa");
  row.limit = limit_of(metric);
  return row;
}

// The case publishes the arrivals and impulses of a run that does as the experiment.
CaseDefinition case_with_arrivals() {
  const TimeSeries pressure = pressure_of({});
  CaseDefinition definition = impact_case();
  ImpactsDefinition& impacts = definition.impacts.value();
  impacts.arrivals = ArrivalsDefinition{.share = 0.5, .times = {}};
  impacts.impulses = ImpulsesDefinition{.duration = 0.05, .values = {}};
  for (std::size_t n = 0; n < impacts.times.size(); ++n) {
    impacts.arrivals->times.push_back(arrival_in(pressure, n, definition).value());
    impacts.impulses->values.push_back(impulse_in(pressure, n, definition).value());
  }
  return definition;
}

// The same case, made once.
const CaseDefinition& published_case() {
  static const CaseDefinition definition = case_with_arrivals();
  return definition;
}

GateOutcome judge(const GateRow& row, const TimeSeries& pressure,
                  const CaseDefinition& definition = published_case()) {
  return evaluate(row, {{"particles", {RunState::finished, ""}}},
                  {{}, {}, [&](const std::string& run, const GateRow& asked) {
                     EXPECT_EQ(run, "particles");
                     return impact_metric(asked.metric, asked.mode, pressure, nullptr, definition);
                   }});
}

// Each of them has a row for each impact.
const std::vector<Metric> metrics_of_one_impact{Metric::impact_arrival, Metric::impact_peak_error,
                                                Metric::impulse_error};

std::vector<GateRow> all_rows() {
  std::vector<GateRow> rows{row_of(Metric::plateau_error, "whole")};
  for (int n = 1; n <= 4; ++n)
    for (const Metric metric : metrics_of_one_impact)
      rows.push_back(row_of(metric, "impact_" + std::to_string(n)));
  return rows;
}

// How the rows of a metric are judged: all alike, or the test fails. Without a limit the rows have
// that of limit_of().
Verdict verdict(Metric metric, const TimeSeries& pressure, std::optional<double> limit = {}) {
  std::optional<Verdict> common;
  for (GateRow row : all_rows()) {
    if (row.metric != metric) continue;
    if (limit) row.limit = limit;
    const GateOutcome outcome = judge(row, pressure);
    EXPECT_TRUE(!common || *common == outcome.verdict) << row.mode << ": " << outcome.message;
    common = outcome.verdict;
  }
  return common.value();
}

TEST(ImpactMetrics, HoldOfARunThatDoesAsTheExperimentAndAreZeroOfIt) {
  for (const GateRow& row : all_rows()) {
    const GateOutcome outcome = judge(row, pressure_of({}));
    EXPECT_EQ(outcome.verdict, Verdict::pass) << metric_name(row.metric) << outcome.message;
    if (row.metric != Metric::plateau_error) {
      EXPECT_NEAR(outcome.value.value, 0, 1e-9) << metric_name(row.metric);
    }
  }
}

TEST(ImpactMetrics, AreWhatTheyAreDefinedAs) {
  const auto value = [&](Metric metric, const char* mode, const ImpactRun& run) {
    return judge(row_of(metric, mode), pressure_of(run)).value.value;
  };
  for (const char* mode : {"impact_1", "impact_3", "impact_4"}) {
    EXPECT_NEAR(value(Metric::impact_arrival, mode, {.late = 0.012}), 0.012, 1e-9);
    EXPECT_NEAR(value(Metric::impact_peak_error, mode, {.scale = 1.3}), 0.3, 1e-9);
    EXPECT_GT(value(Metric::impulse_error, mode, {.scale = 1.3}), 0.28);
    EXPECT_LT(value(Metric::impact_arrival, mode, {.scale = 1.3}), 0)
        << "the share is of the published peak";
  }
  EXPECT_NEAR(value(Metric::plateau_error, "whole", {.late = 0.012, .scale = 1.1}), 0.1, 1e-6);
}

TEST(ImpactMetrics, OfTheArrivalAreViolatedByARunThatIsLateAndTheOthersAreFreeOfThat) {
  for (const double late : {0.06, -0.06}) {
    const TimeSeries pressure = pressure_of({.late = late});
    EXPECT_EQ(verdict(Metric::impact_arrival, pressure), Verdict::violated) << late;
    for (const Metric metric : {Metric::impact_peak_error, Metric::impulse_error})
      EXPECT_EQ(verdict(metric, pressure, 1e-6), Verdict::pass) << metric_name(metric) << late;
  }
}

TEST(ImpactMetrics, AreViolatedByAPressureThatIsScaledByMoreThanTheirLimit) {
  for (const auto& [scale, limit] : std::vector<std::pair<double, std::optional<double>>>{
           {0.4, {}}, {1.6, {}}, {0.9, 0.05}, {1.1, 0.05}})
    for (const Metric metric :
         {Metric::plateau_error, Metric::impact_peak_error, Metric::impulse_error})
      EXPECT_EQ(verdict(metric, pressure_of({.scale = scale}), limit), Verdict::violated)
          << metric_name(metric) << scale;
}

// The front rises within 4 ms, so that it reaches a fixed share of the published peak at nearly the
// same time whatever the scale is.
TEST(ImpactMetrics, OfTheArrivalHardlyMoveWithTheScaleUntilThePressureNeverReachesTheirShare) {
  for (const double scale : {0.6, 0.9, 1.1, 1.6})
    EXPECT_EQ(verdict(Metric::impact_arrival, pressure_of({.scale = scale}), 0.002), Verdict::pass)
        << scale;
  EXPECT_EQ(verdict(Metric::impact_arrival, pressure_of({.scale = 0.49})), Verdict::violated);
}

TEST(ImpactMetrics, AreViolatedByAnImpactThatDoesNotCome) {
  const TimeSeries pressure = pressure_of({.impacts = 2});
  for (const Metric metric : metrics_of_one_impact) {
    EXPECT_EQ(judge(row_of(metric, "impact_2"), pressure).verdict, Verdict::pass);
    for (const char* mode : {"impact_3", "impact_4"}) {
      const GateOutcome outcome = judge(row_of(metric, mode), pressure);
      EXPECT_EQ(outcome.verdict, Verdict::violated);
      EXPECT_TRUE(std::isnan(outcome.value.value));
      EXPECT_TRUE(
          outcome.message.starts_with("no impact in the candidate's wall_pressure@B is not "))
          << outcome.message;
    }
  }
}

// The peaks of a thick oil stay below the pressure of the whole depth, 821 Pa here.
TEST(ImpactMetrics, FindTheImpactsOfALiquidWhosePeaksAreLow) {
  CaseDefinition oil = published_case();
  oil.liquid.density = 900;
  for (double& mean : oil.impacts->peak_means) mean *= 0.16;
  for (auto& repeats : oil.impacts->repeats)
    for (double& peak : repeats) peak *= 0.16;
  const TimeSeries pressure = pressure_of({.scale = 0.16});
  for (const char* mode : {"impact_1", "impact_2", "impact_3", "impact_4"})
    for (const Metric metric : {Metric::impact_arrival, Metric::impact_peak_error}) {
      const GateOutcome outcome = judge(row_of(metric, mode), pressure, oil);
      EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
    }
}

TEST(ImpactMetrics, BlameNoCandidateForAnImpactThatTheRecordLacksToo) {
  const TimeSeries candidate = pressure_of({.impacts = 2}), record = pressure_of({.impacts = 3});
  const auto judged = [&](const char* mode) {
    return evaluate(row_of(Metric::impact_arrival, mode), {{"particles", {RunState::finished, ""}}},
                    {{}, {}, [&](const std::string&, const GateRow& row) {
                       return impact_metric(row.metric, row.mode, candidate, &record,
                                            published_case());
                     }});
  };
  EXPECT_EQ(judged("impact_2").verdict, Verdict::pass);
  EXPECT_EQ(judged("impact_3").verdict, Verdict::violated) << "the record has it";
  const GateOutcome lacking = judged("impact_4");
  EXPECT_EQ(lacking.verdict, Verdict::not_compared);
  EXPECT_EQ(lacking.message,
            "the record's own wall_pressure@B has no impact_4: no peak above 927.5 Pa, 0.25 of the "
            "lowest mean peak published");
}

TEST(ImpactMetrics, AreOfNoPressureThatEndsEarlyOrHoldsANumberThatIsNone) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<TimeSeries> wrong{pressure_of({.until = 2.5})};
  for (const double none : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
    for (const double t : {2.4, 2.5, 4.1, 5.7, 7.3}) {  // a single sample is enough
      wrong.push_back(pressure_of({}));
      wrong.back().value[static_cast<std::size_t>(t * 1000)] = none;
    }
  for (const TimeSeries& pressure : wrong)
    for (const GateRow& row : all_rows())
      EXPECT_EQ(judge(row, pressure).verdict, Verdict::not_compared)
          << metric_name(row.metric) << row.mode << ", series " << &pressure - wrong.data();
}

TEST(ImpactMetrics, OfAnImpactAreNotComparedWhereThePressureEndsBeforeTheTimeToSearchItIn) {
  // The last impact comes at 7.303 s and is searched until 7.711 s.
  for (const double until : {4.0, 6.0, 7.2, 7.5})
    for (const Metric metric : metrics_of_one_impact)
      EXPECT_EQ(verdict(metric, pressure_of({.until = until})), Verdict::not_compared)
          << metric_name(metric) << until;
  CaseDefinition definition = published_case();
  definition.impacts->impulses->duration = 0.6;  // from 7.301 s on
  definition.impacts->impulses->values.at(3) = impulse_in(pressure_of({}), 3, definition).value();
  const GateRow row = row_of(Metric::impulse_error, "impact_4");
  EXPECT_EQ(judge(row, pressure_of({.until = 7.8}), definition).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(row, pressure_of({}), definition).verdict, Verdict::pass);
}

TEST(ImpactMetrics, OfACaseThatDoesNotPublishThemAreNotComparedNorByALimitInAnotherUnit) {
  CaseDefinition definition = impact_case();
  for (const Metric metric : {Metric::impact_arrival, Metric::impulse_error})
    EXPECT_EQ(judge(row_of(metric, "impact_1"), pressure_of({}), definition).verdict,
              Verdict::not_compared);
  definition.impacts.reset();
  for (const GateRow& row : all_rows())
    EXPECT_EQ(judge(row, pressure_of({}), definition).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(row_of(Metric::impact_arrival, "impact_5"), pressure_of({})).message,
            "the case has no impact_5");
  GateRow row = row_of(Metric::impact_arrival, "impact_1");
  EXPECT_EQ(evaluate(row, {{"particles", {RunState::failed, "diverged"}}}, {}).verdict,
            Verdict::solver_failed);
  row.unit = "1";
  EXPECT_EQ(judge(row, pressure_of({})).verdict, Verdict::not_compared);
}

// The record's filtered peaks stand elsewhere than the published ones.
TEST(ExpectedTime, OfTheFilteredPressureIsThatOfTheRecordFilteredAlike) {
  const CaseDefinition definition = impact_case();
  TimeSeries filtered = pressure_of({}), record = filtered;
  filtered.name += "/filtered";
  record.name = filtered.name;
  for (double& t : record.time) t += 0.03;
  for (std::size_t n = 0; n < 4; ++n) {
    const double published = definition.impacts->times[n];
    EXPECT_NEAR(expected_time(n, filtered, &record, definition), published + 0.03, 1e-9);
    EXPECT_EQ(expected_time(n, pressure_of({}), &record, definition), published);
  }
  EXPECT_THROW(expected_time(0, filtered, nullptr, definition), NotSuppliedError);
  for (double& p : record.value) p = 0;
  EXPECT_THROW(expected_time(0, filtered, &record, definition), ComparisonError);
}

TEST(ImpactMetrics, TellTheNumbersOfEachImpact) {
  const auto numbers = impact_numbers(pressure_of({.impacts = 3}), published_case());
  ASSERT_EQ(numbers.size(), 4u);
  EXPECT_NEAR(numbers[2].peak.value().pressure, 4691, 1);
  EXPECT_GT(numbers[2].rise_time.value(), 0.002);
  EXPECT_LT(numbers[2].rise_time.value(), 0.008);
  EXPECT_NEAR(numbers[2].arrival.value(), published_case().impacts->arrivals->times[2], 1e-9);
  EXPECT_TRUE(numbers[2].impulse);
  EXPECT_FALSE(numbers[3].peak || numbers[3].rise_time || numbers[3].arrival || numbers[3].impulse);
  EXPECT_FALSE(impact_numbers(pressure_of({}), impact_case())[0].arrival);
}

}  // namespace
}  // namespace slosh::impact_metrics_test
