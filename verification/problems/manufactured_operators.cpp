// Problem: the pair sums of the momentum and the continuity equation on manufactured fields, which
// the mirror particles of free-slip walls continue (operator_errors.hpp has the fields). Source:
// Quinlan, Basa & Lastiwka 2006, Int. J. Numer. Meth. Eng. 66:2064; Monaghan 2005, Rep. Prog. Phys.
// 68:1703. The errors, with k the fields' wave number:
//   lattice     The smoothing error is (k h)^2 times half the kernel's second moment. The error
//               of the quadrature depends on h / dp alone: it is constant where that ratio is
//               constant, and of second order in h where the ratio grows.
//   scattered   sum_b V_b grad W_ab is no longer zero. An operator with the sum p_a + p_b or with a
//               second derivative has an error of disorder / (k h), of order -1 at constant h / dp;
//               one with the difference v_a - v_b has a constant relative error, of order 0. At
//               constant h both vanish as (dp / h)^2, because independent displacements average
//               out.
#include <cmath>

#include "verification/problems/operator_errors.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

using Errors = double OperatorErrors::*;

struct Series {
  const char* name;
  Errors errors;
  const char* meaning;
};

constexpr const char* rms = "rms error over the rms of the exact values: ";

constexpr Series growing[] = {
    {"gradient", &OperatorErrors::gradient, "pressure gradient"},
    {"divergence", &OperatorErrors::divergence, "velocity divergence"},
    {"viscosity", &OperatorErrors::viscosity,
     "viscous force, against the share of the viscosity that r^2 / (r^2 + 0.01 h^2) leaves"},
    {"diffusion", &OperatorErrors::diffusion, "density diffusion"}};

std::vector<MeasureKind> kinds() {
  std::vector<MeasureKind> all;
  const auto add = [&](const std::string& name, const char* step, const std::string& meaning) {
    all.push_back({name, "1", step, rms + meaning});
  };
  for (const Series& one : growing)
    add(one.name, "h / L", std::string(one.meaning) + "; lattice, h / dp growing");
  add("gradient_beyond_smoothing", "h / L",
      "pressure gradient, against the exact one times the kernel's transform: the quadrature error "
      "alone; lattice, h / dp growing");
  add("gradient_symmetric_pressure", "h / L",
      "the pressure gradient of p_a/rho_a^2 + p_b/rho_b^2; lattice, h / dp growing");
  for (const char* kernel : {"kaiser_bessel", "quintic_spline", "wendland_c2"})
    add(std::string("gradient_floor_") + kernel, "dp / L",
        "pressure gradient, against the exact one times the kernel's transform; lattice, h / dp = "
        "1.5");
  for (const Series& one : growing)
    add(std::string(one.name) + "_scattered", "dp / L",
        std::string(one.meaning) + "; particles off the lattice by up to 0.1 dp, h / dp = 1.5");
  add("gradient_scattered_filled", "dp / h", "pressure gradient; the same with h = 3 L / 64 kept");
  return all;
}

// h / dp grows as the square root of the number of cells.
Resolution growing_ratio(int cells) { return {cells, 3 * std::sqrt(cells / 32.0), 0}; }
Resolution kept_ratio(int cells, double disorder) { return {cells, 1.5, disorder}; }
Resolution kept_smoothing(int cells) { return {cells, 1.5 * cells / 32.0, 0.1}; }

ProblemOutcome run(bool quick) {
  const std::vector<int> cells =
      quick ? std::vector<int>{32, 64, 128} : std::vector<int>{32, 64, 128, 256};
  std::vector<MeasuredErrors> measures;
  for (const MeasureKind& kind : kinds()) measures.push_back({kind.name, {}});
  for (const int n : cells) {
    std::size_t next = 0;
    const auto add = [&](double step, double error) {
      measures[next++].errors.push_back({step, error});
    };
    const Resolution grown = growing_ratio(n);
    const double h = grown.smoothing_length(), dp = grown.spacing();
    const OperatorErrors lattice = operator_errors<sph::Recommended>(grown);
    for (const Series& one : growing) add(h, lattice.*one.errors);
    add(h, lattice.gradient_beyond_smoothing);
    add(h, operator_errors<sph::WithSymmetricPressure>(grown).gradient);
    const Resolution kept = kept_ratio(n, 0);
    add(dp, operator_errors<sph::Recommended>(kept).gradient_beyond_smoothing);
    add(dp, operator_errors<sph::WithQuinticSpline>(kept).gradient_beyond_smoothing);
    add(dp, operator_errors<sph::WithWendlandC2>(kept).gradient_beyond_smoothing);
    const OperatorErrors scattered = operator_errors<sph::Recommended>(kept_ratio(n, 0.1));
    for (const Series& one : growing) add(dp, scattered.*one.errors);
    const Resolution filled = kept_smoothing(n);
    add(1 / filled.ratio, operator_errors<sph::Recommended>(filled).gradient);
  }
  return {std::move(measures), {}};
}

}  // namespace

Problem manufactured_operators_problem() {
  return {
      "manufactured_operators",
      "Manufactured fields: the order of the pair sums",
      "Pressure gradient, velocity divergence, viscous force and density diffusion of "
      "`recommended` (Kaiser-Bessel kernel) on p = P cos kx cos kz, v = (sin kx cos kz, cos kx sin "
      "kz), v = (sin kx cos kz, -cos kx sin kz), k = pi / L, in a full box whose mirror "
      "particles continue the fields; on the lattice and on scattered particles.",
      "Quinlan, Basa & Lastiwka 2006, Int. J. Numer. Meth. Eng. 66:2064; Monaghan 2005, Rep. "
      "Prog. Phys. 68:1703",
      "-grad p / rho, -rho div v, nu lap v and delta h c0 lap(p / c0^2). On the lattice the "
      "error is the kernel's smoothing, of second order in h, and a quadrature error of h / dp "
      "alone, a floor where that ratio is kept. On scattered particles with h / dp kept the "
      "sums of p_a + p_b and of second derivatives have the order -1, those of v_a - v_b "
      "the order 0: these operators are not corrected, and do not converge there unless h / dp "
      "grows.",
      kinds(),
      &run,
      8};
}

}  // namespace slosh
