// Problems: a circular drop of radius R under a central force -Omega^2 r without surface tension: a
// free surface without walls. The force is a scheme's frame, so that the schemes of tanks need not
// know it; c0 = 20 Omega R.
//
// rigid_rotation    The drop turns as a rigid body.
//   omega = Omega       The force keeps every particle on its circle and p = 0: the pair sums must
//                       add nothing, and the path shows the integrator's order in the time step.
//   omega = Omega / 2   The pressure p = rho / 2 (Omega^2 - omega^2) (R^2 - r^2) balances the
//                       rest of the force; a viscous stress that is not symmetric would slow the
//                       rotation.
//   The forces of a pair act along the line between its particles, so that the angular momentum is
//   conserved to round-off. Source: Monaghan 2005, Rep. Prog. Phys. 68:1703 (conservation).
// oscillating_drop  The drop starts with the velocity Omega (x, -z) and the pressure
//   p = rho / 2 (A0^2 + Omega^2) (R^2 - r^2), A0 = Omega. drop_motion.hpp has its exact semi-axes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sph/compiled_terms.hpp"
#include "sph/schemes.hpp"
#include "verification/problems/drop_motion.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

constexpr double angular_frequency = 1;  // Omega [rad/s]

struct CentralFrame {
  static constexpr const char* name = "central force -Omega^2 r about the middle of the box";
  static constexpr bool takes_roll = false, walls_roll = false, is_tanks = false;

  static sph::Tank tank(const sph::Scene& scene, double) {
    return {sph::TankWalls{0, scene.tank_length, 0, scene.tank_height, 0, 0},
            sph::InertialForces{.axis_x = 0.5 * scene.tank_length,
                                .axis_z = 0.5 * scene.tank_height,
                                .attraction = angular_frequency * angular_frequency}};
  }
};

// The terms of `recommended` for a liquid that touches nothing.
struct FreeDrop : sph::Recommended {
  using Frame = CentralFrame;
  using Mirror = sph::NoMirror;
  using Solids = sph::NoSolids;
};

// A box whose middle is the drop's, of 2 `middle` along each side [R].
Box box_of(int cells, double middle) {
  return {.length = 2 * middle, .height = 2 * middle, .spacing = 1.0 / cells, .speed_of_sound = 20};
}

// Returns the drop with a velocity at the place from its middle, and the given pressure there [Pa].
template <class VelocityAt>
sph::Particles drop(const Box& box, double pressure, const VelocityAt& velocity_at) {
  const double middle = 0.5 * box.length;
  const sph::Scheme<FreeDrop> scheme = scheme_of<FreeDrop>(box);
  sph::Particles p =
      lattice(box, [=](double x, double z) { return std::hypot(x - middle, z - middle) < 1; });
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - middle, z = p.z[i] - middle;
    const sph::Vector2 velocity = velocity_at(x, z);
    p.velocity_x[i] = velocity.x;
    p.velocity_z[i] = velocity.z;
    set_pressure(scheme, p, i, pressure * (1 - x * x - z * z));
  }
  return p;
}

constexpr double turning_middle = 2;

sph::Particles turning(const Box& box, double omega) {
  const double left = angular_frequency * angular_frequency - omega * omega;
  return drop(box, 0.5 * box.rest_density * left, [=](double x, double z) {
    return sph::Vector2{-omega * z, omega * x};
  });
}

double angular_momentum(const sph::Particles& p) {
  constexpr double middle = turning_middle;
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum += p.mass[i] * ((p.x[i] - middle) * p.velocity_z[i] - (p.z[i] - middle) * p.velocity_x[i]);
  return sum;
}

// Returns the largest distance of a particle from the nearest initial position, rotated by `angle`.
double distance_from_turned(const sph::Particles& p, const sph::Particles& start, double angle) {
  constexpr double middle = turning_middle;
  double farthest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < start.size(); ++j) {
      const double x = start.x[j] - middle, z = start.z[j] - middle;
      const double dx = p.x[i] - middle - (std::cos(angle) * x - std::sin(angle) * z),
                   dz = p.z[i] - middle - (std::sin(angle) * x + std::cos(angle) * z);
      nearest2 = std::min(nearest2, dx * dx + dz * dz);
    }
    farthest = std::max(farthest, nearest2);
  }
  return std::sqrt(farthest);
}

