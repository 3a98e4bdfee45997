// Runs gnuplot on a program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace slosh::reports {

// The program that is found on the PATH; empty where there is none.
std::filesystem::path gnuplot_program();

// What gnuplot (started without a shell and without the user's start-up files) writes to its
// standard output. The files about it go to the scratch directory, under the figure's id. Throws
// ReportError with gnuplot's own words when it is missing, fails, or takes longer than two minutes:
// a figure takes a second at most.
std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory);
// The same with a time limit [s].
std::string run_gnuplot_within(double time_limit, const std::string& script,
                               const std::string& figure_id,
                               const std::filesystem::path& scratch_directory);

// Gives what run_gnuplot() gives, from any thread.
using Gnuplot = std::function<std::string(const std::string& script, const std::string& figure_id,
                                          const std::filesystem::path& scratch_directory)>;

// Why output that breaks off, of a gnuplot that says nothing of it, is refused. `what` it should
// be.
std::string broken_output(const std::string& figure_id, const std::string& what,
                          const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
