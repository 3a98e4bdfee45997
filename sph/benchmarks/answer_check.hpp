// What is timed must be right: the pair sums of every instruction set against the sums over all
// pairs (tests/all_pairs_oracle.hpp) on a small disordered liquid.
#pragma once

namespace slosh::sph {

// Throws std::runtime_error naming the scheme, the instruction set and the difference.
void check_pair_sums();

}  // namespace slosh::sph
