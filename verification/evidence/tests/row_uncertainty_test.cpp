// What makes a row uncertain beside its own interval, on the small surge of surge_results.hpp.
#include "verification/evidence/row_uncertainty.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/history_uncertainty.hpp"
#include "verification/evidence/input_uncertainty.hpp"
#include "verification/evidence/tests/row_of_a_record.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::row_uncertainty_test {
namespace {

// The forced amplitude of "particles" against the fine mesh, each mesh too high by what is told.
struct OfMeshes : JudgedRuns {
  OfMeshes(double coarse, double fine) {
    runs = surge_runs();
    definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
    definition.gate[0].reference = "fine_mesh";
    set("coarse_mesh", scaled(elevation_of({}), 1 + coarse));
    set("fine_mesh", scaled(elevation_of({}), 1 + fine));
    definition.refinements = {{"mesh", RefinedNumber::mesh, {"coarse_mesh", "fine_mesh"}}};
  }
};

TEST(RowUncertainty, CountsThatOfAMeshThatIsTheReference) {
  // Two meshes of 50 x 50 and 50 x 100: steps apart by sqrt(2), so three times their difference
  // over sqrt(2) - 1.
  const GateOutcome outcome = OfMeshes(0.01, 0.005).judged();
  const double difference = 1 / 1.005 - 1 / 1.01;
  EXPECT_NEAR(outcome.judgement.value().contributions.reference.known(),
              3 * difference / (std::sqrt(2.0) - 1), 1e-6);
  EXPECT_EQ(outcome.verdict, Verdict::pass);  // 0.5 % +- 3.6 % within 5 %
}

TEST(RowUncertainty, OfTheCoarserMeshCountsTheFinerOneToo) {
  OfMeshes meshes(0.01, 0.005);
  meshes.definition.gate[0].reference = "coarse_mesh";
  // The whole error of first order at the coarser step: sqrt(2) times that of the finer one.
  const double difference = 1 / 1.005 - 1 / 1.01;
  const GateOutcome outcome = meshes.judged();
  EXPECT_NEAR(outcome.judgement.value().contributions.reference.half_width.value(),
              3 * difference * std::sqrt(2.0) / (std::sqrt(2.0) - 1), 1e-6);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);  // 1 % +- 5.1 % of 5 %
}

// A default and a number that is written out can give two runs of a path the same step.
TEST(RowUncertainty, OfTwoRunsWithOneStepCountsTheRowsOwn) {
  OfMeshes meshes(0.01, 0.005);
  const double alone = meshes.judged().judgement.value().contributions.reference.known();
  meshes.add("fine_mesh_again", "fine_mesh", 1.03);
  meshes.definition.refinements[0].runs = {"coarse_mesh", "fine_mesh_again", "fine_mesh"};
  EXPECT_EQ(meshes.judged().judgement.value().contributions.reference.known(), alone);
}

// A program that ignores its spacing, a copy of a run under another name, and steps that differ in
// rounding alone.
TEST(RowUncertainty, OfARefinementThatRefinesNothingIsUnknownAndDoesNotPass) {
  OfMeshes copied(0.005, 0.005), close(0.01, 0.005);
  std::get<InterFoamRun>(close.definition.runs.at(3).solver).cells_z = 99;
  std::get<InterFoamRun>(close.definition.runs.at(3).solver).cells_x = 50;
  for (const auto& [meshes, reason] :
       {std::pair{&copied, "coarse_mesh and fine_mesh have the same elevation@right"},
        {&close, "the steps of coarse_mesh and fine_mesh differ by a factor below 1.1"}}) {
    const GateOutcome outcome = meshes->judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << reason;
    EXPECT_FALSE(outcome.judgement.value().contributions.reference.half_width.has_value());
    EXPECT_TRUE(holds(outcome.message, reason));
    EXPECT_TRUE(numerical_half_widths(meshes->definition, meshes->runs, "fine_mesh", surge_quantity)
                    .empty());
  }
  // What another path tells is counted, and the row does not pass all the same.
  std::get<InterFoamRun>(copied.add("finer_mesh", "fine_mesh", 1.006).solver).cells_x = 100;
  copied.definition.refinements.push_back(
      {"columns", RefinedNumber::mesh, {"fine_mesh", "finer_mesh"}});
  const GateOutcome outcome = copied.judged();
  EXPECT_GT(outcome.judgement.value().contributions.reference.known(), 0.002);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_TRUE(holds(outcome.message, "the refinement mesh tells nothing"));
}

// A program that ignores its spacing and never answers twice alike.
TEST(RowUncertainty, OfASpacingThatGivesNoMoreParticlesIsUnknown) {
  for (const auto& [coarse, fine] : {std::pair{500.0, 500.0}, {500, 400}, {500, 1990}, {0, 0}}) {
    OfMeshes runs(0.00501, 0.005);
    runs.definition.refinements[0].number = RefinedNumber::particle_spacing;
    for (const auto& [name, spacing, particles] :
         {std::tuple{"coarse_mesh", 0.04, coarse}, {"fine_mesh", 0.02, fine}}) {
      for (RunDefinition& run : runs.definition.runs)
        if (run.name == name)
          run.solver = ExternalRun{.command = {"./p"}, .method = "m", .particle_spacing = spacing};
      runs.runs.results.at(name).cost.elements = particles;
    }
    const GateOutcome outcome = runs.judged();
    EXPECT_EQ(outcome.message.find("fine_mesh has no more particles than coarse_mesh: the "
                                   "refinement changed nothing") != std::string::npos,
              coarse == 500 && fine <= 500)
        << fine << outcome.message;
    EXPECT_EQ(outcome.verdict, coarse == 500 && fine <= 500 ? Verdict::inconclusive : Verdict::pass)
        << fine << outcome.message;
  }
}

