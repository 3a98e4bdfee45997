#include "verification/papers/paper_claims.hpp"

#include "verification/case/ensemble.hpp"
#include "verification/papers/claim_evidence.hpp"

namespace slosh {
namespace {

using std::string;

// The thresholds turn a number into a verdict. They were set before the numbers were looked at;
// where the papers say only "agrees" or "slightly", a threshold is this harness's reading of the
// word.

// "The same period": over the 12 s, nearly ten periods, that Li et al.'s figure 1 shows, 2 % shift
// the wave by a fifth of a period, which is clearly visible.
const Threshold same_period = within_range(-0.02, 0.02);
// "Slightly below theory": at most a fifth.
const Threshold slightly_below = within_range(-0.2, 0);
// "Flattened crests": a cos t + c cos 2t has the skewness 2.1 c / a and crests 1 + 2 c / a times as
// high as its troughs are deep; a skewness of 0.05 less than theory's means crests 5 % flatter.
const Threshold flattened = at_least_between(0, 0.05);
// "Far above linear theory's validity": three times the tenth of the depth up to which the
// small-amplitude case lets linear theory gate.
const Threshold violent_over_depth = at_least_between(0.3, 0.3);
// "Crests higher than troughs are deep": clearly so at a quarter, not at all at equality.
const Threshold crest_over_trough = at_least_between(1, 1.25);
// A peak "at" a frequency: within 2 %. Two printed digits of 0.77 Hz are +-0.7 %, the spectrum's
// peak is accurate to 0.3 %, and 2.3 % away is the 0.787 Hz that the paper also prints.
const Threshold at_frequency = within_range(-0.02, 0.02);
// "Grows", "faster": by a tenth at least. The interval of a spectral peak's power is unknown.
const Threshold grows = at_least_between(1, 1.1);
// A printed ratio of powers is met within a factor of two: the ratio does not depend on the unknown
// unit, but on the spectrum's window, which the paper does not describe.
const Threshold near_printed = within_factor(2);
// "Agrees in phase" [deg]: three times the digitised record's 0.03 s at 2 rad/s.
const Threshold agreeing_lag = within_range(-10, 10);
// "Agrees in shape": the record exceeds linear theory's amplitude by 14 %, and digitising errs by
// up to 2 % of its largest value, 3.6 kPa, which is 28 % of its rms of 0.255 kPa; as independent
// errors they make hypot(0.14, 0.28) = 0.31.
const Threshold agreeing_shape = within_range(0, 0.35);
// "The same": curves that differ by a tenth of their rms coincide in a figure.
const Threshold same_history = within_range(0, 0.1);
// An impact "at" its time: within a twentieth of the period.
const Threshold in_time = at_most(0.05);
// A plateau that "agrees": within a quarter.
const Threshold agreeing_plateau = within_range(-0.25, 0.25);
// A peak "agrees" within the repeats' central 90 %: quantiles of 5 and 95 %, or, where the table is
// not supplied, as many standard deviations of a normal distribution.
const Threshold among_repeats = within_range(5, 95);  // [%]
const Threshold near_mean_of_repeats = within_range(-1.645, 1.645);
// One of four peaks may lie outside: of four repeats of the experiment itself, all lie inside in
// 66 % of all cases, at least three in 95 %.
const Threshold peaks_outside = at_most(1);
// "More stable", "converges better": smaller by a fifth at least; a fifth to the other side speaks
// against it, and in between the two are alike. Counts must also differ by more than they scatter.
const Threshold smaller_by_a_fifth = at_most(0.8);

}  // namespace

// A claim on Li et al.'s scheme is decided by the paper's own scheme at its spacing, one on the
// flow also by the finest interFoam run that has repeats.
const std::vector<PaperClaim>& paper_claims() {
  using namespace evidence;
  using namespace paper_cases;
  static const std::vector<PaperClaim> claims{
      {"li2010",
       "SPH with repulsive and mirror particles follows linear theory at small amplitude: the same "
       "period, the amplitude slightly below theory, crests flattened.",
       "Li et al. 2010, conclusion (1), figure 1",
       {"1"},
       {{.evidence = frequency_against_theory,
         .cases = {small},
         .runs = {"li2010_20mm", "linear"},
         .name = "first natural frequency against theory",
         .quantity = "natural_1",
         .thresholds = {same_period}},
        {.evidence = amplitude_against_theory,
         .cases = {small},
         .runs = {"li2010_20mm", "linear"},
         .name = "forced amplitude against theory",
         .quantity = "forced",
         .thresholds = {slightly_below}},
        {.evidence = flattened_crests,
         .cases = {small},
         .runs = {"li2010_20mm", "linear"},
         .thresholds = {flattened}}}},
      {"li2010",
       "Near resonance and at large amplitude the motion is violent and nonlinear: crests far "
       "above linear theory's validity, higher than the troughs are deep.",
       "Li et al. 2010, conclusion (2)",
       {"2 and 3", "5"},
       {{.evidence = violent_motion,
         .cases = {b075},
         .runs = {"li2010_20mm"},
         .thresholds = {violent_over_depth, crest_over_trough},
         .by_finest_mesh_too = true},
        {.evidence = violent_motion,
         .cases = {b125},
         .runs = {"li2010_20mm"},
         .thresholds = {violent_over_depth, crest_over_trough},
         .by_finest_mesh_too = true}}},
      {"li2010",
       "The spectrum of the highest surface elevation at x = 0.95 m has two peaks, at the "
       "excitation (0.77 Hz) and at twice it (1.54 Hz), and both grow with the amplitude.",
       "Li et al. 2010, conclusion (3)",
       {"7"},
       {{.evidence = peaks_at_multiples,
         .cases = {b075, b125},
         .runs = {"li2010_20mm"},
         .thresholds = {at_frequency, grows},
         .by_finest_mesh_too = true}}},
      {"li2010",
       "The power grows faster at the first peak: from b = 0.075 to 0.125 m the ratio of the first "
       "to the second grows from 2.00 to 4.915.",
       "Li et al. 2010, conclusion (4)",
       {"7"},
       {{.evidence = growth_of_peak_ratio,
         .cases = {b075, b125},
         .runs = {"li2010_20mm"},
         .thresholds = {grows, near_printed},
         .printed = {2.00, 4.915},
         .by_finest_mesh_too = true}}},
      {"zhao2021",
       "The pressure at the gauge of the mildly rolling tank agrees with the experiment in shape "
       "and phase.",
       "Zhao et al. 2021, conclusions, mild roll",
       {"3"},
       {{.evidence = phase_against_record,
         .cases = {mild},
         .runs = {"moving_7p5mm", "akyildiz"},
         .thresholds = {agreeing_lag}},
        {.evidence = shape_against_record,
         .cases = {mild},
         .runs = {"moving_7p5mm", "akyildiz"},
         .thresholds = {agreeing_shape}},
        {.evidence = phase_against_record,
         .cases = {mild},
         .runs = {"fixed_7p5mm", "akyildiz"},
         .thresholds = {agreeing_lag}},
        {.evidence = shape_against_record,
         .cases = {mild},
         .runs = {"fixed_7p5mm", "akyildiz"},
         .thresholds = {agreeing_shape}}}},
      {"zhao2021",
       "Moving and fixed dynamic boundary particles give the same mild roll.",
       "Zhao et al. 2021, conclusions, mild roll",
       {"3", "4"},
       {{.evidence = difference_of_runs,
         .cases = {mild},
         .runs = {"moving_7p5mm", "fixed_7p5mm"},
         .quantity = "wall_pressure",
         .thresholds = {same_history}},
        {.evidence = difference_of_runs,
         .cases = {mild},
         .runs = {"moving_7p5mm", "fixed_7p5mm"},
         .quantity = "force_x",
         .thresholds = {same_history}},
        {.evidence = difference_of_runs,
         .cases = {mild},
         .runs = {"moving_7p5mm", "fixed_7p5mm"},
         .quantity = "moment",
         .thresholds = {same_history}}}},
      {"zhao2021",
       "The violent roll's impact pressure agrees with the experiment.",
       "Zhao et al. 2021, conclusions, violent roll",
       {"8"},
       {{.evidence = impact_times,
         .cases = {violent},
         .runs = {"fixed_2mm"},
         .thresholds = {in_time}},
        {.evidence = plateau_against_published,
         .cases = {violent},
         .runs = {"fixed_2mm"},
         .thresholds = {agreeing_plateau}},
        {.evidence = evidence::peaks_among_repeats,
         .cases = {violent},
         .runs = {"fixed_2mm"},
         .thresholds = {among_repeats, near_mean_of_repeats, peaks_outside}}}},
      {"zhao2021",
       "Fixed boundary particles are more stable than moving ones.",
       "Zhao et al. 2021, conclusions, violent roll",
       {"10", "11"},
       {{.evidence = fixed_more_stable,
         .cases = {violent},
         .runs = {"8mm", "6mm", "4mm", "4mm_cfl01", "4mm_cfl04"},
         .thresholds = {smaller_by_a_fifth}}}},
      {"zhao2021",
       "Fixed boundary particles converge better with time step and spacing.",
       "Zhao et al. 2021, conclusions, figures 10 and 11",
       {"10", "11"},
       {{.evidence = fixed_converges_better,
         .cases = {violent},
         .runs = {"8mm", "6mm", "4mm"},
         .name = "spacing",
         .thresholds = {smaller_by_a_fifth}},
        {.evidence = fixed_converges_better,
         .cases = {violent},
         .runs = {"4mm", "4mm_cfl04", "4mm_cfl01"},
         .name = "time step",
         .thresholds = {smaller_by_a_fifth}}}}};
  return claims;
}

namespace {

// The interval of a mean over fewer repeats of a wave that breaks is too wide to decide anything.
constexpr std::size_t enough_repeats = 3;

// Returns the finest interFoam run that the case declares, with or without a result, of those with
// enough repeats, or of all where none has enough. Empty where there is none.
string finest_mesh(const CaseDefinition& definition) {
  string finest;
  std::pair<bool, double> highest{false, 0};  // whether it has enough repeats, and its cells
  for (const RunDefinition& run : definition.runs) {
    const InterFoamRun* mesh = std::get_if<InterFoamRun>(&run.solver);
    if (!mesh || mesh->program != FoamProgram::inter_foam || is_later_member(run)) continue;
    const std::pair rank{members_of(definition, run.name).size() >= enough_repeats,
                         number_of_cells(*mesh)};
    if (rank <= highest) continue;
    highest = rank;
    finest = run.name;
  }
  return finest;
}

// Returns the row, and where it asks for it the same row for the finest mesh of its first case.
std::vector<FindingRow> rows_to_evaluate(const FindingRow& row,
                                         const std::vector<CaseAssessment>& cases) {
  std::vector<FindingRow> rows{row};
  const CaseAssessment* assessment = find_case(cases, row.cases.front());
  if (!row.by_finest_mesh_too || !assessment) return rows;
  if (const string mesh = finest_mesh(assessment->definition); !mesh.empty()) {
    rows.push_back(row);
    rows.back().runs.front() = mesh;
  }
  return rows;
}

}  // namespace

std::vector<Claim> claims_of(const string& paper, const std::vector<CaseAssessment>& cases) {
  std::vector<Claim> claims;
  for (const PaperClaim& one : paper_claims()) {
    if (one.paper != paper) continue;
    Claim claim{one.statement, one.source, one.figures, {}};
    for (const FindingRow& row : one.findings)
      for (const FindingRow& each : rows_to_evaluate(row, cases))
        claim.findings.push_back([each, &cases] { return each.evidence(cases, each); });
    claims.push_back(std::move(claim));
  }
  if (claims.empty()) throw std::invalid_argument("no paper has the name " + paper);
  return claims;
}

}  // namespace slosh
