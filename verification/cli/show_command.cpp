// The subcommand show: draws the histories of a case from the existing results. It throws
// CaseFileError for impossible options, ResultError if there is nothing to show, and ReportError if
// the picture cannot be drawn.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>

#include "reports/drawing/draw_figure.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/model/report_files.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/campaign/campaign_plan.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

std::string browser_name() {
  const char* named = std::getenv("BROWSER");
  const std::string list = named ? named : "";
  const std::string first = list.substr(0, list.find(':'));
  return first.empty() ? "xdg-open" : first;
}

// Shows a file by the program that the variable BROWSER names (the first of a list), or else by
// xdg-open, without a shell. Waits for the program, as a browser in the terminal requires. Returns
// why the file could not be shown, or an empty text.
std::string open_browser(const std::filesystem::path& file) {
  std::string name = browser_name(), page = file.string();
  char* const arguments[] = {name.data(), page.data(), nullptr};
  pid_t child;
  const int failure = ::posix_spawnp(&child, name.c_str(), nullptr, nullptr, arguments, ::environ);
  if (failure == ENOENT) return "there is no program " + name + " (the variable BROWSER names one)";
  if (failure != 0) return name + " did not start: " + std::strerror(failure);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status == 0 ? "" : name + " ended with status " + std::to_string(WEXITSTATUS(status));
}

namespace fs = std::filesystem;

struct ShowOptions {
  std::string case_name;
  std::string quantity;               // of the picture; empty: the case's main one
  std::filesystem::path output;       // .png, .svg or .html; empty: a page, shown by a browser
  std::filesystem::path store;        // of the results
  std::filesystem::path experiments;  // empty: none is named
};

struct Stored {
  CaseRuns runs;
  std::vector<std::string> remarks;  // on missing and outdated results
};

std::string how_to_compute(const CaseDefinition& definition, const RunDefinition& run,
                           const ShowOptions& options, const Installation& installation) {
  return fmt::format("`./slosh run {} {}{}` computes it",
                     name_or_path(definition.file, installation.cases), run.name,
                     is_record(run) ? experiments_option(whole(options.experiments)) : "");
}

void take(const PlannedRun& planned, const std::string& way, Stored& stored) {
  const std::string& name = planned.run->name;
  RunStatus& status = stored.runs.status[name] = planned.status;
  if (status.state == RunState::finished) try {
      protect_input(planned.file);
      stored.runs.results[name] = read_stored(planned.file, read_result);
      if (!status.message.empty()) stored.remarks.push_back(name + " was " + status.message);
      return;
    } catch (const ResultError& error) {
      status = {RunState::missing, error.what()};
    }
  stored.remarks.push_back(fmt::format("{} is not there: {}", name,
                                       status.state == RunState::missing ? way : status.message));
}

Stored stored_runs(const CaseDefinition& definition, const ShowOptions& options,
                   const Installation& installation) {
  const std::vector<CaseDefinition> cases{definition};
  CampaignSettings settings;
  settings.store = ResultStore(whole(options.store));
  settings.builds = installation.builds;
  settings.openfoam_templates = installation.openfoam_templates;
  settings.solve = false;
  Stored stored;
  for (const PlannedRun& planned : plan_runs(cases, settings))
    take(planned, how_to_compute(definition, *planned.run, options, installation), stored);
  return stored;
}

const reports::Figure& figure_of(const std::string& quantity, const CaseDefinition& definition,
                                 const std::vector<reports::Figure>& figures) {
  const std::vector<std::string> known = compared_quantities(definition);
  if (quantity.empty()) return figures.front();
  const std::string id =
      definition.name + "-" + (quantity == known.front() ? "history" : id_of(quantity));
  for (const reports::Figure& figure : figures)
    if (figure.id == id) return figure;
  if (std::find(known.begin(), known.end(), quantity) == known.end())
    throw CaseFileError(
        fmt::format("--quantity: {}: expected one of {}", quantity, fmt::join(known, ", ")));
  throw ResultError(fmt::format("{}: no result that is there has it", quantity));
}

enum class Form { png, svg, page };

Form form_of(const fs::path& file) {
  if (file.empty() || file.extension() == ".html") return Form::page;
  if (file.extension() == ".png") return Form::png;
  if (file.extension() == ".svg") return Form::svg;
  throw CaseFileError("--output: " + file.string() +
                      ": expected a name that ends in .png, .svg "
                      "or .html");
}

std::string drawn(Form form, const reports::Figure& figure, const fs::path& scratch) {
  return form == Form::png ? reports::draw_png(figure, scratch)
                           : reports::svg_element(figure, reports::draw_figure(figure, scratch),
                                                  reports::SvgPlace::own_file);
}

int show_case(const ShowOptions& options, const Installation& installation) {
  const Form form = form_of(options.output);
  const CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), whole(options.experiments));
  Stored stored = stored_runs(definition, options, installation);
  for (const std::string& remark : stored.remarks) std::cerr << remark << "\n";
  const std::vector<reports::Figure> figures = case_histories(definition, std::move(stored.runs));
  if (figures.empty()) throw ResultError(definition.name + ": no result is there to be shown");
  const fs::path file = options.output.empty() ? shown_page(installation, definition.name)
                                               : fs::absolute(options.output);
  fs::create_directories(file.parent_path());
  const reports::TemporaryDirectory scratch((file.parent_path() / ".drawing-").string());
  const std::string text =
      form == Form::page
          ? reports::figure_page(definition.title, figures, stored.remarks, scratch.path())
          : drawn(form, figure_of(options.quantity, definition, figures), scratch.path());
  replace_named(file, text, "show");
  std::cout << "picture: " << file.string() << std::endl;
  if (!options.output.empty()) return exit_pass;
  const std::string why = open_browser(file);
  if (!why.empty()) std::cerr << "no browser shows it: " << why << "\n";
  return exit_pass;
}

}  // namespace

void add_show_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<ShowOptions>(
      tree,
      {"show",
       "A picture of a case's histories, of the results that there are",
       {"./slosh run li2010_small_amplitude linear",
        "./slosh show li2010_small_amplitude -o histories.png"}},
      show_case);
  add_case_argument(command, options.case_name)->required();
  CLI::Option* output =
      add_option(command, "-o,--output", options.output, file_type,
                 "The picture, .png or .svg, or a page of all, .html (default: such a page, "
                 "shown/CASE.html beside the store, which $BROWSER or xdg-open then shows)");
  command
      .add_option("--quantity", options.quantity,
                  "What the picture is of, as elevation@right (default: the first that the case "
                  "compares)")
      ->needs(output);
  add_experiments_option(command, options.experiments);
  add_shared_store_option(command, options.store, tree.installation);
}

}  // namespace slosh