// The same program, with noise in the last digits, with fewer samples, and with times that are
// printed in another way.
TEST(RowUncertainty, OfACopyThatWasTouchedIsUnknownToo) {
  const TimeSeries wave = elevation_of({});
  TimeSeries noisy = scaled(wave, 1.005), thinned = noisy, shifted = noisy;
  for (std::size_t i = 0; i < noisy.value.size(); ++i)
    noisy.value[i] += (i % 2 == 0 ? 1e-12 : -1e-12);
  thinned.time.clear();
  thinned.value.clear();
  for (std::size_t i = 0; i < wave.time.size(); i += 2) {
    thinned.time.push_back(wave.time[i]);
    thinned.value.push_back(1.005 * wave.value[i]);
  }
  for (std::size_t i = 1; i + 1 < shifted.time.size(); ++i) shifted.time[i] += 1e-9;
  for (const TimeSeries& copy : {noisy, thinned, shifted}) {
    OfMeshes meshes(0.005, 0.005);
    meshes.set("coarse_mesh", copy);
    const GateOutcome outcome = meshes.judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
    EXPECT_TRUE(holds(outcome.message, "the refinement changed nothing"));
  }
}

// The same program, which draws its noise anew: white noise, and noise of any colour
// that does not become less with the step.
TEST(RowUncertainty, OfACopyInNoiseIsUnknownToo) {
  const TimeSeries wave = elevation_of({});
  const auto judged = [&](double size, double colour, int runs, double order) {
    OfMeshes meshes(0, 0);
    double step = 1;
    unsigned seed = 1;
    for (const char* name : {"coarse_mesh", "fine_mesh", "finer_mesh"}) {
      if (std::string(name) == "finer_mesh") {
        if (runs < 3) continue;
        RunDefinition finer = run_named(meshes.definition, "fine_mesh");
        finer.name = name;
        std::get<InterFoamRun>(finer.solver).cells_x *= 4;
        meshes.definition.runs.push_back(finer);
        meshes.definition.refinements[0].runs.emplace_back(name);
        meshes.runs.status[name] = {RunState::finished, ""};
      }
      const TimeSeries moved = scaled(wave, 1 + order * step);
      meshes.runs.results[name] = result_of(name, with_noise(moved, size, colour, seed++));
      step /= 4;
    }
    return meshes.judged().message;
  };
  const double swing = rms(wave.value);
  for (const double size : {1e-6, 1e-5, 1e-4, 1e-3, 0.02})
    EXPECT_TRUE(holds(judged(size * swing, 0, 2, 0), "by noise alone")) << size;
  for (const double size : {3e-6, 1e-5, 1e-4})
    EXPECT_TRUE(holds(judged(size * swing, 0.95, 3, 0), "by noise alone")) << size;
  for (const int runs : {2, 3})
    for (const double order : {1e-5, 1e-4, 1e-3, 0.02}) {
      EXPECT_FALSE(holds(judged(0, 0, runs, order), "noise alone")) << order;
      // The change from the second step to the third is a quarter of that from the first.
      const double noise = order * swing / (runs == 2 ? 2 : 8);
      EXPECT_FALSE(holds(judged(noise, 0, runs, order), "noise alone")) << order;
    }
}

// The same program, with samples that lie half an interval later, on straight lines between those
// of the other: what lies between is not known better.
TEST(RowUncertainty, OfACopyAtOtherTimesIsUnknownToo) {
  for (const double part : {0.3, 0.5}) {
    OfMeshes meshes(0.005, 0.005);
    const TimeSeries wave = scaled(elevation_of({}), 1.005);
    TimeSeries later = wave;
    for (std::size_t i = 0; i + 1 < wave.time.size(); ++i) {
      later.time[i] = (1 - part) * wave.time[i] + part * wave.time[i + 1];
      later.value[i] = (1 - part) * wave.value[i] + part * wave.value[i + 1];
    }
    later.time.pop_back();
    later.value.pop_back();
    meshes.set("coarse_mesh", later);
    const GateOutcome outcome = meshes.judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << part;
    EXPECT_TRUE(holds(outcome.message, "the refinement changed nothing"));
    for (double& value : later.value) value *= 1.05;  // what a refinement does
    meshes.set("coarse_mesh", later);
    EXPECT_FALSE(holds(meshes.judged().message, "the refinement changed nothing"));
  }
}

TEST(RowUncertainty, OfAMeshWithoutAnotherIsUnknownAndDoesNotPass) {
  OfMeshes meshes(0.01, 0.005);
  ASSERT_EQ(meshes.judged().verdict, Verdict::pass);
  OfMeshes alone = meshes;
  alone.leave_out("coarse_mesh");
  OfMeshes without_path = meshes;
  without_path.definition.refinements.clear();
  for (OfMeshes* unknown : {&alone, &without_path}) {
    const GateOutcome outcome = unknown->judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
    EXPECT_FALSE(outcome.judgement.value().contributions.reference.half_width.has_value());
    EXPECT_TRUE(holds(outcome.message,
                      "the numerical uncertainty of the reference fine_mesh is "
                      "unknown; a [[refinement]]"));
    unknown->definition.gate[0].kind = RowKind::regression;
    EXPECT_EQ(unknown->judged().verdict, Verdict::pass);
  }
}

TEST(RowUncertainty, OfTheCandidatesOwnDecayHasNothingOfTheReference) {
  OfMeshes meshes(0.03, 0.01);
  meshes.definition.gate = {surge_row("natural_1", Metric::decay_rate, "1/s", 0.05)};
  meshes.definition.gate[0].reference = "coarse_mesh";
  EXPECT_EQ(meshes.judged().judgement.value().contributions.reference.half_width.value(), 0);
}

TEST(RowUncertainty, MakesARowInconclusiveAgainstAMeshThatHasNotConverged) {
  const OfMeshes meshes(0.03, 0.01);
  EXPECT_EQ(meshes.judged().verdict, Verdict::inconclusive);
  const CaseAssessment assessment = assess(meshes.definition, meshes.runs);
  EXPECT_EQ(exit_status({assessment}), exit_inconclusive);
  EXPECT_TRUE(holds(remedy_table(assessment).rows.at(0).at(2), "reference"));
  EXPECT_EQ(refinement_table(assessment).rows.at(0).at(2), "coarse_mesh, fine_mesh");
}