// Returns the error of the path, that of the leapfrog's first step included.
double path_error(int steps) {
  const Box box = box_of(16, turning_middle);
  const sph::Particles start = turning(box, angular_frequency);
  Flow<FreeDrop> flow(box, start);
  const double time = std::numbers::pi / 2 / angular_frequency;
  for (int i = 0; i < steps; ++i) flow.step(time / steps);
  return distance_from_turned(flow.liquid.particles, start, angular_frequency * time);
}

// Returns the errors of velocity and angular momentum.
std::pair<double, double> errors_of_half_turn(int cells) {
  constexpr double middle = turning_middle, omega = 0.5 * angular_frequency;
  const Box box = box_of(cells, middle);
  Flow<FreeDrop> flow(box, turning(box, omega));
  const sph::Particles& p = flow.liquid.particles;
  const double start = angular_momentum(p);
  flow.advance_to(std::numbers::pi / omega);
  // The leapfrog's velocities are those of half a step earlier.
  double error2 = 0, exact2 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double u = -omega * (p.z[i] - middle), w = omega * (p.x[i] - middle);
    error2 += std::pow(p.velocity_x[i] - u, 2) + std::pow(p.velocity_z[i] - w, 2);
    exact2 += u * u + w * w;
  }
  return {std::sqrt(error2 / exact2), angular_momentum(p) / start - 1};
}

ProblemOutcome run_rotation(bool quick) {
  ProblemOutcome outcome{{{"path", {}}, {"velocity", {}}, {"angular_momentum", {}}}, {}};
  for (const int steps : {400, 800, 1600})
    outcome.measures[0].errors.push_back({1.0 / steps, path_error(steps)});
  for (const int cells : quick ? std::vector<int>{16, 23, 32} : std::vector<int>{16, 23, 32, 45}) {
    const auto [velocity, momentum] = errors_of_half_turn(cells);
    outcome.measures[1].errors.push_back({1.0 / cells, velocity});
    outcome.measures[2].errors.push_back({1.0 / cells, momentum});
  }
  return outcome;
}

constexpr double oscillating_middle = 3, amplitude = 1;  // A0 / Omega

// Returns the semi-axis from the second moment, which is a^2 / 4 for a uniform ellipse.
double semi_axis(const sph::Particles& p, const sph::Array<double>& places) {
  double mass = 0, moment = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    mass += p.mass[i];
    moment += p.mass[i] * std::pow(places[i] - oscillating_middle, 2);
  }
  return 2 * std::sqrt(moment / mass);
}

struct Oscillation {
  double largest_error = 0;  // of a and b, over R
  double period = 0;
  std::vector<double> time, a, exact_a;
};

Oscillation oscillation(int cells) {
  const Box box = box_of(cells, oscillating_middle);
  Flow<FreeDrop> flow(
      box, drop(box, 0.5 * box.rest_density * (amplitude * amplitude + 1), [](double x, double z) {
        return sph::Vector2{amplitude * x, -amplitude * z};
      }));
  const sph::Particles& p = flow.liquid.particles;
  const double start_a = semi_axis(p, p.x);  // of a circle made of squares
  Oscillation result;
  SemiAxes exact{1, 1, amplitude};
  const double interval = 0.05, end = drop_period(amplitude) + 0.5;
  double before = 1;
  for (double t = 0; t < end; t += interval) {
    flow.advance_to(t);
    const double a = semi_axis(p, p.x) / start_a, b = semi_axis(p, p.z) / start_a;
    result.largest_error =
        std::max({result.largest_error, std::abs(a - exact.a), std::abs(b - exact.b)});
    if (before < 1 && a >= 1 && result.period == 0)
      result.period = t - interval * (a - 1) / (a - before);
    before = a;
    result.time.push_back(t);
    result.a.push_back(a);
    result.exact_a.push_back(exact.a);
    exact = advanced(exact, interval);
  }
  return result;
}

