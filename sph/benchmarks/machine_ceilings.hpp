// The machine's peak performance, measured on one core: the upper limit of the pair loops' speed.
#pragma once

#include <cstddef>

#include "sph/neighbours/instruction_sets.hpp"

namespace slosh::sph {

// Returns the rate of floating-point operations [1/s] in independent fused multiply-adds of double
// precision, which count as two operations each.
double peak_flops(InstructionSet set);

// Returns the bandwidth of repeatedly summing an array of that many bytes [byte/s].
double read_bandwidth(std::size_t bytes, InstructionSet set);

}  // namespace slosh::sph
