// The claims of Zhao et al. 2021 under the paper's numbers, and what is not as it prints.
#include "verification/papers/paper_claims.hpp"

namespace slosh {
namespace {

using namespace evidence;
using namespace paper_cases;
using Rows = std::vector<FindingRow>;

// "The same trend", in phase [deg]: three times the digitised record's 0.03 s at 2 rad/s.
const Threshold agreeing_lag = within_range(-10, 10);
// In shape: the record exceeds linear theory's amplitude by 14 %, and digitising errs by up to 2 %
// of its largest value, 3.6 kPa, which is 28 % of its rms of 0.255 kPa; as independent errors they
// make hypot(0.14, 0.28) = 0.31.
const Threshold agreeing_shape = within_range(0, 0.35);
// "Large oscillations at first": twice those that remain.
const Threshold large_at_first = at_least_between(1, 2);
// "The trends agree, the values differ slightly", "close": curves that differ by a tenth of their
// rms coincide in a figure, and so do fields that differ by a tenth of the pressure under the
// depth.
const Threshold slightly_different = within_range(0, 0.1), close_fields = within_range(0, 0.1);
// "Captures the surface's shape well": two rows of cells along the surface are 4 % of the mildly
// rolling tank's liquid.
const Threshold surface_captured = within_range(0, 0.05);
// An impact "at" its time: within a twentieth of the period.
const Threshold in_time = at_most(0.05);
// "The trends agree basically": a third of the variance in common; a tenth is none.
const Threshold agreeing_trend = at_least_between(0.3, 0.6);
// A plateau that "agrees": within a quarter.
const Threshold agreeing_plateau = within_range(-0.25, 0.25);
// A peak "agrees" within the repeats' central 90 %: quantiles of 5 and 95 %, or, where the table is
// not supplied, as many standard deviations of a normal distribution.
const Threshold among_repeats = within_range(5, 95);  // [%]
const Threshold near_mean_of_repeats = within_range(-1.645, 1.645);
// One of four peaks may lie outside: of four repeats of the experiment itself, all lie inside in
// 66 % of all cases, at least three in 95 %.
const Threshold peaks_outside = at_most(1);
// "More stable": smaller by a fifth at least; a fifth to the other side speaks against it, and in
// between the two are alike. Counts must also differ by more than they scatter.
const Threshold smaller_by_a_fifth = at_most(0.8);

const std::string moving = "moving_7p5mm", fixed = "fixed_7p5mm", record = "akyildiz",
                  mesh = "interfoam_92x62";
// The finest of either way in the violent roll: the moving ones have no run at the paper's 2 mm.
const std::string violent_fixed = "fixed_2mm", violent_moving = "moving_4mm";

// One row for either way, by its run and the others that the function needs.
Rows for_both(const FindingRow& row, const std::string& first, const std::string& second,
              const std::vector<std::string>& others = {}) {
  Rows rows;
  for (const std::string& run : {first, second}) {
    rows.push_back(row);
    rows.back().runs = {run};
    rows.back().runs.insert(rows.back().runs.end(), others.begin(), others.end());
  }
  return rows;
}

Rows joined(Rows rows, const Rows& others) {
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

// A distance of the impacts from the record, of one run over that of another, both ensembles.
FindingRow distance(Measure measure, const std::string& of, const std::string& over) {
  return {.evidence = ratio,
          .cases = {violent},
          .runs = {of, over},
          .name = measure == Measure::peak_distance ? "distance of the peaks from the published"
                                                    : "distance of their times from the record's",
          .of = {"", measure},
          .thresholds = {clearly_more},
          .by_repeats = true};
}

std::vector<PaperClaim> mild_claims() {
  return {
      {.number = "Z3.1",
       .statement = "Both ways, with boundary particles that move with the tank or are fixed in "
                    "its frame, follow the same trend as the experiment's pressure at A.",
       .figures = {"3"},
       .findings = joined(
           for_both(
               {.evidence = phase_against_record, .cases = {mild}, .thresholds = {agreeing_lag}},
               moving, fixed, {record}),
           for_both(
               {.evidence = shape_against_record, .cases = {mild}, .thresholds = {agreeing_shape}},
               moving, fixed, {record}))},
      {.number = "Z3.2",
       .statement = "Fixed is nearer to the experiment than moving.",
       .figures = {"3"},
       .findings = {{.evidence = nearer_to_record,
                     .cases = {mild},
                     .runs = {fixed, moving, record},
                     .thresholds = {clearly_more}}}},
      {.number = "Z4.1",
       .statement = "Force and moment of moving have large numerical oscillations at first and are "
                    "steady from about 1.0 s.",
       .figures = {"4"},
       .findings = {{.evidence = ratio,
                     .cases = {mild},
                     .runs = {moving},
                     .name = "noise of force x before 1 s over that after it",
                     .of = {"force_x", Measure::noise, Stage::first},
                     .over = Measured{"force_x", Measure::noise},
                     .thresholds = {large_at_first}},
                    {.evidence = ratio,
                     .cases = {mild},
                     .runs = {moving},
                     .name = "noise of the moment before 1 s over that after it",
                     .of = {"moment", Measure::noise, Stage::first},
                     .over = Measured{"moment", Measure::noise},
                     .thresholds = {large_at_first}}}},
      {.number = "Z4.2",
       .statement = "The trends of both ways agree, the values differ slightly.",
       .figures = {"4"},
       .findings = {{.evidence = difference_of_runs,
                     .cases = {mild},
                     .runs = {moving, fixed},
                     .quantity = "force_x",
                     .thresholds = {slightly_different}},
                    {.evidence = difference_of_runs,
                     .cases = {mild},
                     .runs = {moving, fixed},
                     .quantity = "moment",
                     .thresholds = {slightly_different}}}},
      {.number = "Z5.1",
       .statement = "The pressure fields of both ways are close.",
       .figures = {"5"},
       .findings = {{.evidence = difference_of_fields,
                     .cases = {mild},
                     .runs = {moving, fixed, mesh},
                     .thresholds = {close_fields}}}},
      {.number = "Z5.2",
       .statement = "Both ways capture the surface's shape well.",
       .figures = {"5"},
       .findings = for_both(
           {.evidence = surface_against_mesh, .cases = {mild}, .thresholds = {surface_captured}},
           moving, fixed, {mesh})},
  };
}

std::vector<PaperClaim> violent_claims() {
  const std::string no_photographs =
      "the experiment's photographs are not at hand; figure 9's fields stand in the report for the "
      "eye";
  const std::vector<std::string> pairs{
      "moving_8mm", "fixed_8mm",        "moving_6mm",      "fixed_6mm",        "moving_4mm",
      "fixed_4mm",  "moving_4mm_cfl01", "fixed_4mm_cfl01", "moving_4mm_cfl04", "fixed_4mm_cfl04"};
  const auto both_ways = [](const FindingRow& row) {
    return for_both(row, violent_fixed, violent_moving);
  };
  return {
      {.number = "Z8.1",
       .statement = "The times of the pressure peaks at B agree with the experiment.",
       .figures = {"8"},
       .findings =
           both_ways({.evidence = impact_times, .cases = {violent}, .thresholds = {in_time}})},
      {.number = "Z8.2",
       .statement = "The trends of moving, fixed and experiment agree basically.",
       .figures = {"8"},
       .findings = for_both(
           {.evidence = trend_against_record, .cases = {violent}, .thresholds = {agreeing_trend}},
           violent_fixed, violent_moving, {"spheric"})},
      {.number = "Z8.3",
       .statement = "Both ways have good accuracy.",
       .figures = {"8"},
       .findings =
           joined(both_ways({.evidence = plateau_against_published,
                             .cases = {violent},
                             .thresholds = {agreeing_plateau}}),
                  both_ways({.evidence = peaks_among_repeats,
                             .cases = {violent},
                             .thresholds = {among_repeats, near_mean_of_repeats, peaks_outside}})),
       .rests_on = {"Z8.1"}},
      {.number = "Z9.1",
       .statement = "Both ways capture impact and splash, at 3.45 and 4.35 s.",
       .figures = {"9"},
       .not_decidable = no_photographs},
      {.number = "Z9.2",
       .statement = "Both ways capture overturning, at 3.95 and 4.75 s.",
       .figures = {"9"},
       .not_decidable = no_photographs},
      {.number = "Z10.1",
       .statement = "Fixed is the more stable.",
       .figures = {"10"},
       .findings = {{.evidence = fixed_more_stable,
                     .cases = {violent},
                     .runs = pairs,
                     .thresholds = {smaller_by_a_fifth}}}},
      {.number = "Z11.1",
       .statement = "As the spacing falls, both ways come nearer to the experiment. Here from 8 to "
                    "4 mm.",
       .figures = {"11"},
       .findings = {distance(Measure::peak_distance, "moving_8mm", "moving_4mm"),
                    distance(Measure::time_distance, "moving_8mm", "moving_4mm"),
                    distance(Measure::peak_distance, "fixed_8mm", "fixed_4mm"),
                    distance(Measure::time_distance, "fixed_8mm", "fixed_4mm")}},
      {.number = "Z11.2",
       .statement = "Fixed changes less with the spacing.",
       .figures = {"11"},
       .findings = {{.evidence = fixed_changes_less,
                     .cases = {violent},
                     .runs = {"moving_8mm", "moving_4mm", "fixed_8mm", "fixed_4mm"},
                     .thresholds = {clearly_more}}}},
      {.number = "Z11.3",
       .statement = "So it converges better: it changes less, and ends nearer to the experiment.",
       .figures = {"11"},
       .findings = {distance(Measure::peak_distance, "moving_4mm", "fixed_4mm"),
                    distance(Measure::time_distance, "moving_4mm", "fixed_4mm")},
       .rests_on = {"Z11.2"}},
      {.number = "conclusion",
       .statement = "Both ways simulate sloshing effectively; fixed has the better stability.",
       .figures = {"3", "8", "10"},
       .rests_on = {"Z3.1", "Z8.3", "Z10.1"}},
  };
}

std::vector<Deviation> zhao2021_deviations() {
  return {
      {"both schemes",
       "artificial compressibility; neither equation of state nor speed of sound "
       "is in the text that we have",
       "Tait's equation with gamma = 7, c0 = 10 V_max, V_max = sqrt(g h) + the tank's largest "
       "speed",
       ""},
      {"both schemes", "Monaghan's viscosity, without its number",
       "alpha = beta = 0.1 on approaching pairs, with c0 for the pair's mean of c", ""},
      {"both schemes", "Wendland C2, without h over the spacing", "h = 1.5 dp",
       "the lattice then hardly clumps; particles act within 2 h, as printed"},
      {"both schemes", "boundary particles obey continuity and the equation of state",
       "as printed, but a density below the rest density is raised to it",
       "the wall does not attract the liquid"},
      {"both schemes", "rows and pitch of the boundary particles are not in the text that we have",
       "layers as deep as the kernel's support, one particle spacing apart, the first half a "
       "spacing behind the wall",
       ""},
      {"both schemes", "what stops a particle that passes the boundary particles is not told",
       "it is exchanged with its mirror image and counted", ""},
      {"both schemes", "rho0 = 1000 kg/m3, no air",
       "no air; the density without pressure is lower by the still liquid's mean compression",
       "the tank then holds the mass of its liquid"},
      {"zhao2021_moving", "walls updated before the fluid, in predictor and corrector",
       "boundary particles at the time of each evaluation of the sums", ""},
      {"both schemes", "CFL 0.2 (violent roll)",
       "the shortest of 0.2 h / c, 0.25 sqrt(h / |a|) and 0.0625 h^2 / nu, for both rolls",
       "h and c of that number, and the other limits, are not printed"},
      {"zhao2021_mild_roll", "pressure at A on the right wall", "on the left wall",
       "the paper's roll begins clockwise, as the record tells"},
      {"zhao2021_mild_roll", "start not told", "at rest in the tank (`start = \"tank\"`)",
       "a liquid at rest in the earth would be struck at once"},
      {"zhao2021_mild_roll", "spacing not told", "10 and 7.5 mm", "finer runs cost hours"},
      {"zhao2021_violent_roll", "dp = 2 mm",
       "fixed at 2 mm, moving at 4 mm; the study over spacings has 8, 6 and 4 mm",
       "a run at 2 mm takes 41 minutes; the paper's spacings are not told"},
      {"zhao2021_violent_roll", "density not told", "998 kg/m3", "the benchmark's water"},
      {"zhao2021_violent_roll", "one run of each spacing",
       "four repeats at 8, 6 and 4 mm, with a start disordered by a thousandth of the spacing; of "
       "these Z8.1 to Z10.1 are judged on the first alone",
       "after the first impact the motion is chaotic: claims on the spacing need ensembles"},
      {"zhao2021_violent_roll", "probe B 0.0093 m above the bottom",
       "0.093 m, over a sensor of "
       "4.2 mm",
       "a misprint"},
      {"zhao2021_violent_sine", "omega_r = 1.631 rad/s", "4 deg sin(3.85 t), of the period 1.631 s",
       "an erratum; the experiment made another roll, that of zhao2021_violent_roll"},
  };
}

}  // namespace

const ClaimsOfPaper& zhao2021_claims() {
  static const ClaimsOfPaper all = [] {
    ClaimsOfPaper paper{"zhao2021", mild_claims(), zhao2021_deviations()};
    for (const PaperClaim& claim : violent_claims()) paper.claims.push_back(claim);
    return paper;
  }();
  return all;
}

}  // namespace slosh