TEST(RowUncertainty, OfAVerificationRowIsNotTheDiscretisationErrorThatItMeasures) {
  JudgedRuns row{.runs = surge_runs()};
  row.definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  std::get<SphRun>(row.add("coarse_particles", "particles", 1.04).solver).particle_spacing = 0.02;
  row.definition.refinements = {
      {"spacing", RefinedNumber::particle_spacing, {"coarse_particles", "particles"}}};
  EXPECT_EQ(row.contributions().discretisation.known(), 0);
  EXPECT_EQ(row.judged().verdict, Verdict::pass);
}

TEST(RowUncertainty, OfPotentialFlowIsWhatItsCoarserRunChanges) {
  CaseDefinition definition = surge_case();
  definition.runs.at(0).solver = PotentialRun{};
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  CaseRuns runs = surge_runs();
  RunResult& flow = runs.results.at("theory");
  flow.diagnostics = {{"valid_until_s", 20}};
  flow.series.resize(1);
  TimeSeries coarse = scaled(elevation_of({}), 1 / 1.03);
  coarse.name += "/coarser";
  flow.series.push_back(coarse);
  const GateOutcome outcome = assess(definition, runs).gate.at(0);
  // 1.03 - 1, and 1 / (2 - 1 / 1.03) - 1 the other way.
  EXPECT_NEAR(outcome.judgement.value().contributions.reference.known(), 0.03, 1e-9);
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  flow.series.pop_back();  // a run that does not tell it
  EXPECT_EQ(assess(definition, runs).gate.at(0).verdict, Verdict::inconclusive);
}

// Linear theory 42 % off, which a copy of it and the true flow show alike, and a candidate half way
// between the two, whose distance from both is the same.
TEST(RowUncertainty, OfLinearTheoryIsWhatItLeavesOut) {
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("whole", Metric::normalised_rms, "1", 0.3)};
  CaseRuns runs = surge_runs();
  TimeSeries& moved = runs.results.at("theory").series.at(2);
  ASSERT_TRUE(moved.name.ends_with(nonlinear));
  moved = scaled(moved, 1.42);
  for (const double share : {0.0, 0.5, 1.0}) {
    runs.results["particles"] = result_of("particles", scaled(elevation_of({}), 1 + 0.42 * share));
    const GateOutcome outcome = assess(definition, runs).gate.at(0);
    // 0.42 over the reference's own rms, 1.42 or 0.58 of what it was.
    EXPECT_GT(outcome.judgement->contributions.reference.known(), 0.42 / 1.42) << share;
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << share;
  }
  definition.gate[0].kind = RowKind::regression;
  runs.results["particles"] = result_of("particles", elevation_of({}));
  EXPECT_EQ(assess(definition, runs).gate.at(0).verdict, Verdict::pass);
}

TEST(RowUncertainty, OfLinearTheoryCountsTheModesThatItLacksAndIsUnknownWhereItDoesNotTell) {
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  CaseRuns runs = surge_runs();
  std::vector<TimeSeries>& series = runs.results.at("theory").series;
  ASSERT_TRUE(series.at(1).name.ends_with(finer));
  series[1] = scaled(series[1], 1.01);
  const GateOutcome outcome = assess(definition, runs).gate.at(0);
  EXPECT_NEAR(outcome.judgement->contributions.reference.known(), 1 / (1 - 1.25 * 0.01) - 1, 1e-6);
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  series.pop_back();  // the waves were too steep for an estimate
  const GateOutcome unknown = assess(definition, runs).gate.at(0);
  EXPECT_EQ(unknown.verdict, Verdict::inconclusive);
  EXPECT_TRUE(
      holds(unknown.message, "the third order of elevation@right that theory leaves is unknown"));
}

TEST(RowUncertainty, OfAFlowThatDisturbancesDecideIsWhatItsRepeatsSpread) {
  JudgedRuns repeats{.runs = surge_runs()};
  repeats.definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  for (unsigned seed = 1; seed <= 3; ++seed) {
    auto& sph = std::get<SphRun>(
        repeats.add("repeat_" + std::to_string(seed), "particles", 1 + 0.02 * seed - 0.01).solver);
    sph.particle_spacing = sph.surface_particle_spacing = 0.02;  // another spacing serves too
    sph.start_disorder = 0.05;
    sph.start_seed = seed;
  }
  // Standard deviation 0.02, Student's t of two degrees of freedom 4.3027 (tables).
  EXPECT_NEAR(repeats.contributions().time_series.known(), 4.3027 * 0.02 * std::sqrt(4.0 / 3),
              1e-5);
  EXPECT_EQ(repeats.judged().verdict, Verdict::inconclusive);
  repeats.definition.runs.pop_back();
  repeats.runs.results.erase("repeat_3");
  repeats.runs.status.erase("repeat_3");
  EXPECT_EQ(repeats.judged().verdict, Verdict::pass);  // of two: not known
}

