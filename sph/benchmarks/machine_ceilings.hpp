// What this machine can do at most, measured on one core now: the roof over the pair loops.
#pragma once

#include <cstddef>

#include "sph/neighbours/instruction_sets.hpp"

namespace slosh::sph {

// Double-precision fused multiply-adds that do not wait for one another, two operations each [1/s].
double peak_flops(InstructionSet set);

// Of summing an array of that many bytes again and again [byte/s].
double read_bandwidth(std::size_t bytes, InstructionSet set);

}  // namespace slosh::sph