ProblemOutcome run_oscillation(bool quick) {
  ProblemOutcome outcome{{{"semi_axes", {}}, {"period", {}}}, {}};
  reports::Figure figure;
  figure.id = "oscillating_drop-axis";
  figure.title = "Oscillating drop: semi-axis along the first stretch";
  figure.caption = "From the second moment of the particles.";
  figure.x_label = "t Omega";
  figure.y_label = "a / R";

  const std::vector<int> ladder =
      quick ? std::vector<int>{20, 28, 40} : std::vector<int>{20, 28, 40, 56, 80};
  const double period = drop_period(amplitude);
  for (const int cells : ladder) {
    Oscillation found = oscillation(cells);
    outcome.measures[0].errors.push_back({1.0 / cells, found.largest_error});
    outcome.measures[1].errors.push_back({1.0 / cells, found.period / period - 1});
    if (cells != ladder.back()) continue;
    figure.curves.push_back(
        {"exact", found.time, std::move(found.exact_a), {}, reports::Curve::Style::dashed});
    figure.curves.push_back({"recommended", std::move(found.time), std::move(found.a), {}});
  }
  outcome.figures.push_back(std::move(figure));
  return outcome;
}

SemiAxes rate(const SemiAxes& s) {
  const double a2 = s.a * s.a, b2 = s.b * s.b;
  return {s.sigma * s.a, -s.sigma * s.b, (s.sigma * s.sigma + 1) * (b2 - a2) / (a2 + b2)};
}

SemiAxes moved(const SemiAxes& from, double dt, const SemiAxes& rate) {
  return {from.a + dt * rate.a, from.b + dt * rate.b, from.sigma + dt * rate.sigma};
}

SemiAxes step(const SemiAxes& s, double dt) {
  const SemiAxes k1 = rate(s), k2 = rate(moved(s, dt / 2, k1)), k3 = rate(moved(s, dt / 2, k2)),
                 k4 = rate(moved(s, dt, k3));
  return moved(s, dt / 6,
               {k1.a + 2 * k2.a + 2 * k3.a + k4.a, k1.b + 2 * k2.b + 2 * k3.b + k4.b,
                k1.sigma + 2 * k2.sigma + 2 * k3.sigma + k4.sigma});
}

constexpr double longest_step = 0.002;

}  // namespace

SemiAxes advanced(SemiAxes from, double time) {
  const double steps = std::ceil(time / longest_step);
  for (int i = 0; i < steps; ++i) from = step(from, time / steps);
  return from;
}

double drop_period(double amplitude) {
  SemiAxes now{1, 1, amplitude};
  double time = 0;
  // The axis a passes its initial value twice in a period: first decreasing, then increasing.
  for (;;) {
    const SemiAxes next = step(now, longest_step);
    if (now.a < 1 && next.a >= 1) return time + longest_step * (1 - now.a) / (next.a - now.a);
    now = next;
    time += longest_step;
  }
}

Problem rigid_rotation_problem() {
  return {"rigid_rotation",
          "Rigid rotation under a central force",
          "A circular drop turning about its middle: at omega = Omega, where the force alone holds "
          "every particle on its circle, a quarter turn; at omega = Omega / 2, where pressure "
          "bears the rest, half a turn.",
          "Monaghan 2005, Rep. Prog. Phys. 68:1703; Hairer, Lubich & Wanner 2006, "
          "Geometric Numerical Integration, section I.1.4 (leapfrog)",
          "The start's places turned by omega t, second order in the time step; v = omega x r; the "
          "angular momentum of the start, which forces along the pairs' lines keep to round-off.",
          {{"path", "1", "dt / quarter turn",
            "largest distance of a particle from its exact place, over R, at omega = Omega"},
           {"velocity", "1", "dp / R", "rms velocity error over the rms, at omega = Omega / 2"},
           {"angular_momentum", "1", "dp / R",
            "relative change of the angular momentum, at omega = Omega / 2"}},
          &run_rotation,
          10};
}

Problem oscillating_drop_problem() {
  return {"oscillating_drop",
          "Oscillating drop under a central force",
          "A circle of liquid without walls, pulled to its middle by -Omega^2 r and set off with "
          "the velocity Omega (x, -z), over one period and a little: `recommended` without its "
          "walls.",
          "Monaghan & Rafiee 2013, Int. J. Numer. Meth. Fluids 71:537",
          "The drop stays an ellipse: a' = sigma a, b' = -sigma b, sigma' = (sigma^2 + Omega^2) "
          "(b^2 - a^2) / (a^2 + b^2); a spans 0.5176 to 1.9319 R, the period is 4.8273 / Omega. "
          "Axes from the particles' second moments, a / R = 2 sqrt(<x^2>) over that of the start.",
          {{"semi_axes", "1", "dp / R", "largest error of a and b, over R"},
           {"period", "1", "dp / R", "period error"}},
          &run_oscillation,
          55};
}

}  // namespace slosh
