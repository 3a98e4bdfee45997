// The subcommand store: prints the size of the shared results, and lists or removes those that
// earlier builds left. Only a report that starts no solver and the expected costs still use the
// latter.

#include <fmt/format.h>

#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>

#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/gate/gate.hpp"
#include "verification/problems/problem_result.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct OldResult {
  std::string key, name;  // "CASE/RUN (sph)", or a description
  std::uintmax_t size;    // [byte]
};

struct OldResults {
  std::vector<OldResult> results;
  std::vector<fs::path> foreign;  // they look alike, but the store has not made them
};

constexpr const char* unreadable = "a result that cannot be read";

// Returns what lies under a key of another build; nullopt if a present build may still use it.
std::optional<std::string> name_of_old(const ResultStore& store, const std::string& key,
                                       const PresentAnswers& present) try {
  if (const fs::path file = store.file(key, ".h5"); fs::exists(file)) {
    const RunResult result = named_result(file);
    if (present.unknown_solvers.contains(result.solver)) return std::nullopt;
    return result.case_name + "/" + result.run_name + " (" + result.solver + ")";
  }
  if (const fs::path file = store.file(key, ".json"); fs::exists(file))
    return legible_message(read_problem_result(file).problem) + " (a problem)";
  return "what a failed or interrupted run left";
} catch (const ResultError&) {
  return unreadable;
}

// Returns the results that no build of this tree produces any more. A result of a present build is
// never old, whatever case file it belongs to, nor is one of a solver whose build is unknown.
OldResults old_results(const ResultStore& store, const PresentAnswers& present) {
  OldResults old;
  for (const std::string& key : store.keys()) {
    if (present.gave(key)) continue;
    const auto name = name_of_old(store, key, present);
    if (!name) continue;
    const StoreContents contents = store.contents(key);
    if (!contents.made.empty()) old.results.push_back({key, *name, contents.size});
    old.foreign.insert(old.foreign.end(), contents.foreign.begin(), contents.foreign.end());
  }
  return old;
}

struct StoreOptions {
  std::filesystem::path store;
  bool remove = false, total_alone = false;
};

std::string size_text(std::uintmax_t bytes) {
  const double size = static_cast<double>(bytes);
  if (size >= 1e9) return fmt::format("{:.1f} GB", size / 1e9);
  if (size >= 1e6) return fmt::format("{:.1f} MB", size / 1e6);
  return fmt::format("{:.1f} kB", size / 1e3);
}

struct Sum {
  std::size_t count = 0;
  std::uintmax_t size = 0;

  void add(std::uintmax_t bytes) {
    ++count;
    size += bytes;
  }
};

Sum all_in(const ResultStore& store) {
  Sum sum;
  for (const std::string& key : store.keys()) sum.add(store.size(key));
  return sum;
}

void print_line(const char* word, const OldResult& one) {
  std::cout << fmt::format("{:<10} {:>9}  {}, {}\n", word, size_text(one.size), one.name, one.key);
}

void tell_of_foreign(const OldResults& old) {
  for (const fs::path& path : old.foreign)
    std::cout << legible_message(fmt::format(
        "kept       {}, which does not hold the store's seal and this key, or holds what Slosh has "
        "not left so\n",
        path.string()));
}

int remove_old(const ResultStore& store, const OldResults& old) {
  Sum removed;
  for (const OldResult& one : old.results) {
    if (!store.remove(one.key)) {
      print_line("in use", one);
      continue;
    }
    print_line("removed", one);
    removed.add(one.size);
  }
  tell_of_foreign(old);
  const Sum left = all_in(store);
  std::cout << fmt::format("{}: {} results removed, {}; {} are left, {}\n", store.root().string(),
                           removed.count, size_text(removed.size), left.count,
                           size_text(left.size));
  return exit_pass;
}

int tell_of_store(const StoreOptions& options, const Installation& installation) {
  const ResultStore store(std::filesystem::absolute(options.store));
  const OldResults old =
      old_results(store, present_answers(installation.builds, installation.openfoam_templates));
  if (options.remove) return remove_old(store, old);
  Sum of_old;
  if (!options.total_alone) tell_of_foreign(old);
  for (const OldResult& one : old.results) {
    if (!options.total_alone) print_line("old", one);
    of_old.add(one.size);
  }
  const Sum all = all_in(store);
  std::cout << fmt::format("{}: {} results, {}; {} of them, {}, are of earlier builds{}\n",
                           store.root().string(), all.count, size_text(all.size), of_old.count,
                           size_text(of_old.size),
                           old.results.empty() ? "" : ": './slosh store --remove' removes these");
  return exit_pass;
}

}  // namespace

void add_store_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<StoreOptions>(
      tree,
      {"store",
       "Prints the size of the kept results, and which of them earlier builds left",
       {"./slosh store", "./slosh store --remove"}},
      tell_of_store);
  add_shared_store_option(command, options.store, tree.installation);
  CLI::Option* remove =
      command.add_flag("--remove", options.remove,
                       "Remove and list what earlier builds left and nobody uses; results of "
                       "external programs stay, and those of interFoam if it is not installed");
  command.add_flag("--total", options.total_alone, "Print only the last line")->excludes(remove);
}

}  // namespace slosh
