// Smoothing kernels in two dimensions: W(r, h), with q = r / h and support radius 2 h. Only this
// file relates the smoothing length h to the support.
//
// A kernel has two functions of q without the dimensional factor; both are zero (without a branch)
// for q >= 2:
//   shape(q)           W      = normalisation / h^2 * shape(q)
//   gradient_shape(q)  (dW/dr) / r = normalisation / h^4 * gradient_shape(q), finite at q = 0
// A kernel that is a function of q^2 also has shape_of_distance2(r^2, 1/h^2), which spares the sums
// a square root, and so does gradient_shape_of_distance2(r^2, 1/h^2), as where the gradient divides
// by q.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "sph/neighbours/lanes.hpp"

namespace slosh::sph {

inline constexpr double kernel_support = 2.0;  // in smoothing lengths

// Cubic B-spline (Monaghan & Lattanzio 1985; Li et al. 2010, eq. 2).
struct CubicSpline {
  static constexpr const char* name = "cubic B-spline kernel";
  static constexpr double normalisation = 10.0 / (7.0 * std::numbers::pi);

  template <class Number>
  static Number shape(Number q) {
    const Number outer = at_least(0.0, 2.0 - q), inner = at_least(0.0, 1.0 - q);
    return 0.25 * outer * outer * outer - inner * inner * inner;
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    return gradient_shape_of_distance2(q * q, 1.0);
  }
  template <class Number, class Length>
  static Number gradient_shape_of_distance2(Number distance2, Length inverse_h2) {
    // The numerator vanishes at q = 0; the bound only avoids 0/0.
    const Number q2 = at_least(1e-18, distance2 * inverse_h2), inverse_q = inverse_square_root(q2),
                 q = q2 * inverse_q;
    const Number outer = at_least(0.0, 2.0 - q), inner = at_least(0.0, 1.0 - q);
    return (3.0 * inner * inner - 0.75 * outer * outer) * inverse_q;
  }
};

// Wendland C2 (Wendland 1995; Zhao et al. 2021, eq. 3, whose constant is 7 / (4 pi h^2)).
struct WendlandC2 {
  static constexpr const char* name = "Wendland C2 kernel";
  static constexpr double normalisation = 7.0 / (4.0 * std::numbers::pi);

  template <class Number>
  static Number shape(Number q) {
    const Number s = at_least(0.0, 1.0 - 0.5 * q);
    return s * s * s * s * (2.0 * q + 1.0);
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    // The factor 5 is inside the cube, which saves one multiplication per pair.
    constexpr double root = 1.709975946676697;  // 5^(1/3)
    const Number s = at_least(0.0, root - 0.5 * root * q);
    return -(s * s * s);
  }
};

// Wendland C4 (Wendland 1995; Dehnen & Aly 2012, table 1).
struct WendlandC4 {
  static constexpr const char* name = "Wendland C4 kernel";
  static constexpr double normalisation = 9.0 / (4.0 * std::numbers::pi);

  template <class Number>
  static Number shape(Number q) {
    const Number u = 0.5 * q, s = at_least(0.0, 1.0 - u), s2 = s * s;
    return s2 * s2 * s2 * (1.0 + 6.0 * u + 35.0 / 3.0 * u * u);
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    const Number u = 0.5 * q, s = at_least(0.0, 1.0 - u), s2 = s * s;
    return -14.0 / 3.0 * s2 * s2 * s * (1.0 + 5.0 * u);
  }
};

// Wendland C6 (Wendland 1995; Dehnen & Aly 2012, table 1).
struct WendlandC6 {
  static constexpr const char* name = "Wendland C6 kernel";
  static constexpr double normalisation = 39.0 / (14.0 * std::numbers::pi);

  template <class Number>
  static Number shape(Number q) {
    const Number u = 0.5 * q, s = at_least(0.0, 1.0 - u), s2 = s * s, s4 = s2 * s2;
    return s4 * s4 * (1.0 + u * (8.0 + u * (25.0 + 32.0 * u)));
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    const Number u = 0.5 * q, s = at_least(0.0, 1.0 - u), s2 = s * s, s4 = s2 * s2;
    return -5.5 * s4 * s2 * s * (1.0 + u * (7.0 + 16.0 * u));
  }
};

// Quintic B-spline (Morris, Fox & Zhu 1997, eq. 24), its three knot spans stretched over the
// support 2 h: with s = 3 q / 2, W ~ (3 - s)^5 - 6 (2 - s)^5 + 15 (1 - s)^5.
struct QuinticSpline {
  static constexpr const char* name = "quintic B-spline kernel";
  static constexpr double normalisation = 7.0 / (478.0 * std::numbers::pi) * 2.25;

