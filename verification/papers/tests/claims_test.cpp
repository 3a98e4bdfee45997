// How findings make a verdict, and the measures that findings are made of.
#include "verification/papers/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <tuple>

#include "verification/case_file/case_parser.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/papers/tests/paper_claims.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::claims_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Finding missing(const std::string& text) { return {Held::undecided, text, true}; }

Threshold within_range(double lower, double upper) { return {Relation::within, lower, upper}; }
Threshold at_least_between(double refuted, double confirmed) {
  return {Relation::at_least, refuted, confirmed};
}
Threshold at_most(double upper) { return {Relation::at_most, 0, upper}; }
Threshold within_factor(double factor) { return {Relation::within_factor, 1 / factor, factor}; }

TEST(Claims, AreRefutedByOneFindingAndElseConfirmedWhereNoneIsMissing) {
  struct Decided {
    std::vector<Finding> findings;
    Held held;
    const char *found, *why;
  };
  const Decided all[]{{{{Held::yes, "a"}, {Held::yes, "b"}}, Held::yes, "a; b", ""},
                      {{{Held::yes, "a"}, missing("b"), {Held::no, "c"}}, Held::no, "a; c", "c"},
                      {{{Held::yes, "a"}, missing("no run")}, Held::undecided, "a", "no run"},
                      {{}, Held::undecided, "", ""}};
  for (const Decided& one : all) {
    const DecidedClaim claim = decided({}, one.findings);
    EXPECT_EQ(claim.held, one.held) << one.found;
    EXPECT_EQ(claim.found, one.found);
    EXPECT_EQ(claim.why, one.why);
  }
  Claim unseen;
  unseen.not_decidable = "no photograph";
  EXPECT_EQ(decided(unseen, {}).held, Held::undecided);
  EXPECT_EQ(decided(unseen, {}).why, "no photograph");
}

TEST(Claims, StandInATableWithTheirVerdictsInWords) {
  DecidedClaim confirmed =
      decided({"C1.1", "one", {"1"}, "0.77 Hz", {}, {}, ""}, {{Held::yes, "a"}});
  confirmed.runs = {"a case: a run", "another: a run"};
  const reports::Table table =
      claims_table("papers-claims",
                   {confirmed, decided({"C2.1", "", {"2", "3"}, "", {}, {}, ""}, {{Held::no, "b"}}),
                    decided({"conclusion 1", "", {}, "", {}, {}, ""}, {missing("c")})},
                   {{"1"}, {"2"}, {"3", {"figure-three"}}});
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"C1.1", "one", "0.77 Hz", "confirmed", "a", "",
                                                     "a case: a run; another: a run", "figure 1"}));
  EXPECT_EQ(table.rows[1][3], "refuted");
  EXPECT_EQ(table.rows[1][7], "figure 2, figure 3");
  EXPECT_EQ(table.rows[2][3], "not decidable");
  EXPECT_EQ(table.rows[2][5], "c");
  EXPECT_EQ(table.rows[2][7], "");
  const std::vector<std::string> no_links(8);
  EXPECT_EQ(table.links.at(0), no_links) << "figure 1 has no panel";
  EXPECT_EQ(table.links.at(1).at(7), "figure-three");
  EXPECT_EQ(table.links.at(2), no_links);
}

TEST(Judged, NeverConfirmsNorRefutesByNaN) {
  for (const Estimate& estimate : {Estimate{nan, 0}, Estimate{0, nan}, Estimate{1, nan}}) {
    const Finding found = judged({"error", 100, "%"}, estimate, within_range(-0.02, 0.02));
    EXPECT_EQ(found.held, Held::undecided);
    EXPECT_TRUE(found.text.ends_with("NaN")) << found.text;
  }
  EXPECT_EQ(compare(nan, at_least_between(1, 1.1)), Held::undecided);
}

TEST(Judged, SaysNumberIntervalAndThreshold) {
  EXPECT_EQ(judged({"error", 100, "%"}, {0.0123, 0.001}, within_range(-0.02, 0.02)).text,
            "error +1.23 ± 0.10 % (-2 to 2)");
  EXPECT_EQ(judged({"growth", 1, ""}, {1.2, 0.1}, at_least_between(1, 1.25)).text,
            "growth 1.20 ± 0.10 (at least 1.25, refuted up to 1): within its interval");
  EXPECT_EQ(judged({"share", 100, "%"}, {0.03, 0}, at_most(0.05)).text, "share 3 % (at most 5)");
  EXPECT_EQ(judged({"ratio", 1, ""}, {3, 0}, within_factor(2)).text,
            "ratio 3 (1 within a factor of 2)");
}

