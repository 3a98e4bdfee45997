#include "reports/drawing/run_gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>

#include "reports/model/report_files.hpp"
#include "reports/model/report_model.hpp"
#include "verification/files/child_process.hpp"
#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {

std::filesystem::path gnuplot_program() { return program_on_path("gnuplot"); }

std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory) {
  return run_gnuplot_within(120, script, figure_id, scratch_directory);
}

std::string run_gnuplot_within(double time_limit, const std::string& script,
                               const std::string& figure_id,
                               const std::filesystem::path& scratch_directory) {
  const std::filesystem::path gnuplot = gnuplot_program();
  if (gnuplot.empty()) {
    throw ReportError(
        "gnuplot, which draws the report's figures, is not on the PATH (Debian: apt-get install "
        "gnuplot-nox)");
  }
  const auto program = scratch_directory / (figure_id + ".gp");
  write_text(program, script);
  try {
    ChildProcess child({gnuplot.string(), "--default-settings", program.string()},
                       {.splits_errors = true});
    if (!child.ends_within(std::chrono::duration<double>(time_limit)))
      throw ReportError(
          fmt::format("figure '{}': gnuplot was ended at its time limit of {:g} s: {}", figure_id,
                      time_limit, child.errors()));
    if (child.wait_status() != 0)
      throw ReportError(fmt::format("figure '{}': gnuplot ended with status {}: {}", figure_id,
                                    child.exit_status(), child.errors()));
    return child.output();
  } catch (const std::system_error& failure) {
    throw ReportError(
        fmt::format("figure '{}': gnuplot did not start: {}", figure_id, failure.what()));
  }
}

std::string broken_output(const std::string& figure_id, const std::string& what,
                          const std::filesystem::path& scratch_directory) {
  constexpr std::uintmax_t a_page = 4096;  // [byte]: with less, the disk is as good as full
  std::error_code unknown;
  const auto space = std::filesystem::space(scratch_directory, unknown);
  const bool is_full = !unknown && space.available < a_page;
  return fmt::format("figure '{}': gnuplot's output is not a complete {}{}", figure_id, what,
                     is_full ? ": no space left in " + scratch_directory.string() : "");
}

std::string quoted(const std::string& text) {
  // gnuplot 5.4 takes the apostrophe at the start of a literal '''a' for the literal's end.
  const std::string shown = legible(text);
  const std::size_t apostrophes = std::min(shown.find_first_not_of('\''), shown.size());
  std::string literal = apostrophes == 0 ? "'" : "\"" + shown.substr(0, apostrophes) + "\".'";
  for (const char c : shown.substr(apostrophes)) {
    if (c == '\'') literal += '\'';
    literal += c == '\n' || c == '\t' ? ' ' : c;
  }
  return literal + "'";
}

}  // namespace slosh::reports
