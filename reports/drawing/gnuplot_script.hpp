// The gnuplot program that draws one figure, as SVG or PNG, on its standard output.
//
// All text is in single quotes, where gnuplot expands nothing (no command, no macro, no escape).
// All data is in inline datablocks. The program needs gnuplot 5.4 (keyentry, set minussign).
//
// It also runs gnuplot on a program, and quotes the texts in such a program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

enum class Terminal { svg, png };  // a PNG has twice the pixels

std::string gnuplot_script(const Figure& figure, Terminal terminal = Terminal::svg);

// How gnuplot draws a curve.
struct Stroke {
  const char* colour;  // on white paper
  int point;           // a gnuplot point type
  const char* dash;    // a gnuplot dash type
};

// `dashed` curves have dashes of their own, with longer gaps.
Stroke stroke_of(const Look& look, bool dashed = false);

// The colour of the figure's band of this index, on white paper.
const char* band_colour(const Figure& figure, std::size_t index);

// The gnuplot on the PATH; empty where there is none.
std::filesystem::path gnuplot_program();

// Returns what gnuplot, started without a shell and without the user's start-up files, writes to
// its standard output. Its program and its output are kept in the scratch directory under the
// figure's id. Throws ReportError with gnuplot's own words when it is missing, fails, or takes
// longer than two minutes: a figure takes a second at most.
std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory);
// The same with a time limit [s].
std::string run_gnuplot_within(double time_limit, const std::string& script,
                               const std::string& figure_id,
                               const std::filesystem::path& scratch_directory);

// A function that returns what run_gnuplot() returns and may be called from any thread.
using Gnuplot = std::function<std::string(const std::string& script, const std::string& figure_id,
                                          const std::filesystem::path& scratch_directory)>;

// The message for output that breaks off although gnuplot reported no error. `what` names what the
// output should be, and the message says so if the disk is full.
std::string broken_output(const std::string& figure_id, const std::string& what,
                          const std::filesystem::path& scratch_directory);

// A string literal in which gnuplot expands nothing. Line breaks and tabs become blanks,
// and what is not legible (legible_text.hpp) is left out.
std::string quoted(const std::string& text);

}  // namespace slosh::reports