TEST(Compare, IsUndecidedWhereTheIntervalReachesOverAnEndOrBetweenTheLevels) {
  const Threshold range = within_range(-0.02, 0.02), least = at_least_between(1, 1.1),
                  most = at_most(1), factor = within_factor(2);
  const std::tuple<Estimate, Threshold, Held> all[]{{{0.015, 0.005}, range, Held::yes},
                                                    {{0.015, 0.006}, range, Held::undecided},
                                                    {{0.03, 0.009}, range, Held::no},
                                                    {{-0.03, 0.009}, range, Held::no},
                                                    {{0.03, 0.011}, range, Held::undecided},
                                                    {{-0.02, 0}, range, Held::yes},
                                                    {{0.5, 1}, range, Held::undecided},
                                                    {{1.1, 0}, least, Held::yes},
                                                    {{1.05, 0}, least, Held::undecided},
                                                    {{1, 0}, least, Held::no},
                                                    {{1.3, 0.1}, least, Held::yes},
                                                    {{1.3, 0.3}, least, Held::undecided},
                                                    {{0.8, 0.1}, least, Held::no},
                                                    {{1, 0}, most, Held::yes},
                                                    {{1.1, 0}, most, Held::no},
                                                    {{0.8, 0.1}, most, Held::yes},
                                                    {{0.95, 0.1}, most, Held::undecided},
                                                    {{1.2, 0.1}, most, Held::no},
                                                    {{1, nan}, at_most(2), Held::undecided},
                                                    {{0.5, 0}, factor, Held::yes},
                                                    {{2, 0}, factor, Held::yes},
                                                    {{0.4, 0}, factor, Held::no},
                                                    {{0.6, 0.2}, factor, Held::undecided},
                                                    {{3, 0.9}, factor, Held::no}};
  for (const auto& [estimate, threshold, held] : all)
    EXPECT_EQ(compare(estimate, threshold), held)
        << estimate.value << " ± " << estimate.half_width << " of " << threshold.upper;
}

TEST(PaperClaims, StandUnderThePapersNumbersAndAreNotDecidableWithoutAnyCase) {
  const std::pair<const char*, std::vector<std::string>> papers[]{
      {"li2010",
       {"C1.1", "C1.2", "C1.3",         "C2.1",         "C2.2",         "C2.3",        "C3.1",
        "C3.2", "C3.3", "C23.1",        "C23.2",        "C4.1",         "C5.1",        "C5.2",
        "C6.1", "C6.2", "C6.3",         "C6.4",         "C7.1",         "C7.2",        "C7.3",
        "C7.4", "C8.1", "conclusion 1", "conclusion 2", "conclusion 3", "conclusion 4"}},
      {"zhao2021",
       {"Z3.1", "Z3.2", "Z4.1", "Z4.2", "Z5.1", "Z5.2", "Z8.1", "Z8.2", "Z8.3", "Z9.1", "Z9.2",
        "Z10.1", "Z11.1", "Z11.2", "Z11.3", "conclusion"}}};
  for (const auto& [paper, expected] : papers) {
    std::vector<std::string> numbers;
    for (const DecidedClaim& one : decided_claims(paper_named(paper), {})) {
      numbers.push_back(one.claim.number);
      EXPECT_EQ(one.held, Held::undecided) << one.claim.number;
      if (one.claim.not_decidable.empty()) {
        EXPECT_TRUE(holds(one.why, "is not part of this campaign")) << one.claim.number;
      }
    }
    EXPECT_EQ(numbers, expected);
  }
}

