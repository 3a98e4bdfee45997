#include "reports/run_gnuplot.hpp"

#include <fmt/format.h>

#include <boost/process.hpp>
#include <system_error>

#include "reports/text_file.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {

namespace process = boost::process;

std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory) {
  const auto gnuplot = process::search_path("gnuplot");
  if (gnuplot.empty()) {
    throw ReportError(
        "gnuplot, which draws the report's figures, is not on the PATH (Debian: apt-get install "
        "gnuplot-nox)");
  }
  const auto program = scratch_directory / (figure_id + ".gp");
  const auto output = scratch_directory / (figure_id + ".out");
  const auto messages = scratch_directory / (figure_id + ".log");
  write_text(program, script);
  for (const auto& file : {output, messages})
    std::filesystem::remove(file);  // one that is there would be overwritten, but not cut
  std::error_code failure;
  const int status =
      process::system(gnuplot, "--default-settings", program.string(),
                      process::std_in<process::null, process::std_out> output.string(),
                      process::std_err > messages.string(), failure);
  if (failure)
    throw ReportError(
        fmt::format("figure '{}': gnuplot did not start: {}", figure_id, failure.message()));
  if (status != 0) {
    throw ReportError(fmt::format("figure '{}': gnuplot ended with status {}: {}", figure_id,
                                  status, read_text(messages)));
  }
  return read_text(output);
}

}  // namespace slosh::reports