TEST(RowUncertainty, OfARecordIsWhatItsPublisherStates) {
  CaseDefinition definition = surge_case();
  const TimeSeries wave = elevation_of({});
  RecordRun record{"eta.csv", surge_quantity, "m", wave.time, wave.value, 0.0005};
  definition.runs.at(0).solver = record;
  definition.runs.resize(3);
  definition.runs.erase(definition.runs.begin() + 1);
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05),
                     surge_row("whole", Metric::normalised_rms, "1", 0.05)};
  CaseRuns runs;
  for (const char* name : {"theory", "particles"}) {
    runs.results[name] = result_of(name, wave);
    runs.status[name] = {RunState::finished, ""};
  }
  const CaseAssessment assessment = assess(definition, runs);
  const double amplitude = assessment.comparisons.at(0).modes.at(0).reference.amplitude.value;
  EXPECT_NEAR(assessment.gate.at(0).judgement.value().contributions.reference.known(),
              0.0005 / (amplitude - 0.0005), 1e-12);
  // A record that is all too high by its half width, over its rms about its mean.
  double squares = 0;
  const std::vector<double> deviations = without_mean(cut_to_window(wave, {1, 20}).value);
  for (const double one : deviations) squares += one * one;
  EXPECT_NEAR(assessment.gate.at(1).judgement.value().contributions.reference.known(),
              0.0005 / std::sqrt(squares / static_cast<double>(deviations.size())), 2e-3 * 0.08);
  std::get<RecordRun>(definition.runs.at(0).solver).uncertainty.reset();
  const CaseAssessment undeclared = assess(definition, runs);
  for (const GateOutcome& outcome : undeclared.gate) {
    EXPECT_FALSE(outcome.judgement.value().contributions.reference.half_width.has_value());
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
    EXPECT_TRUE(holds(outcome.message, "the record theory declares no uncertainty"));
  }
}

// A wave that is half as high as the record's is as high as the record less half of it: the change
// is that of the record measured again, also of a candidate that is off.
TEST(RowUncertainty, OfARecordReachesAsFarAsTheRecordMayBeOff) {
  OfARecord row(Metric::phase_lag, "forced", "deg", 90, 0.01);
  const double amplitude =
      assess(row.definition, row.runs).comparisons.at(0).modes.at(0).reference.amplitude.value;
  for (const auto& [share, error] : {std::pair{0.05, 0.0}, {0.2, 0.3}, {0.5, -0.4}}) {
    OfARecord high(Metric::amplitude_error, "forced", "1", 0.99, 0.01);
    high.set("particles", scaled(elevation_of({}), 1 + error));
    std::get<RecordRun>(high.definition.runs.at(1).solver).uncertainty = share * amplitude;
    const GateOutcome outcome = high.judged();
    high.set("record", scaled(elevation_of({}), 1 - share));
    EXPECT_NEAR(outcome.judgement->contributions.reference.known(),
                high.judged().value.value - outcome.value.value, 1e-6)
        << share;
  }
  std::get<RecordRun>(row.definition.runs.at(1).solver).uncertainty = amplitude / 2;
  EXPECT_NEAR(row.contributions().reference.known(), 30, 1e-6);
}

// Of a quantity whose modes nobody fits, samples between which the wave turns.
// The sample nearest to the window's begin is lost, and the record covers the window beside it.
TEST(RowUncertainty, OfARecordThatLostTheSamplesAtTheWindowsBeginIsKnown) {
  for (const Metric metric : {Metric::rms_error, Metric::normalised_rms, Metric::mean_offset}) {
    OfARecord row(metric, "whole", metric == Metric::mean_offset ? "m" : "1", 0.5, 0.01);
    for (const char* run : {"record", "particles"}) {
      TimeSeries& series = row.runs.results.at(run).series.at(0);
      const auto first = std::lower_bound(series.time.begin(), series.time.end(),
                                          row.definition.window_begin - 1e-9) -
                         series.time.begin();
      series.time.erase(series.time.begin() + first, series.time.begin() + first + 2);
      series.value.erase(series.value.begin() + first, series.value.begin() + first + 2);
    }
    const UncertaintyContributions found = row.contributions();
    EXPECT_TRUE(found.reference.half_width) << metric_name(metric) << found.reference.basis;
    EXPECT_TRUE(found.discretisation.half_width)
        << metric_name(metric) << found.discretisation.basis;
  }
}

TEST(RowUncertainty, OfACoarseCandidateWithoutModesIsDoubted) {
  for (const std::size_t every : {1, 10}) {
    OfARecord row(Metric::rms_error, "whole", "1", 0.99, 0.01);
    row.definition.natural_modes = 0;
    row.definition.motion.surge =
        TableMotion{.file = "", .time = {0, 10, 20}, .value = {0, 0.01, 0}};
    const TimeSeries wave = elevation_of({});
    TimeSeries coarse{wave.name, wave.unit, {}, {}};
    for (std::size_t i = 0; i < wave.time.size(); i += every) {
      coarse.time.push_back(wave.time[i]);
      coarse.value.push_back((1 + 1e-9) * wave.value[i]);  // no copy of the record
    }
    row.set("particles", coarse);
    const GateOutcome outcome = row.judged();
    EXPECT_EQ(outcome.message.find("the candidate has no sample between") != std::string::npos,
              every == 10)
        << outcome.message;
    EXPECT_EQ(outcome.verdict == Verdict::inconclusive, every == 10) << outcome.message;
  }
}

TEST(RowUncertainty, AgainstAnExperimentCountsTheCandidatesDiscretisation) {
  OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0.01);
  const GateOutcome counted = row.judged();
  const Contribution& discretisation = counted.judgement->contributions.discretisation;
  EXPECT_NEAR(discretisation.half_width.value(), 0.03, 1e-6);  // 2 h and h
  EXPECT_TRUE(discretisation.basis.ends_with("(two values only)"));
  EXPECT_EQ(counted.verdict, Verdict::pass);
  row.definition.refinements.clear();
  const GateOutcome unknown = row.judged();
  EXPECT_FALSE(unknown.judgement->contributions.discretisation.half_width.has_value());
  EXPECT_EQ(unknown.verdict, Verdict::inconclusive);
  EXPECT_TRUE(holds(unknown.message,
                    "the numerical uncertainty of the candidate particles is "
                    "unknown"));
}

// Waves that are 9 % too high and 9 % too low have one distance from the record, and 18 % from one
// another.
TEST(RowUncertainty, OfADistanceIsThatOfWhatTheRefinementMoves) {
  OfARecord row(Metric::normalised_rms, "whole", "1", 0.15, -0.09);
  EXPECT_NEAR(row.contributions().discretisation.known(), 3 * 0.09, 1e-3);
  row.set("particles", scaled(elevation_of({}), 1.09));
  const GateOutcome outcome = row.judged();
  EXPECT_NEAR(outcome.value.value, 0.09, 1e-3);
  EXPECT_NEAR(outcome.judgement->contributions.discretisation.known(), 3 * 0.18, 2e-3);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
}