  template <class Number>
  static Number shape(Number q) {
    const Number s = 1.5 * q;
    return fifth(3.0 - s) - 6.0 * fifth(2.0 - s) + 15.0 * fifth(1.0 - s);
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    return gradient_shape_of_distance2(q * q, 1.0);
  }
  template <class Number, class Length>
  static Number gradient_shape_of_distance2(Number distance2, Length inverse_h2) {
    // The numerator vanishes at q = 0; the bound only avoids 0/0.
    const Number q2 = at_least(1e-60, distance2 * inverse_h2), inverse_q = inverse_square_root(q2),
                 s = 1.5 * (q2 * inverse_q);
    return -7.5 * (fourth(3.0 - s) - 6.0 * fourth(2.0 - s) + 15.0 * fourth(1.0 - s)) * inverse_q;
  }

 private:
  // Powers of the positive part of a.
  template <class Number>
  static Number fourth(Number a) {
    const Number positive = at_least(0.0, a), square = positive * positive;
    return square * square;
  }
  template <class Number>
  static Number fifth(Number a) {
    return fourth(a) * at_least(0.0, a);
  }
};

// The Kaiser-Bessel kernel of two dimensions, W ~ I0(18 sqrt(s)) - 1 with s = 1 - (q / 2)^2, after
// the window of Kaiser & Schafer 1980 (IEEE Trans. Acoust. Speech Signal Process. 28:105). Of all
// functions with this support it nearly has the least Fourier transform beyond the wave number
// 18 / (2 h), where it has fallen to 18 / (2 I1(18)) = 1.5e-6 of its integral. At h = 1.5 dp that
// wave number, 6 / dp, lies below the first one of the square lattice, 2 pi / dp, and of the
// hexagonal one, 6.75 / dp. Sums over either lattice are then nearly integrals: the lattice hardly
// buckles under its pressure and hardly resists a small shear
// (verification/problems/stability/lattice_buckling.hpp). The splines and Wendland's kernels of
// this support have far larger transforms there.
//
// The shape is a polynomial in s, W(0) = 1, which was fitted to 9e-8 of W(0); its slope differs by
// 1.5e-6 of the largest. It vanishes with its slope at s = 0; its second derivative jumps there by
// 4e-4 of its value at the centre.
struct KaiserBessel {
  static constexpr const char* name = "Kaiser-Bessel kernel";
  static constexpr double normalisation = 0.7369713067952;  // 1 / (4 pi sum of c_n / (n + 3))

  template <class Number>
  static Number shape(Number q) {
    return shape_of_distance2(q * q, 1.0);
  }
  template <class Number, class Length>
  static Number shape_of_distance2(Number distance2, Length inverse_h2) {
    const Number s = at_least(0.0, 1.0 - (0.25 * inverse_h2) * distance2);
    return s * s * polynomial(coefficients, s);
  }
  template <class Number>
  static Number gradient_shape(Number q) {
    return gradient_shape_of_distance2(q * q, 1.0);
  }
  template <class Number, class Length>
  static Number gradient_shape_of_distance2(Number distance2, Length inverse_h2) {
    const Number s = at_least(0.0, 1.0 - (0.25 * inverse_h2) * distance2);
    return s * polynomial(slopes, s);
  }

 private:
  static constexpr std::array coefficients{// c_n of s^(n + 2)
                                           0.0008964933569799, -0.009325195122118, 0.1259694741477,
                                           -0.631169874688,    2.642027651018,     -6.408246904831,
                                           11.66477586143,     -13.47245650114,    10.82081075967,
                                           -4.955207163533,    1.22192539969};
  static constexpr std::size_t degree = coefficients.size() - 1;
  template <class Number>
  static Number polynomial(const std::array<double, degree + 1>& of, Number s) {  // by Horner
    Number sum = Number{} + of[degree];
    for (std::size_t n = degree; n-- > 0;) sum = sum * s + of[n];
    return sum;
  }
  static constexpr auto slopes = [] {  // of s^(n + 1) in the gradient's shape
    auto slope = coefficients;
    for (std::size_t n = 0; n <= degree; ++n) slope[n] *= -0.5 * (n + 2);
    return slope;
  }();
};

// A kernel outside the sums, where no code is compiled for each.
struct KernelFunction {
  double normalisation;
  double (*shape)(double q);
};
template <class Kernel>
constexpr KernelFunction function_of() {
  return {Kernel::normalisation, &Kernel::template shape<double>};
}

// Both return a function of a pair at this distance, squared [m2]; `inverse_h` is 1/h [1/m].
template <class Kernel, class Number, class Length>
Number shape_of_pair(Number distance2, Length inverse_h) {
  if constexpr (requires { Kernel::shape_of_distance2(distance2, inverse_h); })
    return Kernel::shape_of_distance2(distance2, inverse_h * inverse_h);
  else
    return Kernel::shape(square_root(distance2) * inverse_h);
}
template <class Kernel, class Number, class Length>
Number gradient_shape_of_pair(Number distance2, Length inverse_h) {
  if constexpr (requires { Kernel::gradient_shape_of_distance2(distance2, inverse_h * inverse_h); })
    return Kernel::gradient_shape_of_distance2(distance2, inverse_h * inverse_h);
  else
    return Kernel::gradient_shape(square_root(distance2) * inverse_h);
}

}  // namespace slosh::sph
