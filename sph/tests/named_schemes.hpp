// The schemes and the variants of the recommended one, each by its own name.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sph/simulation.hpp"

namespace slosh::sph {

// A scheme by its name, or a variant of the recommended one by its own.
inline RunOutput run_named(const std::string& name, Scene scene) {
  const std::vector<std::string> schemes = scheme_names();
  if (std::find(schemes.begin(), schemes.end(), name) != schemes.end()) return run(name, scene, {});
  scene.variant = name;
  return run("recommended", scene, {});
}

inline std::vector<std::string> schemes_and_variants() {
  std::vector<std::string> names = scheme_names();
  for (const std::string& variant : variant_names()) names.push_back(variant);
  return names;
}

}  // namespace slosh::sph