// A coarse wave that is turned over has the same modulus, and so has one that is a quarter late.
TEST(RowUncertainty, OfAModulusSeesAWaveThatIsTurnedOver) {
  for (const auto& [metric, mode] :
       {std::pair{Metric::amplitude_error, "forced"}, {Metric::rms_error, "whole"}}) {
    OfARecord row(metric, mode, "1", 0.1, -1.9), turned(metric, mode, "1", 0.1, -2);
    turned.set("particles", elevation_of({}));  // the coarse one turned over to the last digit
    const GateOutcome outcome = row.judged(), over = turned.judged();
    EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
    EXPECT_NEAR(outcome.judgement->contributions.discretisation.known(), 3 * 0.95, 1e-3)
        << metric_name(metric);
    EXPECT_EQ(over.verdict, Verdict::inconclusive) << over.message;
    EXPECT_TRUE(holds(over.message, "the refinement spacing tells nothing: between its runs"));
    const GateOutcome refined = OfARecord(metric, mode, "1", 0.1, 0.002).judged();
    EXPECT_EQ(refined.verdict, Verdict::pass) << refined.message;
    EXPECT_NEAR(refined.judgement->contributions.discretisation.known(), 0.006, 1e-6);
  }
}

// Every metric of a record's whole window: a wave of 1 cm that is known to 1 mm, to 2 cm.
TEST(RowUncertainty, OfARecordReachesEveryMetricOfTheWindow) {
  for (const auto& [metric, unit, limit] : {std::tuple{Metric::normalised_rms, "1", 0.5},
                                            {Metric::rms_error, "1", 0.5},
                                            {Metric::mean_offset, "m", 0.003},
                                            {Metric::cross_correlation_lag, "deg", 90.0},
                                            {Metric::spectral_peak_error, "1", 0.2}}) {
    OfARecord row(metric, "whole", unit, limit, 0.002);
    std::optional<double>& uncertainty =
        std::get<RecordRun>(row.definition.runs.at(1).solver).uncertainty;
    const GateOutcome surely = row.judged();
    EXPECT_EQ(surely.verdict, Verdict::pass) << surely.message;
    const double small = surely.judgement->contributions.reference.known();
    uncertainty = 5e-4;
    EXPECT_GT(row.contributions().reference.known(), 100 * small) << metric_name(metric);
    uncertainty = 0.02;
    EXPECT_EQ(row.judged().verdict, Verdict::inconclusive) << row.judged().message;
  }
}

TEST(RowUncertainty, OfARegressionAgainstAnExperimentIsThatOfTheLimitsMeasurement) {
  OfARecord row(Metric::normalised_rms, "whole", "1", 0.05, 0.01);
  std::get<RecordRun>(row.definition.runs.at(1).solver).uncertainty = 0.01;
  row.definition.inputs = {{Input::amplitude, 0.0002, "a ruler"}};
  EXPECT_EQ(row.judged().verdict, Verdict::inconclusive);
  row.definition.gate[0].kind = RowKind::regression;
  const UncertaintyContributions found = row.contributions();
  for (const Contribution* one : {&found.reference, &found.discretisation, &found.input}) {
    EXPECT_EQ(one->half_width.value(), 0);
    EXPECT_EQ(one->basis.find("as large as when the limit was measured"), 0U) << one->basis;
  }
  EXPECT_EQ(row.judged().verdict, Verdict::pass);
  row.set("particles", scaled(elevation_of({}), 1.1));
  EXPECT_EQ(row.judged().verdict, Verdict::violated);
}

TEST(RowUncertainty, OfInputsThatNobodyKnowsIsSaidToBeUnknown) {
  OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0.01);
  EXPECT_FALSE(row.contributions().input.half_width.has_value());
  EXPECT_EQ(row.judged().verdict, Verdict::pass);
  row.definition.gate[0].reference = "theory";
  EXPECT_EQ(row.contributions().input.half_width.value(), 0);  // both sides have the same
}

TEST(RowUncertainty, OfTheMotionsAmplitudeIsItsShare) {
  OfARecord row(Metric::amplitude_error, "forced", "1", 0.05, 0);
  row.definition.inputs = {{Input::amplitude, 0.0002, "a ruler"}};
  EXPECT_NEAR(row.contributions().input.half_width.value(), 0.0002 / 0.02, 1e-6);
}

TEST(RowUncertainty, OfTheInputsTogetherIsTheRootOfTheirSquares) {
  OfARecord row(Metric::frequency_error, "natural_1", "1", 0.05, 0);
  // omega_1^2 = g k tanh(k h): d omega / omega = dg / 2 g, and k dh / sinh(2 k h) of the depth;
  // the fit, of one natural mode, adds two or three percent of that.
  row.definition.inputs = {{Input::gravity, 0.02, "a table"}};
  EXPECT_NEAR(row.contributions().input.half_width.value(), 0.02 / (2 * 9.81), 3e-5);
  const double k = std::numbers::pi;
  row.definition.inputs.push_back({Input::fill_depth, 0.002, "a ruler"});
  EXPECT_NEAR(row.contributions().input.half_width.value(),
              std::hypot(0.02 / (2 * 9.81), k * 0.002 / std::sinh(2 * k * 0.35)), 3.5e-5);
  row.runs.status["theory"] = {RunState::out_of_range, "too high"};
  row.definition.runs.at(0).solver = SphRun{"recommended", 0.03, 0.03};  // no theory at all
  EXPECT_FALSE(row.contributions().input.half_width.has_value());
}

