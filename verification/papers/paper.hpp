// A paper as data: its figures, its claims and the findings that decide them, its errata, and what
// the schemes and cases do in another way than it says. Each paper is a file of
// verification/campaigns/papers whose keys are the members below.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slosh {

enum class Redrawn {
  history,     // a panel for each case and quantity: the time series
  spectrum,    // the same: the spectrum over the comparison window
  time_steps,  // a panel for each case and scheme of the paper: runs that differ in time step alone
  spacings,    // the same: runs that differ in particle spacing alone
  fields,      // by the fields of the case's own page
  not_at_all   // the row's `not_known` says why
};

// A figure. The papers' texts are at hand, their pictures are not: where a row says nothing of a
// time span or of an axis, the harness chose its own.
struct PaperFigure {
  std::string number;  // "1", "2 and 3"
  std::string shows;   // in our words
  Redrawn redrawn = Redrawn::history;
  std::vector<std::string> cases;
  std::vector<std::string> quantities;          // series of the cases, where the kind needs them
  std::pair<double, double> time_span_s{0, 0};  // equal ends: not known, the whole run
  // Time over the forcing's period, height over the still depth.
  bool without_dimensions = false;
  std::string not_known;  // of the paper's figure, beside its limits and its units
};

// A number of one run. Over periods: the window holds n whole periods T of the forcing from its
// beginning, n >= 1.
enum class Measure {
  mean,
  fluctuation,     // the rms about the mean of each period, which a slow drift does not change
  crest,           // the mean over periods of the highest value
  trough,          // the mean over periods of the lowest value, its magnitude
  largest,         // the highest value
  noise,           // the rms of what the case's filter of pressure takes out
  main_frequency,  // of the highest peak of the spectrum [Hz]
  // Of the peaks of the highest surface's spectrum at one and at two times the excitation
  // (SurfaceSpectrum), whatever the quantity: frequencies [Hz], powers [m2], and the first power
  // over the second.
  first_frequency,
  second_frequency,
  first_power,
  second_power,
  power_ratio,
  // Of the case's impacts, whatever the quantity, the mean over the impacts of
  // |log(peak / published mean)|, and of |time - published time| over the period.
  peak_distance,
  time_distance
};

enum class Stage {
  steady,            // the comparison window
  late,              // its second half
  first,             // from the start to the window
  first_over_steady  // the measure of the first stage over that of the steady one
};

// A quantity is the name of a series; "elevation" and "highest_surface" are those at the first
// gauge, "wall_pressure" the one that the case filters, "momentum" is momentum_magnitudes().
struct Measured {
  std::string quantity;
  Measure measure = Measure::mean;
  Stage stage = Stage::steady;
};

enum class Relation {
  within,        // from lower to upper
  at_least,      // holds from upper on, is refuted up to lower, undecided in between
  at_most,       // up to upper
  within_factor  // from lower = 1 / upper to upper
};

struct Threshold {
  Relation relation = Relation::within;
  double lower = 0, upper = 0;
};

// A number that speaks for or against a claim, and what it is held against.
struct FindingRow {
  std::string evidence;            // the name of a function in wave_ or pressure_findings.cpp
  std::vector<std::string> cases;  // by name
  // The names that the function expects, in its order. The first run is the one that the claim is
  // about.
  std::vector<std::string> runs;
  std::string name;                // of the number, in the finding's text
  std::string quantity;            // a series or a fitted mode, where the function needs one
  std::vector<Measured> measures;  // the measured one, and that by which it is divided
  std::vector<Threshold> thresholds;
  double printed = 1;  // the paper's number, by which the measured one is divided
  // Whether the claim is about the flow, so that interFoam gives a second finding: the finest run
  // of the first case that has three repeats or more, or the finest of all where none has.
  bool by_finest_mesh_too = false;
  // Whether single runs say nothing, as their histories are chaotic and the claim compares two.
  bool by_repeats = false;
};

// A claim has findings, rests on others, or has the reason why no run can decide it.
struct Claim {
  std::string number;                // the paper's: "C5.1", "conclusion 3"
  std::string statement;             // in our words
  std::vector<std::string> figures;  // of the paper that show it
  std::string printed;               // its own numbers
  std::vector<FindingRow> findings;
  std::vector<std::string> rests_on;  // numbers of claims whose findings are its own too
  std::string not_decidable;
};

struct Erratum {
  std::string paper, correction, computed;  // what it prints, what is meant, by which numbers
  std::vector<std::string> figures;
};

// What a scheme or a case of a paper does in another way than the paper says.
struct Deviation {
  std::string of;       // the schemes or cases
  std::string printed;  // what the paper says, or that it says nothing
  std::string here, why;
};

struct Paper {
  std::string name;                  // in campaign files: "li2010"
  std::string citation;              // "Li et al. 2010"
  std::vector<std::string> schemes;  // SPH schemes that follow the paper, as families of runs
  double particle_spacing_m = 0;     // the paper's, as far as it is known
  std::vector<std::string> text;     // the paragraphs above the claims
  std::vector<PaperFigure> figures;  // in the paper's order
  std::vector<Claim> claims;
  std::vector<Erratum> errata;
  std::vector<Deviation> deviations;
};

// Reads the paper's file once. Throws std::invalid_argument where no paper has the name.
const Paper& paper_named(const std::string& name);

// The file as it is read, and the paper that was read, as JSON: all that the one has the other has.
std::pair<std::string, std::string> file_and_paper(const std::string& name);

}  // namespace slosh
