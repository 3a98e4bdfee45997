// What linear theory leaves out of the waves in a rectangular tank, to third order in their
// steepness. With eta the elevation, psi the potential on the surface in the tank's frame, D =
// d/dx and G0 = k tanh kh on each cosine mode (Craig & Sulem 1993, J. Comput. Phys. 108:73),
//   eta_t = G psi,   G = G0 + G1 + G2,   G1 = -D eta D - G0 eta G0,
//   G2 = (D D eta^2 G0 + G0 eta^2 D D) / 2 + G0 eta G0 eta G0
//   psi_t = -g eta - x X'' - (D psi)^2 / 2 + (G0 psi)^2 / 2
//           + G0 psi (G1 psi + D eta D psi)
// The same modes are integrated without the products, and the difference of the two is returned.
// Near-resonances of the second order, such as the sum of the forcing's and the first natural
// frequency with that of the second mode, are thus in it, and how frequencies fall or rise with the
// amplitude. Under the surface the potential is that of its values at z = 0, to third order
//   phi0 = psi - eta G0 psi + eta G0 eta G0 psi + eta^2 D D psi / 2,
//   phi = sum of phi0_n cos(...) cosh k (z + h) / cosh kh,
//   p = -rho (phi_t + (grad phi)^2 / 2 + g z + x X''),
// and phi0_t its derivative along the solution. The force on the tank is that which the centre of
// mass needs, F = -(M X'' + rho d2/dt2 of the integral of x eta dx), and the moment that of the
// pressures on the walls. Valid for k A below about 0.2; it is an estimate of an error, and no
// reference. Against fully nonlinear potential flow the elevation is right to 3 % of itself in
// surges with k A = 0.16 (third_order_waves_test.cpp).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "reference/standing_wave.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

struct ThirdOrderWaves {
  Tank tank;
  std::function<double(double)> acceleration = {};  // X'' [m/s2]; empty for a tank at rest
  // Of the tank in a liquid at rest in the earth's frame [m/s] and [1/s].
  double initial_velocity = 0, initial_spin = 0;
  InitialWave initial_wave = {1, 0};
  double kinematic_viscosity = 0;  // [m2/s]: each mode decays at the rate 2 nu k^2
  // A roll: theta' and theta'' [1/s, 1/s2], the axis from the centre of the still surface [m], and
  // g (1 - cos theta) [m/s2]. The liquid then also has theta' times Stokes' and Joukowski's
  // potential, which in the tank is the flow theta' (grad K - (0, 2 x)),
  //   K = sum of 2 x_n / k cos(...) sinh k (z + h / 2) / cosh(kh / 2),   x = sum of x_n cos(...),
  // and `acceleration` holds g theta + axis_z theta''.
  struct Turn {
    double spin, spin_rate, axis_x, axis_z, tilt;
  };
  std::function<Turn(double)> turn = {};
  bool linear_alone = false;  // leaves what is beyond at zero, for a fraction of the time
};

// The waves at the requested times. Places are measured from the CENTRE of the still surface, x
// along it and z up [m]; those below the bottom count as on it. All but linear_elevation() is what
// the third order adds to the linear theory of the same modes. It is not finite where the waves
// outgrow the expansion. Of an initial wave of a mode above 16 nothing is finite. Functions throw
// std::invalid_argument for a place outside the walls.
class ThirdOrderRecord {
 public:
  std::vector<double> linear_elevation(double x) const;  // [m]
  std::vector<double> elevation(double x) const;         // [m]
  // Where the surface is below the place, the velocity and the pressure are 0, and linear theory
  // has its own.
  std::vector<double> velocity_x(double x, double z) const;  // in the tank [m/s]
  std::vector<double> velocity_z(double x, double z) const;
  std::vector<double> pressure(double x, double z) const;  // [Pa]
  std::vector<double> force_x() const;                     // on the tank [N/m]
  // Of the pressures on the walls about a place, counter-clockwise [N].
  std::vector<double> moment(double x, double z) const;

 private:
  friend ThirdOrderRecord third_order_waves(const ThirdOrderWaves& waves,
                                            const std::vector<double>& times);

  // [mode][time]; `potential` and `rate` are phi0 and phi0_t, whose row 0 is their mean.
  struct Modes {
    Eigen::MatrixXd elevation, potential, rate;
  };
  struct Below;
  Eigen::RowVectorXd shape_at(double x) const;          // of the modes on the still surface
  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;  // of all times
  Below below(double x, double z) const;
  Row wet(double x, double z) const;
  std::vector<double> velocity(const Eigen::RowVectorXd& shape, double of_turn,
                               const Row& wet) const;
  Row pressure_at(double x, double z, const Row& wet) const;

  Tank tank_;
  Row acceleration_, force_;
  std::vector<ThirdOrderWaves::Turn> turn_;
  Modes linear_, all_;
};

// Integrates to rising times from 0 s on. Throws std::invalid_argument for an impossible tank.
ThirdOrderRecord third_order_waves(const ThirdOrderWaves& waves, const std::vector<double>& times);

}  // namespace slosh::reference