// A metric that is a magnitude has its least value where the prediction meets the record: both ends
// of the input's interval have the same value there.
TEST(RowUncertainty, OfAnInputIsTheLargestChangeOfAMagnitude) {
  OfARecord row(Metric::normalised_rms, "whole", "1", 0.05, 0);
  row.definition.refinements.clear();
  for (const double half_width : {0.002, 0.004}) {
    row.definition.inputs = {{Input::amplitude, half_width, "a ruler"}};
    EXPECT_NEAR(row.contributions().input.known(), half_width / 0.02, 1e-4);
  }
  // The record off by 5 %: the input's 10 % may make it 5 % or 15 %.
  row.definition.inputs = {{Input::amplitude, 0.002, "a ruler"}};
  row.set("record", scaled(elevation_of({}), 1.05));
  EXPECT_NEAR(row.contributions().input.known(), 0.1 / 1.05, 2e-3);
}

TEST(RowUncertainty, OfTheInputsOfAFreeWaveComesFromTheViscousWave) {
  OfARecord row(Metric::frequency_error, "natural_1", "1", 0.05, 0);
  row.definition.motion = {};
  row.definition.initial_wave = InitialWaveDefinition{1, 0.01};
  row.definition.liquid.kinematic_viscosity = 1e-3;
  row.definition.inputs = {{Input::fill_depth, 0.002, "a ruler"}};
  row.definition.runs.at(0).solver = ViscousWaveRun{0.1};
  predict_input_bounds(row.definition, row.runs);
  const auto& bounds = row.runs.input_bounds;
  ASSERT_TRUE(bounds.contains(Input::fill_depth));
  EXPECT_NE(bounds.at(Input::fill_depth).lower.at(surge_quantity).value,
            bounds.at(Input::fill_depth).upper.at(surge_quantity).value);
}

// Where no theory holds: the coarse run of the case, with waves that are higher by the same share
// as the input.
struct WithACoarseRun : OfARecord {
  WithACoarseRun() : OfARecord(Metric::amplitude_error, "forced", "1", 0.05, 2e-6) {
    definition.runs.at(0).solver = SphRun{"recommended", 0.03, 0.03};  // theory no more
    definition.inputs = {{Input::amplitude, 0.0002, "a ruler", "coarse_particles"}};
    for (const RunDefinition& run : runs_at_ends(definition.inputs[0], definition.runs.at(3))) {
      definition.runs.push_back(run);
      ends.push_back(run.name);
      raise(run.name, 1 + run.at_input->change / 0.02);
    }
  }
  void raise(const std::string& run, double factor) { set(run, scaled(elevation_of({}), factor)); }
  std::vector<std::string> ends;
};

TEST(RowUncertainty, OfAnInputThatNoTheoryTellsIsThatOfACoarseRunAtBothEnds) {
  WithACoarseRun row;
  EXPECT_NEAR(row.contributions().input.half_width.value(), 0.01, 4e-6);
  EXPECT_EQ(row.judged().verdict, Verdict::pass);
  row.raise(row.ends[1], 1.09);  // the larger of 9 % and 1 %
  EXPECT_NEAR(row.contributions().input.half_width.value(), 0.09, 4e-6);
  EXPECT_EQ(row.judged().verdict, Verdict::inconclusive);
}

TEST(RowUncertainty, OfAnInputThatACoarseRunDoesNotSeeIsUnknown) {
  WithACoarseRun row;
  for (const std::string& end : row.ends) row.raise(end, 1 + 2e-6);  // as the coarse run itself
  const GateOutcome outcome = row.judged();
  EXPECT_FALSE(outcome.judgement->contributions.input.half_width.has_value());
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  EXPECT_TRUE(holds(outcome.message, "it changes nothing of coarse_particles"));
}

// The refinement and the theory of the inputs, but no run that decides nothing.
TEST(RowUncertainty, NamesTheRunsThatItWasMeasuredWith) {
  OfARecord row(Metric::normalised_rms, "whole", "1", 0.05, 0.001);
  row.add("idle", "particles", 1.2);
  using Names = std::set<std::string>;
  EXPECT_EQ(row.judged().measured_with, (Names{"coarse_particles", "particles", "record"}));
  row.definition.inputs = {{Input::amplitude, 0.0002, "a ruler"}};
  EXPECT_EQ(row.judged().measured_with,
            (Names{"coarse_particles", "particles", "record", "theory"}));
  row.leave_out("coarse_particles");
  EXPECT_EQ(row.judged().measured_with, (Names{"particles", "record", "theory"}));
  row.runs.status["particles"] = {RunState::failed, "a particle left the tank"};
  EXPECT_EQ(row.judged().measured_with, Names{});
}

// "particles" improves on "bad", which is 10 % off, and so are their coarser runs.
struct OfAnImprovement : OfARecord {
  OfAnImprovement(double coarse, double own, double coarse_bad, double bad)
      : OfARecord(Metric::rms_error, "whole", "1", 0, coarse) {
    definition.gate[0].limit.reset();
    definition.gate[0].improves_on = "bad";
    add("bad", "particles", 1 + bad);
    add("coarse_bad", "coarse_particles", 1 + coarse_bad);
    set("particles", scaled(elevation_of({}), 1 + own));
    definition.refinements.push_back(
        {"of_bad", RefinedNumber::particle_spacing, {"coarse_bad", "bad"}});
  }
};

// A refinement that leaves 57 % open decides nothing between errors of 1 and 10 %.
TEST(RowUncertainty, OfARefinementCountsForAnImprovementToo) {
  for (const double coarse_error : {0.012, 0.2}) {
    const GateOutcome outcome = OfAnImprovement(coarse_error, 0.01, 0.11, 0.1).judged();
    EXPECT_EQ(outcome.verdict, coarse_error < 0.1 ? Verdict::pass : Verdict::inconclusive)
        << outcome.message;
  }
}

// What is clipped may be as exact as the candidate.
TEST(RowUncertainty, OfTheSamplesCountsForTheRunToImproveOnToo) {
  OfAnImprovement row(0.032, 0.03, -0.101, -0.1);
  EXPECT_EQ(row.judged().verdict, Verdict::pass) << row.judged().message;
  TimeSeries clipped = elevation_of({});
  const double most = 0.7 * *std::max_element(clipped.value.begin(), clipped.value.end());
  for (double& value : clipped.value) value = std::clamp(value, -most, most);
  row.set("bad", clipped);
  const GateOutcome outcome = row.judged();
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive) << outcome.message;
  EXPECT_TRUE(holds(outcome.message, "with bad as the candidate; doubtful: "));
}

