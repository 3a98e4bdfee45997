// A check of the code that is timed: the pair sums of every instruction set are compared with the
// sums over all pairs (tests/all_pairs_oracle.hpp) on a small disordered liquid.
#pragma once

namespace slosh::sph {

// Throws std::runtime_error with the scheme, the instruction set and the difference where a sum is
// wrong.
void check_pair_sums();

}  // namespace slosh::sph
