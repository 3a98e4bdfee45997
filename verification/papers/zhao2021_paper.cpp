// The section on Zhao et al. 2021: its claims and its errata.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/linear_surge.hpp"
#include "verification/case/motion.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/paper_claims.hpp"
#include "verification/papers/paper_sections.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// The violently rolling tank: SPHERIC benchmark 10, water.
const reference::Tank rolling_tank{0.9, 0.093, 9.81, 998};
constexpr double printed_natural = 1.919, printed_forcing = 1.631;  // the paper gives rad/s
constexpr double printed_probe = 0.0093, probe = 0.093;             // [m] above the bottom

// Integral of (1 - q/2)^4 (1 + 2q) over the plane, q = r / h <= 2, by Simpson's rule.
double kernel_integral() {
  constexpr int intervals = 1000;
  constexpr double step = 2.0 / intervals;
  const auto ring = [](double q) { return 2 * pi * q * std::pow(1 - 0.5 * q, 4) * (1 + 2 * q); };
  double sum = ring(0) + ring(2);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 ? 4 : 2) * ring(i * step);
  return sum * step / 3;
}

// Compares the measured roll of one case with the sine of the other.
std::string roll_beside_sine(const std::vector<CaseAssessment>& cases) try {
  const CaseDefinition& measured = case_named(cases, paper_cases::violent).definition;
  const CaseDefinition& literal = case_named(cases, "zhao2021_violent_sine").definition;
  const auto roll = roll_motion(measured), sine = roll_motion(literal);
  if (!roll || !sine) throw std::runtime_error("a case does not roll");
  constexpr double sampling = 0.01;
  double largest = 0, at = 0, sum = 0;
  int count = 0;
  for (; count * sampling <= std::min(measured.duration, literal.duration); ++count) {
    const double t = count * sampling;
    const double apart = 180 / pi * (roll->angle(t) - sine->angle(t));
    if (std::abs(apart) > std::abs(largest)) largest = apart, at = t;
    sum += apart * apart;
  }
  return fmt::format(
      "it starts at {:.1f} deg/s, the sine at {:.1f}; apart by up to {:.2f} deg (at {:.2f} s), rms "
      "{:.2f} deg",
      180 / pi * roll->rate(0), 180 / pi * sine->rate(0), std::abs(largest), at,
      std::sqrt(sum / count));
} catch (const std::runtime_error& error) {
  return error.what();
}

reports::Table zhao2021_errata(const std::vector<CaseAssessment>& cases,
                               const RedrawnFigures& redrawn) {
  const double omega = reference::natural_frequency(rolling_tank, 1);
  const double forcing = 2 * pi / printed_forcing;
  const auto still_pressure = [](double height) {
    return rolling_tank.density * rolling_tank.gravity * (rolling_tank.fill_depth - height);
  };
  const double integral = kernel_integral();
  return with_figures(
      {"zhao2021-errata",
       "Errata of Zhao et al. 2021",
       "Each with the numbers computed here.",
       {"the paper", "correction", "computed"},
       {}},
      {{{"omega_0 = 1.919 rad/s", "That is the first natural period in seconds.",
         fmt::format("omega_1 = {:.3f} rad/s, period {:.3f} s ({:+.2f} % off {})", omega,
                     2 * pi / omega, 100 * (2 * pi / omega / printed_natural - 1),
                     printed_natural)}},
       {{"omega_r = 1.631 rad/s",
         "That is the period of the roll in seconds, and 0.85 is a ratio of "
         "periods.",
         fmt::format("omega = {:.3f} rad/s; periods {:.3f}, frequencies {:.3f}", forcing,
                     printed_forcing / printed_natural, forcing / omega)}},
       {{"probe B at 0.0093 m", "A misprint of 0.093 m, the still surface.",
         fmt::format("still water presses with {:.0f} Pa at {} m and {:.0f} Pa at {} m, where the "
                     "record begins",
                     still_pressure(printed_probe), printed_probe, still_pressure(probe), probe)},
        {"8"}},
       {{"the roll is a sine from t = 0", "The experiment's starts from rest and is no pure sine.",
         roll_beside_sine(cases)},
        {"8"}},
       {{"kernel constant 7/4 pi h^2", "7/(4 pi h^2) is meant.",
         fmt::format(
             "the kernel over its constant integrates to {:.6f} h^2, and 7/(4 pi) times that "
             "is {:.6f}; 7/4 pi times it is {:.3f}",
             integral, 7 / (4 * pi) * integral, 7.0 / 4 * pi * integral)}}},
      redrawn);
}

}  // namespace

reports::Section zhao2021_section(const std::vector<CaseAssessment>& cases,
                                  const RedrawnFigures& redrawn) {
  return {"zhao2021",
          "Comparison with the paper",
          {"Zhao et al. 2021: sloshing in a rolling tank by SPH with dynamic boundary particles "
           "that move with the tank or are fixed in its frame. The rows below lead to the paper's "
           "figures as they are redrawn from this campaign's runs."},
          {claims_table("zhao2021-claims", claims_of("zhao2021", cases), redrawn),
           zhao2021_errata(cases, redrawn), deviations_table("zhao2021"),
           paper_figures_table(paper_named("zhao2021"), redrawn)},
          {}};
}

}  // namespace slosh
