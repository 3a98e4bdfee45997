// A model of a run's cost: the steps and elements that it computes (runs/run_effort.hpp) times the
// measured time of one of them (tests/cost_model_test.cpp holds the figures).
//   SPH         steps x particles x evaluations x (24 + 1.16 n) ns x terms, n = pi (s h / dp)^2
//               neighbours within the kernel's support s h
//   interFoam   0.5 s + steps x (0.36 ms + (corrections + 2) / 4 x cells x 0.83 us), three times
//               the steps' part in a shallow tank
//   potential   samples x (nodes^1.6 of both grids) x 0.06 us, of a roll 1.6 times that
//   linear      samples x modes x 0.2 us
// times a factor for a machine at work. The model is valid within a factor of 1.5 for runs of more
// than a second that end as planned, once the machine's own factor is known (cost_records.hpp).
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the processor time [s] of all processes of the run. Nothing is known of an external
// program: it is given its time limit or, without one, an hour, so that it starts early.
double modelled_time(const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh
