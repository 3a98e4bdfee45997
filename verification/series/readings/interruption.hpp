// Whether the curve through a stretch of samples is interrupted there. Four descriptions of the
// samples before, inside and after it, by least squares, are compared by the sums of squares that
// they leave:
//   whole:        one polynomial through all
//   interrupted:  one polynomial through those before and after, a line or one value inside
//   once:         two polynomials that part at the begin or the end of the stretch
//   lines:        a straight line before, inside and after
// A lost echo and a cut crest are interrupted. A smooth crest is whole, a bore breaks once, and a
// plateau between ramps is made of lines.
#pragma once

#include <cstddef>
#include <vector>

namespace slosh {

struct Misfits {
  double whole = 0, interrupted = 0, once = 0, lines = 0;  // in the unit squared
  void add(const Misfits& other);
};

// Polynomials that are orthonormal over some of the places.
class Polynomials {
 public:
  Polynomials() = default;
  // Of as many degrees as the places that are chosen allow.
  Polynomials(const std::vector<double>& places, std::vector<std::size_t> chosen,
              std::size_t degree);

  // The sum of squares that they leave of the chosen values.
  double misfit(const double* values) const;
  // The weights of all values in the mean, over other places, of the polynomial nearest to the
  // chosen values.
  std::vector<double> mean_over(const std::vector<std::size_t>& others) const;

 private:
  std::vector<std::size_t> chosen_;
  std::vector<std::vector<double>> at_;  // of each degree, at all places
};

// A window of samples, of which `sides` lie before and after the stretch, and `guard` between them
// and it, which nothing is asked of. Requires more samples on both sides than the polynomial
// through them has coefficients.
class Interruption {
 public:
  struct Degrees {
    std::size_t whole, outside, inside;
  };

  Interruption(const std::vector<double>& places, std::size_t sides, std::size_t guard,
               Degrees degrees);

  std::size_t size() const { return departure_.size(); }
  // How many samples are asked, less the numbers of the interrupted description.
  double freedom() const { return freedom_; }
  // By which the mean inside leaves the polynomial through the samples outside.
  double departure(const double* values) const;
  // Whether this polynomial leaves the range of these samples by more than half of it.
  bool overshoots(const double* values) const;
  double whole(const double* values) const { return whole_.misfit(values); }
  double interrupted(const double* values) const;
  double once(const double* values) const;
  double lines(const double* values) const;
  Misfits misfits(const double* values) const;

 private:
  std::size_t sides_;
  double freedom_;
  Polynomials whole_, outside_, inside_;
  Polynomials before_, from_begin_, until_end_, after_, line_before_, line_after_;
  std::vector<double> predicted_, departure_;  // the weights of the values
};

}  // namespace slosh