// What is neither decided by a run nor said to be undecidable would be lost.
TEST(PaperClaims, HaveFindingsOfShippedRunsAndFiguresOrAReasonWhyThereAreNone) {
  for (const char* paper : {"li2010", "zhao2021"}) {
    std::set<std::string> numbers;
    for (const Claim& claim : paper_named(paper).claims) {
      EXPECT_FALSE(claim.statement.empty()) << claim.number;
      EXPECT_NE(claim.findings.empty() && claim.rests_on.empty(), claim.not_decidable.empty())
          << claim.number;
      for (const std::string& other : claim.rests_on)
        EXPECT_TRUE(numbers.contains(other)) << claim.number << " on " << other;
      EXPECT_TRUE(numbers.insert(claim.number).second) << claim.number << " stands twice";
      for (const std::string& number : claim.figures)
        EXPECT_EQ(std::ranges::count(paper_named(paper).figures, number, &PaperFigure::number), 1)
            << claim.number << " " << number;
      for (const FindingRow& row : claim.findings) {
        for (const std::string& name : row.cases) {
          const CaseDefinition definition =
              read_case(SLOSH_SOURCE_DIR "/verification/cases/" + name + ".toml");
          for (const std::string& run : row.runs)
            EXPECT_NO_THROW(run_named(definition, run))
                << claim.number << " " << name << " " << run;
        }
        EXPECT_FALSE(row.cases.empty()) << claim.number;
        EXPECT_FALSE(row.runs.empty()) << claim.number;
        EXPECT_FALSE(row.thresholds.empty()) << claim.number;
        EXPECT_TRUE(wave_findings().contains(row.evidence) ||
                    pressure_findings().contains(row.evidence))
            << claim.number << " " << row.evidence;
        EXPECT_NE(row.evidence == "ratio" || row.evidence == "against_printed",
                  row.measures.empty())
            << claim.number;
      }
    }
  }
  EXPECT_THROW(paper_named("nobody2020"), std::invalid_argument);
}

// A key, a measure or a relation that is misspelt would be left out or taken for another.
TEST(PaperFiles, HoldNothingThatIsNotRead) {
  const std::function<void(const nlohmann::json&, const nlohmann::json&, const std::string&)>
      expect_held = [&](const auto& file, const auto& paper, const std::string& place) {
        if (!file.is_structured()) {
          EXPECT_EQ(file, paper) << place;
          return;
        }
        ASSERT_EQ(file.type(), paper.type()) << place;
        for (const auto& [key, value] : file.items()) {
          const bool is_read = file.is_array() || paper.contains(key);
          EXPECT_TRUE(is_read) << place << "." << key;
          if (is_read)
            expect_held(value, file.is_array() ? paper.at(std::stoul(key)) : paper.at(key),
                        place + "." + key);
        }
      };
  for (const char* name : {"li2010", "zhao2021"}) {
    const auto [file, paper] = file_and_paper(name);
    expect_held(nlohmann::json::parse(file), nlohmann::json::parse(paper), name);
  }
}

template <class Function>
TimeSeries series_of(const Function& f, double sampling = 0.01) {
  TimeSeries series{"x", "Pa", {}, {}};
  for (int i = 0; i * sampling <= 10 * (1 + 1e-12); ++i) {
    series.time.push_back(i * sampling);
    series.value.push_back(f(i * sampling));
  }
  return series;
}

constexpr TimeWindow whole{0, 10};
constexpr double omega = 2 * std::numbers::pi / 2.5;  // four periods
double tone(double t) { return std::cos(omega * t); }

TEST(HistoryDifference, IsThatOfAScaledOrRaisedHistoryAndOfNoneThatEndsEarlyOrHoldsNaN) {
  const TimeSeries other = series_of(tone);
  const auto scaled = difference(series_of([](double t) { return 1.2 * tone(t); }), other, whole);
  EXPECT_NEAR(scaled.with_means, 0.2, 1e-3);
  EXPECT_NEAR(scaled.without_means, 0.2, 1e-3);
  const auto raised = difference(series_of([](double t) { return tone(t) - 3; }), other, whole);
  EXPECT_NEAR(raised.with_means, 3 * std::numbers::sqrt2, 1e-2);
  EXPECT_NEAR(raised.without_means, 0, 1e-9);
  EXPECT_NEAR(raised.offset, 3, 1e-9);
  TimeSeries poisoned = other, early = other;
  poisoned.value[300] = nan;
  early.time.resize(800);
  early.value.resize(800);
  for (const TimeSeries& one : {poisoned, early}) {
    EXPECT_THROW(difference(one, other, whole), ComparisonError);
    EXPECT_THROW(difference(other, one, whole), ComparisonError);
  }
}

// A known swing whose level falls by half of it.
TEST(Fluctuation, IsThatWithinThePeriodsAndNotADrift) {
  CaseDefinition definition = sample_case();
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = omega};
  definition.window_end = 10;
  CaseAssessment assessment = no_runs_of(definition);
  add_run(assessment, "run", SphRun{"li2010", 0.02, 0.02},
          {series_of([](double t) { return tone(t) - 0.1 * t; })});
  const auto value = [&](Measure measure) {
    return measured(assessment, "run", {"x", measure}).at(0).small;
  };
  EXPECT_NEAR(value(Measure::fluctuation), std::numbers::sqrt2 / 2, 0.02);
  EXPECT_NEAR(value(Measure::crest), 1 - 0.1 * 3.75, 0.05);
  EXPECT_NEAR(value(Measure::mean), -0.5, 1e-3);
}

