// The schemes and the variants of the recommended one, each by its own name.
#pragma once

#include <gtest/gtest.h>

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

// Of tests that every scheme and variant passes.
class EachNamedScheme : public testing::TestWithParam<std::string> {
 protected:
  RunOutput run_it(const Scene& scene) const { return run_named(GetParam(), scene); }
};

}  // namespace slosh::sph
