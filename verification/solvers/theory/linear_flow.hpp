// Linear potential flow of a case's tank: the sum of the solutions for its surge, its roll and its
// initial wave, as linear theory has it. The hydrostatic pressure, which each of them contains,
// counts once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// All places are in the tank, x from its left end and z from its bottom [m], and all series are at
// the case's sample times.
class LinearFlow {
 public:
  virtual ~LinearFlow() = default;

  virtual std::vector<double> elevation(double x) const = 0;  // [m]
  // Of a place under the still surface [Pa].
  virtual std::vector<double> pressure(Corner place) const = 0;
  // Relative to the tank, of such a place [m/s].
  virtual std::vector<double> velocity_x(Corner place) const = 0;
  virtual std::vector<double> velocity_z(Corner place) const = 0;
  virtual std::vector<double> force_x() const = 0;  // of the liquid on the tank [N/m]
  // The moment about the roll's axis [N] is known where nothing but roll excites the liquid.
  virtual bool has_moment() const = 0;
  virtual std::vector<double> moment() const = 0;
  // What a result says of the modes that were summed.
  virtual std::string modes_text() const = 0;
};

// Returns the flow in a rectangular tank (reference/linear_surge.hpp, linear_roll.hpp,
// standing_wave.hpp).
std::unique_ptr<LinearFlow> linear_flow_in_rectangle(const LinearRun& linear,
                                                     const CaseDefinition& definition);

// Returns the flow in a tank of any other section (reference/section/), which has no gas.
std::unique_ptr<LinearFlow> linear_flow_in_outline(const LinearRun& linear,
                                                   const CaseDefinition& definition);

}  // namespace slosh
