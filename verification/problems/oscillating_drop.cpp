// Problem: a circular drop of radius R under a central force -Omega^2 r without surface tension,
// which starts with the velocity Omega (x, -z): a free surface without walls. drop_motion.hpp has
// the exact semi-axes. At the start
//   p = rho / 2 (A0^2 + Omega^2) (R^2 - r^2),  A0 = Omega.
// c0 = 20 Omega R, 20 times the largest speed at the start.
#include <algorithm>
#include <cmath>

#include "verification/problems/central_force.hpp"
#include "verification/problems/drop_motion.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

constexpr double middle = 3, amplitude = 1;  // of a box of 6 R; A0 / Omega

template <class Choice>
sph::Particles start(const Box& box) {
  const sph::Scheme<Choice> scheme = scheme_of<Choice>(box);
  sph::Particles p =
      lattice(box, [](double x, double z) { return std::hypot(x - middle, z - middle) < 1; });
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - middle, z = p.z[i] - middle;
    p.velocity_x[i] = amplitude * x;
    p.velocity_z[i] = -amplitude * z;
    set_pressure(scheme, p, i,
                 0.5 * box.rest_density * (amplitude * amplitude + 1) * (1 - x * x - z * z));
  }
  return p;
}

// Returns the semi-axis from the second moment, which is a^2 / 4 for a uniform ellipse.
double semi_axis(const sph::Particles& p, const sph::Array<double>& places) {
  double mass = 0, moment = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    mass += p.mass[i];
    moment += p.mass[i] * std::pow(places[i] - middle, 2);
  }
  return 2 * std::sqrt(moment / mass);
}

struct Oscillation {
  double largest_error = 0;  // of a and b, over R
  double period = 0;
  std::vector<double> time, a, exact_a;
};

template <class Choice>
Oscillation oscillation(int cells) {
  const Box box{
      .length = 2 * middle, .height = 2 * middle, .spacing = 1.0 / cells, .speed_of_sound = 20};
  Flow<Choice> flow(box, start<Choice>(box));
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

ProblemOutcome run(bool quick) {
  ProblemOutcome outcome{{{"semi_axes", {}}, {"period", {}}}, {}};
  reports::Figure figure;
  figure.id = "oscillating_drop-axis";
  figure.title =
      "Oscillating drop: semi-axis along the first "
      "stretch";
  figure.caption = "From the second moment of the particles.";
  figure.x_label = "t Omega";
  figure.y_label = "a / R";

  const std::vector<int> ladder =
      quick ? std::vector<int>{20, 28, 40} : std::vector<int>{20, 28, 40, 56, 80};
  const double period = drop_period(amplitude);
  for (const int cells : ladder) {
    Oscillation found = oscillation<FreeDrop<sph::Recommended>>(cells);
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

}  // namespace

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
          &run,
          55};
}

}  // namespace slosh
