#include "sph/simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <stdexcept>

#include "sph/coarse_run.hpp"
#include "sph/restart/saved_state.hpp"
#include "sph/run.hpp"
#include "sph/scheme.hpp"
#include "sph/scheme_terms.hpp"
#include "sph/schemes.hpp"
#include "sph/threads.hpp"

namespace slosh::sph {
namespace {

// A choice, made available at run time under its name.
struct Named {
  Method (*method)(const Scene&);
  bool rolls;
};
using Methods = std::map<std::string, Named>;

template <class Choice>
Named named() {
  return {[](const Scene& scene) { return method_of(Scheme<Choice>(scene)); },
          Choice::Frame::takes_roll};
}

template <class... Choices>
Methods methods_of(ChoiceList<Choices...>) {
  return {{Choices::variant, named<Choices>()}...};
}

// The variants of `recommended` that can roll in the tank's frame, under their names.
template <class... Choices>
Methods in_tank(ChoiceList<Choices...>) {
  return {{Choices::variant, named<InTank<Choices>>()}...};
}

std::vector<std::string> names_of(const Methods& table) {
  std::vector<std::string> names;
  for (const auto& [name, method] : table) names.push_back(name);
  return names;
}

const Methods& schemes() {
  static const Methods table{{"li2010", named<Li2010>()},
                             {"delta_sph", named<DeltaSph>()},
                             {"recommended", named<Recommended>()},
                             {"zhao2021_moving", named<Zhao2021Moving>()},
                             {"zhao2021_fixed", named<Zhao2021Fixed>()}};
  return table;
}

// The schemes and variants whose walls cannot roll. Where the tank rolls, each is replaced by the
// same choice in the tank's frame.
const Methods& rolling() {
  static const Methods table = [] {
    Methods all = in_tank(RollingVariants{});
    all.merge(Methods{{"li2010", named<InTank<Li2010>>()},
                      {"delta_sph", named<InTank<DeltaSph>>()},
                      {"recommended", named<InTank<Recommended>>()}});
    return all;
  }();
  return table;
}

const Methods& variants() {
  static const Methods table = methods_of(Variants{});
  return table;
}

Named look_up(const Methods& table, const char* what, const std::string& name) {
  const auto found = table.find(name);
  if (found == table.end())
    throw std::invalid_argument(fmt::format("{} = \"{}\": expected one of {}", what, name,
                                            fmt::join(names_of(table), " | ")));
  return found->second;
}

// The schemes and variants whose walls take any outline, for a tank that rolls and one that does
// not: those with walls of solid particles, which those with mirror particles get here.
Methods in_outline(bool rolls) {
  Methods all = rolls ? in_tank(OutlineVariants{}) : methods_of(OutlineVariants{});
  all["recommended"] = all.at("ghost_walls");
  for (const char* name : {"dynamic_walls", "fixed_dynamic_walls"}) all[name] = variants().at(name);
  for (const char* name : {"zhao2021_moving", "zhao2021_fixed"}) all[name] = schemes().at(name);
  all["delta_sph"] = rolls ? rolling().at("delta_sph") : schemes().at("delta_sph");
  return all;
}

Named chosen(const std::string& scheme, const Scene& scene) {
  const Named method = look_up(schemes(), "scheme", scheme);
  const auto turned = rolling().find(scene.variant.empty() ? scheme : scene.variant);
  const bool uniform = scene.surface_particle_spacing == scene.particle_spacing;
  if (!scene.variant.empty() && scheme != "recommended")
    throw std::invalid_argument(fmt::format(
        "variant = \"{}\": expected none, only recommended has variants", scene.variant));
  if (!uniform && (scheme != "li2010" || scene.roll))
    throw std::invalid_argument("scheme " + scheme +
                                " takes one particle spacing: surface_particle_spacing differs");
  if (!scene.outline.empty()) {
    if (!scene.variant.empty()) look_up(variants(), "variant", scene.variant);
    const bool varies = !scene.variant.empty();
    return look_up(
        in_outline(scene.roll.has_value()),
        varies ? "variant in a tank that is no rectangle" : "scheme in a tank that is no rectangle",
        varies ? scene.variant : scheme);
  }
  if (!uniform) return named<Li2010TwoSpacings>();
  if (scene.roll && turned != rolling().end()) return turned->second;
  return scene.variant.empty() ? method : look_up(variants(), "variant", scene.variant);
}

void require_roll(const Named& method) {
  if (method.rolls) return;
  std::vector<std::string> can_roll;
  for (const auto& [name, variant] : variants())
    if (variant.rolls || rolling().contains(name)) can_roll.push_back(name);
  throw std::invalid_argument(
      fmt::format("motion.roll: expected none with this variant of recommended; recommended can "
                  "roll as it is and with {}",
                  fmt::join(can_roll, ", ")));
}

std::size_t particles_in(const Scene& scene) {
  const double width = scene.column_width.value_or(scene.tank_length);
  return static_cast<std::size_t>(width * scene.fill_depth /
                                  (scene.particle_spacing * scene.particle_spacing));
}

// A restart has the speed of the run that saved the state, without a coarse run. A state of a run
// without one is refused later, because the terms differ.
Scene with_measured_speed(const std::string& scheme, const Scene& scene) {
  Scene measured = scene;
  if (!scene.resume) {
    measured.coarse_run =
        coarse_run(scene, [&](const Scene& coarse) { return run(scheme, coarse, {}); });
    return measured;
  }
  const auto saved = [&](const char* name) {
    const auto found = scene.resume->setting.find(name);
    return found == scene.resume->setting.end() ? 0 : found->second;
  };
  measured.coarse_run = {saved("coarse_run_spacing"), saved("coarse_run_speed")};
  return measured;
}

}  // namespace

std::vector<std::string> scheme_names() { return names_of(schemes()); }

std::vector<std::string> variant_names() { return names_of(variants()); }

double stable_time_step(const std::string& scheme, const Scene& scene) {
  const Method method = chosen(scheme, scene).method(scene);
  const double at_bottom =
      method.terms->density(scene.rest_density * scene.gravity * scene.fill_depth);
  return method.stable_step(scene.gravity, method.terms->speed_of_sound_at(at_bottom));
}

RunOutput run(const std::string& scheme, const Scene& scene, const Progress& progress) {
  const Named named = chosen(scheme, scene);
  if (scene.roll) require_roll(named);
  if (scene.speed_from_coarse_run && !scene.coarse_run && scene.takes_steps)
    return run(scheme, with_measured_speed(scheme, scene), progress);
  const ThreadScope threads(scene.threads.value_or(threads_for(particles_in(scene))));
  return run(named.method(scene), scene, progress);
}

}  // namespace slosh::sph
