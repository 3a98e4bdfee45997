#include "reference/section/section_modes.hpp"

#include <cmath>

#include "reference/require.hpp"
#include "reference/section/section_flow.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_section_modes = "SectionModes";

}  // namespace

SectionModes::SectionModes(const Section& section, int modes)
    : flow_(std::make_shared<const SectionFlow>(section, modes, in_section_modes)) {}

int SectionModes::count() const { return static_cast<int>(flow_->modes()); }
double SectionModes::left() const { return flow_->left(); }
double SectionModes::right() const { return flow_->right(); }
double SectionModes::still_level() const { return flow_->middle().z; }

double SectionModes::angular_frequency(int n) const {
  require(n >= 1 && n <= count(), in_section_modes, "mode", n, fmt::format("1 to {}", count()));
  return std::sqrt(flow_->section().gravity * flow_->wave_numbers[n - 1]);
}

double SectionModes::shape(int n, double x) const {
  require(n >= 1 && n <= count(), in_section_modes, "mode", n, fmt::format("1 to {}", count()));
  return flow_->on_surface(in_section_modes, x).potential[n - 1] /
         flow_->on_surface(in_section_modes, left()).potential[n - 1];
}

}  // namespace slosh::reference
