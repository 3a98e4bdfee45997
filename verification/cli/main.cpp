// The tool `slosh`: reads the command line, starts a subcommand, turns errors into messages and
// exit statuses.

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/own_files.hpp"
#include "verification/gate/gate.hpp"

namespace {

std::atomic<bool> stop_requested{false};

void request_stop(int) { stop_requested = true; }

slosh::Installation installation() {
  namespace fs = std::filesystem;
  const fs::path source = SLOSH_SOURCE_DIR;
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  return {executable,
          executable.parent_path() / "slosh.builds",
          source,
          source / "verification/cases",
          source / "verification/campaigns",
          source / "verification/baselines",
          source / "openfoam_cases/sloshing_tank",
          source / "build"};
}

// A stream that is closed takes the number of a file: what is printed would be written into the
// next output that is opened. Open the wrong way round, it refuses what is printed instead.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0)
      ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void tell_of_set_aside() {
  for (const std::string& one : slosh::told_of_set_aside())
    std::cerr << "slosh: " << slosh::legible_message(one) << "\n";
}

// Returns the exit status of a command, once all that it has printed is written.
int printed(int status) {
  tell_of_set_aside();
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::cerr << "slosh: " << slosh::not_printed << "\n";
  const bool is_better = status == slosh::exit_pass || status == slosh::exit_inconclusive;
  return is_better ? static_cast<int>(slosh::exit_not_compared) : status;
}

// A campaign that is interrupted ends its runs first.
void stop_on_signals() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

// Numbers and paths, also those of started programs, must not depend on the user's locale: its
// decimals may be commas, and boost::filesystem throws if the locale is not installed.
void use_no_locale() { setenv("LC_ALL", "C", 1); }

// OpenMP's threads look for new work 300,000 times before they sleep. This keeps a core busy that
// another process needs, and counts as cost of the run. Sleeping at every wait takes up to
// seventeen times as long. With 3000 looks, an idle machine takes 0.7 to 1.7 times as long
// (docs/performance.md). OpenMP reads the number at the start of the program, so the program starts
// itself again.
void bound_waiting_of_threads(char** argv) {
  if (getenv("GOMP_SPINCOUNT") || getenv("OMP_WAIT_POLICY")) return;
  setenv("GOMP_SPINCOUNT", "3000", 0);
  std::error_code unknown;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) execv(executable.c_str(), argv);  // if it fails, the threads wait as usual
}

int dispatch(int argc, char** argv) {
  const slosh::Installation data = installation();
  CLI::App app{"Verifies and validates SPH on sloshing tanks against theory and interFoam.",
               "./slosh"};
  if (argc == 1) {
    std::cout << slosh::first_steps;
    return slosh::exit_usage;
  }
  slosh::Action action;
  slosh::add_all_commands({app, data, stop_requested, stop_on_signals, action});
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    const std::string meant = asked_for_help ? "" : slosh::suggestion(app, {argv + 1, argv + argc});
    // Any other mistake that the parser reports follows from the wrong word.
    if (meant.empty())
      app.exit(error);
    else
      std::cerr << meant << "\nRun with --help for more information.\n";
    if (asked_for_help) return slosh::exit_pass;
    slosh::supersede_for_mistake(app, data, meant.empty() ? error.what() : meant);
    return slosh::exit_usage;
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  open_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is a write error, like a full disk
  std::signal(SIGCHLD, SIG_DFL);  // a parent that ignores it would hide the ends and costs of runs
  use_no_locale();
  bound_waiting_of_threads(argv);
  try {
    return printed(dispatch(argc, argv));
  } catch (const std::exception& error) {
    tell_of_set_aside();
    std::cerr << "slosh: " << slosh::legible_message(error.what()) << "\n";
    return slosh::status_of(error, stop_requested);
  }
}
