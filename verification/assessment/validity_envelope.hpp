// The range in which a reference may gate. Outside its range its curve is still drawn, but it never
// judges.
//   linear theory   The case declares the largest valid elevation A, as the theory itself predicts
//                   it, over the fill depth. The steepness is limited to k A <= 0.2, k = m pi / L
//                   of an initial wave of mode m or else pi / L, where the second order adds k A
//                   / 2, a tenth, to a crest. No natural mode that the motion excites may be nearer
//                   to the forcing than
//                   |(omega / omega_n)^2 - 1| = (b / L)^(2/3), b the motion's amplitude (theta L /
//                   2 for a roll): nearer to it the response is no longer proportional to b
//                   (Moiseev 1958, J. Appl. Math. Mech. 22:860; Faltinsen 1974, J. Ship Res.
//                   18:224).
//                   The elevation stays below the roof.
//   potential flow  It is valid up to the time at which it has left its range itself
//                   (nonlinear_potential_flow.hpp). The comparison's window must end by then.
//   both            The bulk of the liquid, where the theory has no viscosity, damps the first wave
//                   by at most 0.5 % until the window's end. The gas, where it has none, lowers the
//                   first natural frequency by at most 0.5 %.
// Solvers and records have no such range.
#pragma once

#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

inline constexpr double steepest_linear_wave = 0.2;

// Returns the range of a theory's result in words, with the numbers of this case. Empty for
// solvers and records.
std::string validity_range(const CaseDefinition& definition, const RunDefinition& run,
                           const RunResult& result);

// Returns k A, with k = pi / L, or m pi / L of an initial wave of mode m, and A the highest
// elevation that a theory of small waves predicts; NaN for any other result.
double predicted_steepness(const CaseDefinition& definition, const RunResult& result);

// Why the reference is outside its range in this case. Returns nullopt where it is inside.
std::optional<std::string> outside_validity(const CaseDefinition& definition,
                                            const RunDefinition& run, const RunResult& result);

// Sets the status of the references outside their range to RunState::out_of_range.
void mark_out_of_range(const CaseDefinition& definition, CaseRuns& runs);

}  // namespace slosh
