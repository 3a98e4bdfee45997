// Gate rows on the peaks of an ensemble against the experiment's repeats: each holds of an ensemble
// that does as the experiment and turns red on every way in which it can be wrong.
#include "verification/gate/distributions/repeated_impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "verification/gate/gate.hpp"
#include "verification/tests/impact_results.hpp"

namespace slosh::repeated_impacts_test {
namespace {

constexpr Metric metrics[] = {Metric::peak_mean_p_value, Metric::peak_ks_p_value,
                              Metric::peak_ad_p_value, Metric::peak_median_error};

GateRow row_of(Metric metric, const std::string& mode = "impact_2") {
  GateRow row{};
  row.candidate = "particles";
  row.quantity = impact_pressure;
  row.mode = mode;
  row.metric = metric;
  row.unit = "1";
  if (is_p_value(metric))
    row.between = {0.05, 1};
  else
    row.limit = 0.4;
  return row;
}

using Ensemble = std::vector<TimeSeries>;

// Members whose peaks are spread as those of the experiment, from 0.5 to 1.5 of the mean.
Ensemble ensemble_of(int members, double scale = 1) {
  Ensemble pressures;
  for (int k = 0; k < members; ++k)
    pressures.push_back(pressure_of({.scale = scale * (0.5 + k / (members - 1.0))}));
  return pressures;
}

GateOutcome judge(const GateRow& row, const Ensemble& pressures,
                  const CaseDefinition& definition = impact_case()) {
  GateEvidence evidence{};
  evidence.ensemble = [&](const std::string&) {
    return EnsembleOfRun{std::vector<std::string>(pressures.size(), "particles")};
  };
  evidence.repeats = [&](const std::vector<std::string>& members, const GateRow& asked) {
    EXPECT_EQ(members.size(), pressures.size());
    std::vector<const TimeSeries*> series;
    for (const TimeSeries& one : pressures) series.push_back(&one);
    return repeated_impact_metric(asked, series, nullptr, definition);
  };
  return evaluate(row, {{"particles", {RunState::finished, ""}}}, evidence);
}

TEST(RepeatedImpacts, HoldOfAnEnsembleThatDoesAsTheExperiment) {
  for (const Metric metric : metrics)
    for (const char* mode : {"impact_1", "impact_4"}) {
      const GateOutcome outcome = judge(row_of(metric, mode), ensemble_of(30));
      EXPECT_EQ(outcome.verdict, Verdict::pass) << metric_name(metric) << outcome.message;
    }
  EXPECT_TRUE(judge(row_of(Metric::peak_ks_p_value), ensemble_of(30))
                  .message.ends_with("≥ 5 %; 30 repeats, Holm's correction"));
}

TEST(RepeatedImpacts, AreViolatedByPeaksThatAreScaled) {
  for (const double scale : {0.35, 2.2})
    for (const Metric metric : metrics) {
      const GateOutcome outcome = judge(row_of(metric), ensemble_of(30, scale));
      EXPECT_EQ(outcome.verdict, Verdict::violated) << metric_name(metric) << outcome.message;
      EXPECT_EQ(outcome.message.find(" is not ≥ 5 %") != std::string::npos, is_p_value(metric))
          << outcome.message;
    }
}

TEST(RepeatedImpacts, AreViolatedWhereOneMemberHasNoImpact) {
  Ensemble pressures = ensemble_of(30);
  pressures[4] = pressure_of({.impacts = 2});
  for (const Metric metric : metrics) {
    EXPECT_EQ(judge(row_of(metric, "impact_2"), pressures).verdict, Verdict::pass);
    const GateOutcome outcome = judge(row_of(metric, "impact_3"), pressures);
    EXPECT_EQ(outcome.verdict, Verdict::violated) << outcome.message;
    EXPECT_TRUE(std::isnan(outcome.value.value));
    EXPECT_TRUE(outcome.message.starts_with("no impact in the candidate's wall_pressure@B"))
        << outcome.message;
  }
}

TEST(RepeatedImpacts, DoNotPassWithSpoiledSeries) {
  const auto late = [](TimeSeries& one, double by) {
    for (double& t : one.time) t += by;
  };
  const auto scale = [](TimeSeries& one, double by) {
    for (double& p : one.value) p *= by;
  };
  const std::function<void(TimeSeries&)> spoilings[] = {
      [&](TimeSeries& one) { scale(one, 1000); },
      [&](TimeSeries& one) { scale(one, -1); },
      [&](TimeSeries& one) { late(one, 0.8); },  // half a period
      [&](TimeSeries& one) { late(one, -0.8); },
      [&](TimeSeries& one) { one.value[one.value.size() / 2] = std::nan(""); },
      [&](TimeSeries& one) {
        one.time.resize(one.time.size() * 3 / 4);
        one.value.resize(one.time.size());
      }};
  for (const auto& spoil : spoilings) {
    Ensemble pressures = ensemble_of(25);
    for (TimeSeries& one : pressures) spoil(one);
    for (const Metric metric : metrics)
      EXPECT_NE(judge(row_of(metric, "impact_4"), pressures).verdict, Verdict::pass)
          << metric_name(metric) << ", spoiling " << &spoil - spoilings;
  }
}

TEST(RepeatedImpacts, AreNotComparedOfFewRepeatsNorSuppliedWithoutThoseOfTheExperiment) {
  CaseDefinition without = impact_case();
  without.impacts->repeats.clear();
  for (const Metric metric : metrics) {
    const GateOutcome outcome = judge(row_of(metric), ensemble_of(19));
    EXPECT_EQ(outcome.verdict, Verdict::not_compared);
    EXPECT_EQ(outcome.message,
              metric_name(metric) +
                  " of particles: 19 repeats; expected an ensemble of 20 repeats or more, as a "
                  "test on fewer accepts nearly anything (repeats = 20 of its [[run]])");
    EXPECT_EQ(judge(row_of(metric), ensemble_of(20)).verdict, Verdict::pass);
    EXPECT_EQ(judge(row_of(metric), ensemble_of(20), without).verdict, Verdict::not_supplied);
  }
  EXPECT_NE(judge(row_of(Metric::peak_median_error), {pressure_of({})}).message.find(": 1 run; "),
            std::string::npos);
  EXPECT_EQ(judge(row_of(Metric::peak_median_error, "impact_5"), ensemble_of(20)).message,
            "the case has no impact_5");
}

TEST(RepeatedImpacts, HaveAPValueThatMayBeOneAndMayBeTooNearItsBound) {
  // An interval that reaches above 1 reaches across no bound.
  EXPECT_EQ(judge(row_of(Metric::peak_ks_p_value), ensemble_of(40)).verdict, Verdict::pass);
  GateRow near = row_of(Metric::peak_ks_p_value);
  const double p = judge(near, ensemble_of(30, 1.25)).value.value;
  near.between = {p + 1e-4, 1};
  EXPECT_EQ(judge(near, ensemble_of(30, 1.25)).verdict, Verdict::inconclusive);
}

}  // namespace
}  // namespace slosh::repeated_impacts_test
