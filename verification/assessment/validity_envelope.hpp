// Where a reference may gate. Outside its range its curve is still drawn, and never judges.
//   linear theory   elevation A (the largest that it predicts itself) over the fill depth: as the
//                   case declares; steepness k_1 A <= 0.2, k_1 = pi / L: the second order adds k A
//                   / 2 to a crest, a tenth there; and no natural mode that the motion excites
//                   nearer to the forcing than |(omega / omega_n)^2 - 1| = (b / L)^(2/3), b the
//                   motion's amplitude (theta L / 2 of a roll), where the response is no longer
//                   proportional to it (Moiseev 1958, J. Appl. Math. Mech. 22:860; Faltinsen 1974,
//                   J. Ship Res. 18:224)
//   potential flow  to where it has found itself out of its range (nonlinear_potential_flow.hpp),
//                   which must not be before the comparison's window ends
// Solvers and records have no such range.
#pragma once

#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

inline constexpr double steepest_linear_wave = 0.2;

// Why the reference is outside its range in this case; nothing where it is inside.
std::optional<std::string> outside_validity(const CaseDefinition& definition,
                                            const RunDefinition& run, const RunResult& result);

// Gives the references that are outside theirs that status.
void mark_out_of_range(const CaseDefinition& definition, CaseRuns& runs);

}  // namespace slosh