// Particles of known velocities: their sum of m |v| lies between the bounds, which meet where all
// move alike.
TEST(MomentumMagnitudes, BoundTheSumOfMagnitudesOfAnyParticles) {
  std::mt19937 random(1);
  std::normal_distribution<double> velocity(0.3, 1);
  CaseDefinition definition = sample_case();
  RunResult result;
  result.series = {{"momentum_x", "kg/s", {}, {}},
                   {"momentum_z", "kg/s", {}, {}},
                   {"kinetic_energy", "J/m", {}, {}}};
  std::vector<double> sums;
  for (int sample = 0; sample < 50; ++sample) {
    double values[3]{}, sum = 0;
    const double vx = velocity(random), vz = velocity(random);
    for (int i = 0; i < 100; ++i) {
      const double m = 3.5;  // [kg/m], of a hundredth of the liquid
      const double x = sample == 0 ? vx : velocity(random), z = sample == 0 ? vz : velocity(random);
      values[0] += m * x;
      values[1] += m * z;
      values[2] += m * (x * x + z * z) / 2;
      sum += m * std::hypot(x, z);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      result.series[k].time.push_back(sample);
      result.series[k].value.push_back(values[k]);
    }
    sums.push_back(sum);
  }
  const auto [lower, upper] = momentum_magnitudes(result, definition);
  EXPECT_NEAR(lower.value[0], sums[0], 1e-9);
  EXPECT_NEAR(upper.value[0], sums[0], 1e-9);
  for (std::size_t i = 1; i < sums.size(); ++i) {
    EXPECT_LT(lower.value[i], sums[i]);
    EXPECT_GT(upper.value[i], sums[i]);
  }
  result.series.pop_back();
  EXPECT_THROW(momentum_magnitudes(result, definition), std::runtime_error);
}

// a cos t + c cos 2t: 3/4 a^2 c / ((a^2 + c^2) / 2)^1.5.
TEST(Skewness, IsThatOfASecondHarmonic) {
  const double c = 0.1;
  const auto wave = [=](double t) { return tone(t) + c * std::cos(2 * omega * t); };
  EXPECT_NEAR(skewness(series_of(wave), whole), 0.75 * c / std::pow((1 + c * c) / 2, 1.5), 2e-3);
  EXPECT_NEAR(skewness(series_of([&](double t) { return 5 - wave(t); }), whole),
              -0.75 * c / std::pow((1 + c * c) / 2, 1.5), 2e-3);
}

TEST(ToneDifference, GivesLagAndAmplitudeAtTheTimesOfASparseRecord) {
  const auto late = [](double t) { return 7 + 0.9 * std::cos(omega * (t - 0.05)); };
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, 0.1);
  const auto noisy = [&](double t) { return tone(t) + error(random); };
  const ToneDifference found =
      tone_difference(series_of(late), series_of(noisy, 0.4), whole, omega);
  EXPECT_NEAR(found.lag_degrees.value, omega * 0.05 * 180 / std::numbers::pi,
              found.lag_degrees.half_width);
  EXPECT_NEAR(found.amplitude_ratio.value, 0.9, found.amplitude_ratio.half_width);
  EXPECT_LT(found.lag_degrees.half_width, 5);
  EXPECT_GT(found.lag_degrees.half_width, 0.5);
}

TEST(ClaimEvidence, NamesWhatIsMissing) {
  CaseAssessment assessment = no_runs_of(impact_case());
  add_absent_run(assessment, "gone", SphRun{"recommended", 0.01, 0.01}, RunState::failed);
  EXPECT_EQ(message_of([&] { case_named({}, "a_case"); }),
            "the case a_case is not part of this campaign");
  EXPECT_EQ(message_of([&] { standing_result(assessment, "gone"); }),
            "gone of impacts: solver failed (so it goes)");
  EXPECT_EQ(message_of([&] { standing_result(assessment, "other"); }),
            "other of impacts is not declared");
  EXPECT_EQ(message_of([&] { at_first_gauge(assessment.definition, "elevation"); }),
            "the case impacts has no gauge");
  EXPECT_EQ(message_of([&] { filtered_gauge(assessment.definition); }),
            "the case impacts filters no pressure");
}

}  // namespace
}  // namespace slosh::claims_test
