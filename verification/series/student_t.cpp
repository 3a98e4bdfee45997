#include "verification/series/student_t.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace slosh {

using boost::math::students_t;

double t95(double freedom) { return boost::math::quantile(students_t(freedom), 0.975); }

double two_sided_p(double t, double freedom) {
  return 2 * boost::math::cdf(boost::math::complement(students_t(freedom), std::abs(t)));
}

}  // namespace slosh
