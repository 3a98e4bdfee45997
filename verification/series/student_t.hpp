// Student's t distribution. Boost's is compiled in one file, as its headers take longer than most
// of the files that used it.
#pragma once

namespace slosh {

// The half width of the two-sided 95 % interval of a mean, in its standard errors. `freedom` > 0.
double t95(double freedom);

// The probability that |t| is exceeded. `freedom` > 0.
double two_sided_p(double t, double freedom);

}  // namespace slosh
