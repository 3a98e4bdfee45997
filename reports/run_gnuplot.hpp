// Runs gnuplot on a program.
#pragma once

#include <filesystem>
#include <string>

namespace slosh::reports {

// What gnuplot (found on the PATH, without a shell and without the user's start-up files) writes to
// its standard output. The files about it go to the scratch directory, under the figure's id.
// Throws ReportError with gnuplot's own words when it is missing, fails, or takes longer than
// `time_limit` [s]: a figure takes a second at most.
std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory, double time_limit = 120);

// Why output that breaks off, of a gnuplot that says nothing of it, is refused. `what` it should
// be.
std::string broken_output(const std::string& figure_id, const std::string& what,
                          const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