TEST(RowUncertainty, OfAWideIntervalBetweenTwoRunsIsUnknown) {
  for (const double half_width : {17.0, 19.0}) {
    WithACoarseRun row;
    row.definition.runs.resize(4);
    for (const std::string& end : row.ends) {
      row.runs.results.erase(end);
      row.runs.status.erase(end);
    }
    row.definition.inputs = {{Input::start_phase, half_width, "a clock", "coarse_particles"}};
    for (const RunDefinition& run :
         runs_at_ends(row.definition.inputs[0], row.definition.runs.at(3))) {
      row.definition.runs.push_back(run);
      row.raise(run.name, 1.01);
    }
    EXPECT_EQ(row.contributions().input.half_width.has_value(), half_width < 18) << half_width;
  }
}

TEST(RowUncertainty, OfAnInputWithoutOneOfItsEndsIsUnknown) {
  WithACoarseRun row;
  row.runs.results.erase(row.ends[0]);
  row.runs.status[row.ends[0]] = {RunState::failed, "a particle left the tank"};
  EXPECT_FALSE(row.contributions().input.half_width.has_value());
  const CaseAssessment assessment = assess(row.definition, row.runs);
  EXPECT_EQ(assessment.runs.status.at(row.ends[0]).state, RunState::failed) << "told as such";
  EXPECT_EQ(exit_status(std::vector{assessment}), exit_solver_failed);
}

TEST(RowUncertainty, OfAnInputShowsNothingOfTheRunsThatTellIt) {
  const WithACoarseRun row;
  const CaseAssessment assessment = assess(row.definition, row.runs);
  EXPECT_EQ(assessment.definition.runs.size(), 4U);
  for (const std::string& end : row.ends) {
    EXPECT_FALSE(assessment.runs.results.contains(end));
    EXPECT_FALSE(assessment.runs.status.contains(end));
    for (const Comparison& comparison : assessment.comparisons)
      EXPECT_NE(comparison.candidate, end);
  }
}

TEST(WithInput, ChangesNothingButTheInput) {
  CaseDefinition definition = surge_case();
  definition.pressure_gauges = {{"p", Wall::left, 0.1}};
  EXPECT_EQ(with_input(definition, Input::fill_depth, 0.01).liquid.fill_depth, 0.36);
  EXPECT_EQ(with_input(definition, Input::density, 2).liquid.density, 1002);
  EXPECT_EQ(with_input(definition, Input::kinematic_viscosity, 1e-7).liquid.kinematic_viscosity,
            1.1e-6);
  EXPECT_NEAR(with_input(definition, Input::sensor_position, 0.01).gauges[0].x, 0.96, 1e-12);
  EXPECT_NEAR(with_input(definition, Input::sensor_position, 0.01).pressure_gauges[0].position,
              0.11, 1e-12);
  const double period = 2 * std::numbers::pi / (0.3 * 4.94488);
  const CaseDefinition slower = with_input(definition, Input::period, 0.01 * period);
  EXPECT_NEAR(std::get<SineMotion>(*slower.motion.surge).angular_frequency, 0.3 * 4.94488 / 1.01,
              1e-12);
  // A table of a roll, in degrees: its largest angle is 0.1 rad.
  definition.motion = {};
  definition.motion.roll = {TableMotion{"roll.csv", {0, 1, 2, 3}, {0, 0.1, 0, -0.05}}, 0.5, 0};
  definition.declared_forcing_frequency = std::numbers::pi;
  const CaseDefinition wider =
      with_input(definition, Input::amplitude, 0.01 * 180 / std::numbers::pi);
  EXPECT_NEAR(std::get<TableMotion>(wider.motion.roll->angle).value[3], -0.055, 1e-12);
  const CaseDefinition longer = with_input(definition, Input::period, 0.02);
  EXPECT_NEAR(std::get<TableMotion>(longer.motion.roll->angle).time[3], 3.03, 1e-12);
  EXPECT_NEAR(longer.declared_forcing_frequency.value(), std::numbers::pi / 1.01, 1e-12);
}

TEST(RowUncertainty, OfPublishedImpactsIsWhatTheCaseDeclares) {
  CaseDefinition definition = surge_case();
  ImpactsDefinition impacts{};
  impacts.plateau = 500;
  definition.impacts = impacts;
  GateRow row = surge_row("whole", Metric::plateau_error, "1", 0.1);
  row.reference.clear();
  const MeasureRow measure = [](const GateRow&) { return Estimate{0.1, 0}; };
  const auto reference = [&] {
    const RowMeasures measures{.measure = measure,
                               .input = [](const GateRow&) { return Contribution{}; }};
    return row_uncertainty(definition, surge_runs(), row, measures).reference.half_width;
  };
  EXPECT_FALSE(reference().has_value());
  definition.impacts->plateau_half_width = 10;
  EXPECT_NEAR(reference().value(), 1.1 * 10 / 500, 1e-12);
  definition.impacts->times = {1, 3};
  definition.impacts->peak_means = {4000, 5000};
  definition.impacts->arrivals = ArrivalsDefinition{0.5, {0.9, 2.9}};
  definition.impacts->impulses = ImpulsesDefinition{0.07, {300, 400}};
  row.mode = "impact_2";
  for (const Metric metric :
       {Metric::impact_arrival, Metric::impact_peak_error, Metric::impulse_error}) {
    row.metric = metric;
    EXPECT_FALSE(reference().has_value()) << metric_name(metric);
  }
  definition.impacts->arrivals->half_width = 0.002;
  definition.impacts->peaks_half_width = 100;
  definition.impacts->impulses->half_width = 8;
  row.metric = Metric::impulse_error;
  EXPECT_NEAR(reference().value(), 1.1 * 8 / 400, 1e-12);
  row.metric = Metric::impact_peak_error;
  EXPECT_NEAR(reference().value(), 1.1 * 100 / 5000, 1e-12);
  row.metric = Metric::impact_arrival;
  EXPECT_EQ(reference().value(), 0.002);
  row.kind = RowKind::regression;
  EXPECT_EQ(reference().value(), 0) << "it is as large as when the limit was measured";
}

