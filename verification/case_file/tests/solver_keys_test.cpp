// The keys that a [[run]] may have, by its solver: for every solver, each key of another solver is
// refused. The refusals of the parser list the keys of a solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::solver_keys_test {
namespace {

using Keys = std::vector<std::string>;

// How the run of a solver begins; a record has two forms.
struct Form {
  std::string name, text;
};

const std::vector<Form> forms{{"sph", "solver = \"sph\"\n"},
                              {"interfoam", "solver = \"interfoam\"\n"},
                              {"interisofoam", "solver = \"interisofoam\"\n"},
                              {"compressible_interfoam", "solver = \"compressible_interfoam\"\n"},
                              {"linear", "solver = \"linear\"\n"},
                              {"viscous_wave", "solver = \"viscous_wave\"\n"},
                              {"potential", "solver = \"potential\"\n"},
                              {"shipped record", "solver = \"record\"\n"},
                              {"experiment", "solver = \"record\"\nexperiment = \"a.csv\"\n"},
                              {"external", "solver = \"external\"\n"}};

std::string complaint_about_run(const Form& form, const std::string& key) {
  return complaint_about(
      {"[[gate]]", "[[run]]\nname = \"x\"\n" + form.text + key + " = 1\n[[gate]]"});
}

// "...: expected only these keys here: name, solver, quick, modes; nearest known key: modes"
Keys keys_of(const Form& form) {
  const std::string message = complaint_about_run(form, "colour");
  const std::string before = "run.colour = 1: expected only these keys here: ";
  const std::size_t begin = message.find(before);
  if (begin == std::string::npos) throw std::logic_error(form.name + ": " + message);
  const std::size_t first = begin + before.size();
  const std::string list = message.substr(first, message.find(';') - first);
  Keys keys;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    keys.push_back(list.substr(at, end - at));
    at = end + 2;
  }
  return keys;
}

bool contains(const Keys& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

TEST(SolverKeys, OfAnotherSolverAreRefused) {
  std::size_t pairs = 0;
  for (const Form& form : forms) {
    const Keys own = keys_of(form);
    for (const Form& other : forms)
      for (const std::string& key : keys_of(other)) {
        if (contains(own, key) || key == "experiment") continue;  // which makes a record the other
        const std::string message = complaint_about_run(form, key);
        EXPECT_TRUE(holds(message, "run." + key + " = 1: expected only these keys here: name"))
            << form.name << ": " << message;
        ++pairs;
      }
  }
  EXPECT_GT(pairs, 150u);
}

TEST(SolverKeys, OfTheOtherSolversAreNoneOfSph) {
  const Keys sph = keys_of(forms.front());
  EXPECT_TRUE(contains(sph, "scheme"));
  for (const char* key : {"cells_x", "modes", "nodes_x", "file", "uncertainty", "command"})
    EXPECT_FALSE(contains(sph, key)) << key;
}

TEST(SolverKeys, AMisspeltSolverIsToldByTheNearestKey) {
  const std::string message = complaint_about({"solver = \"interfoam\"", "solvr = \"interfoam\""});
  EXPECT_TRUE(begins(message, "trial.toml:49: run.solvr = \"interfoam\": expected only"));
  EXPECT_TRUE(message.ends_with("nearest known key: solver")) << message;
}

}  // namespace
}  // namespace slosh::solver_keys_test
