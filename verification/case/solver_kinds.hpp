// The kinds of solvers, one row each in solver_kinds.cpp: what a run of a kind is, as far as that
// is known without running it. What runs it is chosen in verification/solvers/solver_runs.hpp.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

enum class SolverRole {
  simulation,  // a candidate: SPH, interFoam, an external program, a stored result of one
  theory,      // an exact solution inside its range
  record       // a published or earlier time series
};

// What determines a solver's answer beside its own code.
enum class AnsweredWith { own_code, openfoam, user_program, stored_files };

// What holds for every run of a kind.
struct SolverKind {
  const char* name;  // in case files and results
  SolverRole role;
  AnsweredWith answered_with = AnsweredWith::own_code;
  const char* build = nullptr;     // the kind whose file of builds counts; its own where null
  const char* elements = "nodes";  // what a result's cost counts
  bool solves_flow = false;        // it leaves the fields of the whole flow in its result
  bool has_particles = false;      // it can write snapshot files, and states to restart from
  bool takes_time_limit = false;   // of wall time, from the command line
  bool can_refer = true;           // `slosh converge` may take it as the reference
  bool can_end_early = false;      // its series may end before the case's duration
  // The suffixes of the series that a theory leaves beside each of its own, for its uncertainty.
  std::array<const char*, 2> leaves = {};
  bool takes_outline = false;        // it takes a tank that is no rectangle
  bool declares_quantities = false;  // its keys name the quantities that it has
};

const SolverKind& solver_kind(const RunDefinition& run);

// Returns nullptr where no kind has the name.
const SolverKind* find_solver_kind(std::string_view name);

// The names of all kinds whose answer is determined so.
std::set<std::string> solvers_answered_with(AnsweredWith what);

// The names of all kinds that take a tank which is no rectangle, in the order of the rows.
std::vector<std::string> solvers_that_take_outlines();

inline std::string solver_name(const RunDefinition& run) { return solver_kind(run).name; }
inline bool is_simulation(const RunDefinition& run) {
  return solver_kind(run).role == SolverRole::simulation;
}
inline bool is_theory(const RunDefinition& run) {
  return solver_kind(run).role == SolverRole::theory;
}
inline bool is_record(const RunDefinition& run) {
  return solver_kind(run).role == SolverRole::record;
}

// Whether the run only reads what another code left elsewhere, so that its cost is not of this
// machine.
inline bool is_stored(const RunDefinition& run) {
  return solver_kind(run).answered_with == AnsweredWith::stored_files;
}

// Whether the run counts the gas above the liquid: OpenFOAM's programs and two-layer linear theory.
bool sees_gas(const RunDefinition& run);

// The solver and its settings in words: for a report's list of runs, with `code` in backticks, and
// for the caption of a figure.
std::string solver_text(const RunDefinition& run);
std::string caption_text(const RunDefinition& run);

// The solver's settings that determine the result's numbers, for the hash in the run's key.
nlohmann::json hashed_settings(const RunDefinition& run);

// Runs of a family differ in resolution alone: SPH by its scheme, an external program and a stored
// result by its method, each program of OpenFOAM as such, any other run by itself.
std::string family(const RunDefinition& run);

// The spacing inside the liquid [m], of SPH, of a stored result, and of an external program that
// has one.
std::optional<double> particle_spacing(const RunDefinition& run);

// The method of an external program or of a stored result; empty for a run without one.
std::string method_of(const RunDefinition& run);

// Grows with the resolution; comparable within a family.
double resolution(const RunDefinition& run);

// [particle spacings] A start disorder up to this size only tells the repeats of a run apart; it
// changes nothing of the scheme.
inline constexpr double unseen_disorder = 1e-4;

// What a run changes of its scheme: "", "antuono", "courant_number = 0.4", ...
std::string changes_of(const SphRun& run);
// The same of any run. Of a mesh it is what has not its default; other runs change nothing.
std::string changes_of(const RunDefinition& run);

// Whether the run's series of the quantity counts from its first value, which is then 0 whatever
// the program prints.
bool counts_from_its_first_value(const CaseDefinition& definition, const std::string& run,
                                 const std::string& quantity);

// Whether a run has something of its scheme changed.
bool is_changed(const RunDefinition& run);

// The family, and what the run changes of its scheme: "recommended", "recommended, courant_number =
// 0.4", "interFoam", ... Costs and biases are judged within it.
std::string work_family(const RunDefinition& run);

}  // namespace slosh
