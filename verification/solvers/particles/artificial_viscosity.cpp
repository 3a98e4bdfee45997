#include "verification/solvers/particles/artificial_viscosity.hpp"

#include <map>
#include <string>
#include <type_traits>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "verification/solvers/sph_scene.hpp"

namespace slosh {
namespace {

struct SchemeViscosity {
  sph::SchemeNumbers numbers;
  double share_of_pairs;  // on which the viscosity acts
};
using SchemeViscosities = std::map<std::string, SchemeViscosity>;

template <class Choice>
SchemeViscosity viscosity_of() {
  const bool approaching = std::is_same_v<typename Choice::Viscosity, sph::MonaghanViscosity>;
  return {Choice::numbers, approaching ? 0.5 : 1.0};
}

template <class... Choices>
SchemeViscosities viscosities_of(sph::ChoiceList<Choices...>) {
  return {{Choices::variant, viscosity_of<Choices>()}...};
}

// By the names of the schemes and of the variants, of which none has the name of a scheme.
const SchemeViscosities& viscosities() {
  static const SchemeViscosities table = [] {
    SchemeViscosities all = viscosities_of(sph::Variants{});
    all.merge(SchemeViscosities{{"li2010", viscosity_of<sph::Li2010>()},
                                {"delta_sph", viscosity_of<sph::DeltaSph>()},
                                {"recommended", viscosity_of<sph::Recommended>()},
                                {"zhao2021_moving", viscosity_of<sph::Zhao2021Moving>()},
                                {"zhao2021_fixed", viscosity_of<sph::Zhao2021Fixed>()}});
    return all;
  }();
  return table;
}

}  // namespace

double artificial_viscosity(const CaseDefinition& definition, const SphRun& run) {
  const auto found = viscosities().find(run.variant.empty() ? run.scheme : run.variant);
  if (!run.numbers.artificial_viscosity || found == viscosities().end()) return 0;
  const auto& [own, share] = found->second;
  if (!own.artificial_viscosity) return 0;
  const double ratio = run.numbers.smoothing_length_ratio.value_or(*own.smoothing_length_ratio),
               sound = run.numbers.sound_speed_ratio.value_or(*own.sound_speed_ratio),
               c0 = sound * sph::expected_speed(sph_scene(definition, run));
  return share * *run.numbers.artificial_viscosity * ratio * run.particle_spacing * c0 / 8;
}

}  // namespace slosh