TEST(RowUncertainty, OfAnEnsembleThatDrawsItsInputsCountsThemOnce) {
  CaseDefinition definition = surge_case();
  definition.impacts = ImpactsDefinition{};
  definition.impacts->period = 1.6;
  definition.impacts->arrivals = ArrivalsDefinition{0.5, {0.9}, 0.002};
  for (RunDefinition& run : definition.runs) run.varies_inputs = run.name == "particles";
  GateRow row = surge_row("impact_1", Metric::impact_arrival, "s", 0.1);
  row.reference.clear();
  const RowMeasures measures{.measure =
                                 [](const GateRow&) {
                                   return Estimate{0.02, 0};
                                 },
                             .input =
                                 [](const GateRow&) {
                                   ADD_FAILURE() << "[[input]] is in the scatter";
                                   return Contribution{};
                                 },
                             .pairs = [](const GateRow&) -> std::vector<std::vector<Estimate>> {
                               return {{{0.01, 0}}, {{0.02, 0}}, {{0.03, 0}}};
                             }};
  const auto input = [&] { return row_uncertainty(definition, surge_runs(), row, measures).input; };
  EXPECT_NEAR(input().half_width.value(), 4.30265 * 0.01, 1e-6);  // t s of three members
  EXPECT_EQ(input().basis, "the scatter of the 3 members, which draw the inputs");
  row.kind = RowKind::regression;
  EXPECT_EQ(input().half_width.value(), 0);
  row.kind = RowKind::validation;
  for (const Metric metric : {Metric::peak_median_error, Metric::peak_ks_p_value}) {
    row.metric = metric;
    EXPECT_EQ(input().half_width.value(), 0) << metric_name(metric);
  }
}

TEST(RowUncertainty, OfAPValueIsThatOfItsPermutationsAlone) {
  CaseDefinition definition = surge_case();
  definition.impacts = ImpactsDefinition{};
  GateRow row = surge_row("impact_1", Metric::peak_ks_p_value, "1", 0.1);
  row.reference.clear();
  const auto found = [&] {
    return row_uncertainty(definition, surge_runs(), row,
                           {.measure =
                                [](const GateRow&) {
                                  return Estimate{0.3, 0.01};
                                },
                            .input = [](const GateRow&) { return Contribution::unknown("x"); }});
  };
  EXPECT_EQ(missing_for_validation(found()), "");
  EXPECT_EQ(validation_uncertainty(found()), 0);
  EXPECT_TRUE(found().input.half_width);
  row.metric = Metric::peak_median_error;
  EXPECT_EQ(found().reference.half_width.value(), 0);
  EXPECT_FALSE(found().discretisation.half_width) << "particles is on no refinement path";
  EXPECT_FALSE(found().input.half_width);
}

TEST(ValidityEnvelope, LetsASmallWaveFarFromResonanceGate) {
  EXPECT_FALSE(
      outside_validity(surge_case(), surge_case().runs.at(0), surge_runs().results.at("theory")));
}

TEST(ValidityEnvelope, KeepsLinearTheoryFromGatingNearResonance) {
  CaseDefinition definition = surge_case();
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 0.98 * 4.96646};
  const auto reason =
      outside_validity(definition, definition.runs.at(0), surge_runs().results.at("theory"));
  ASSERT_TRUE(reason.has_value());
  EXPECT_NE(reason->find("0.98 times its natural mode 1"), std::string::npos) << *reason;
  // A tenth of the motion narrows the band by 10^(2/3): 4 % of detuning is outside then.
  definition.motion.surge = SineMotion{.amplitude = 0.0002, .angular_frequency = 0.98 * 4.96646};
  EXPECT_FALSE(
      outside_validity(definition, definition.runs.at(0), surge_runs().results.at("theory")));
}

TEST(ValidityEnvelope, KeepsLinearTheoryFromGatingASteepOrAHighWaveOrOneThatItDoesNotTell) {
  CaseDefinition definition = surge_case();
  RunResult theory = surge_runs().results.at("theory");
  theory.diagnostics["highest_elevation_over_depth"] = 0.11;
  EXPECT_NE(outside_validity(definition, definition.runs.at(0), theory)->find("0.11 fill depths"),
            std::string::npos);
  std::get<LinearRun>(definition.runs.at(0).solver).valid_elevation_over_depth = 1;
  theory.diagnostics["highest_elevation_over_depth"] = 0.19;  // k A = pi 0.19 0.35 = 0.209
  EXPECT_NE(outside_validity(definition, definition.runs.at(0), theory)->find("steepness"),
            std::string::npos);
  theory.diagnostics.clear();
  EXPECT_TRUE(outside_validity(definition, definition.runs.at(0), theory).has_value());
}

TEST(ValidityEnvelope, KeepsPotentialFlowFromGatingBeyondItsEnd) {
  CaseDefinition definition = surge_case();
  definition.runs.at(0).solver = PotentialRun{};
  RunResult flow = surge_runs().results.at("theory");
  flow.diagnostics = {{"valid_until_s", 12}};
  flow.provenance["left_range_because"] = "too steep";
  const auto reason = outside_validity(definition, definition.runs.at(0), flow);
  ASSERT_TRUE(reason.has_value());
  EXPECT_NE(reason->find("12 s, before the window's end at 20 s: too steep"), std::string::npos)
      << *reason;
  flow.diagnostics = {{"valid_until_s", 20}};
  EXPECT_FALSE(outside_validity(definition, definition.runs.at(0), flow));
}

}  // namespace
}  // namespace slosh::row_uncertainty_test
