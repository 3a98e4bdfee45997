// The ratio by which neighbouring cells of a graded side differ.
#pragma once

namespace slosh::openfoam {

// Returns the ratio from 1 to `largest` at which length_at(ratio), which grows with it, is
// `length`, by bisection; one of these two where no ratio between them gives that length.
template <class LengthAt>
double growth_ratio(const LengthAt& length_at, double length, double largest) {
  double low = 1, high = largest;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (length_at(middle) < length ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace slosh::openfoam
