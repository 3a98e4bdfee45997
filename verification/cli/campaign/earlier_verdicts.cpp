#include "verification/cli/campaign/earlier_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "reports/pages/report_documents.hpp"
#include "reports/summary/recorded_campaigns.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/engine/job.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char *gate_folder = "gate", *report_folder = "report", *page_name = "index.html",
                     *data_name = "results.json";

reports::GateDocument superseded_gate(const std::string& campaign, int status,
                                      const std::string& why) {
  return {.title = campaign,
          .verdict = headline_word(exit_not_compared) + ": " + why,
          .entries = {bare_entry(campaign, "the campaign", Verdict::not_compared, why)},
          .exit_status = status};
}

// The exit status that the texts of a folder tell; nullopt where none does.
std::optional<int> told_status(const fs::path& file, const std::string& text) try {
  if (file.filename() == data_name) return recorded_campaign(text, "").exit_status;
  return reports::exit_status_in(text);
} catch (const std::invalid_argument&) {
  return std::nullopt;
}

template <class... Errors>
bool is_one_of(const std::exception& error) {
  return (dynamic_cast<const Errors*>(&error) || ...);
}

// Whether the text says that it is Slosh's, whoever has edited it and whatever became of the list.
bool carries_mark(const fs::path& file, const std::string& text) {
  return told_status(file, text) || text.find("content=\"Slosh report\"") != text.npos;
}

bool is_removable(const fs::path& file) try {
  require_own(file);
  return fs::is_regular_file(fs::symlink_status(file));
} catch (const std::exception&) {  // behind a link
  return false;
}

// A campaign's name where its file cannot be read.
fs::path known_place(const CampaignOptions& options, const Installation& installation) try {
  if (options.all)
    return whole(options.output.empty() ? installation.build / "campaigns" : options.output);
  return place_of(options, installation);
} catch (const CaseFileError&) {
  CampaignOptions named = options;
  named.output = installation.build / "campaigns" / (options.campaign + form_of(options));
  return place_of(named, installation);
}

}  // namespace

EarlierVerdicts::Place EarlierVerdicts::read(const fs::path& directory) {
  Place place{directory, {}};
  for (const fs::path& file :
       {directory / gate_folder / junit_name, directory / gate_folder / gate_page_name,
        directory / report_folder / page_name, directory / report_folder / data_name})
    try {
      const std::string text = read_bytes(file);
      if (!foreign_at(file) || carries_mark(file, text)) place.texts[file] = text;
    } catch (const fs::filesystem_error&) {  // there is none, or a device
    }
  return place;
}

EarlierVerdicts::EarlierVerdicts(const CampaignOptions& options, const Installation& installation,
                                 const std::atomic<bool>& stop)
    : campaign_(options.all ? "all campaigns" : options.campaign), stop_(stop) {
  places_.push_back({known_place(options, installation), {}});
  output_ = places_.front().directory;
  if (!options.selection.is_partial()) return;
  output_ = output_.parent_path();
  places_.push_back({output_, {}});
}

void EarlierVerdicts::supersede(const Place& place, const char* folder, int status,
                                const std::string& why) {
  const fs::path directory = place.directory / folder;
  const auto is_in_folder = [&](const auto& one) { return one.first.parent_path() == directory; };
  if (std::none_of(place.texts.begin(), place.texts.end(), is_in_folder)) return;
  std::map<fs::path, std::string> texts;
  if (folder == std::string(gate_folder)) {
    const reports::GateDocument document = superseded_gate(campaign_, status, why);
    texts[directory / junit_name] = reports::junit_xml(document);
    texts[directory / gate_page_name] = reports::gate_markdown(document);
  } else {
    const reports::Report report = superseded_report(campaign_, status, why);
    texts[directory / data_name] = report.results_json;
    texts[directory / page_name] = reports::html_pages(report, {}).front().text;
  }
  for (const auto& [file, text] : texts) try {
      replace_own(file, text);
    } catch (const std::exception& error) {  // no room: an old verdict must not stay for that
      std::error_code stays;
      complaints_[file] = fmt::format("{}: {}",
                                      is_removable(file) && fs::remove(file, stays)
                                          ? "removed an earlier verdict"
                                          : "an earlier verdict stays, remove it",
                                      error.what());
    }
}

void EarlierVerdicts::require_superseded() {
  if (complaints_.empty()) return;
  std::string all;
  for (const auto& [file, complaint] : complaints_) all += (all.empty() ? "" : "\n") + complaint;
  throw std::runtime_error(all);
}

void EarlierVerdicts::begin(const std::vector<std::string>& written) {
  Place& own = places_.front();
  for (const char* folder : {gate_folder, report_folder}) require_no_input(own.directory / folder);
  lock_ = lock_output(output_, stop_);
  for (Place& place : places_) place = read(place.directory);
  for (const Place& place : places_)
    for (const char* folder : {gate_folder, report_folder})
      supersede(place, folder, exit_not_compared, "the start has not come to its verdict");
  require_superseded();
  for (const std::string& output : written) require_room(own.directory / output);
}

bool EarlierVerdicts::is_in_use() try {
  if (fs::exists(output_ / "jobs/lock")) lock_ = free_output(output_);
  return !lock_ && fs::exists(output_ / "jobs/lock");
} catch (const fs::filesystem_error&) {  // behind a link, or of another user
  return false;
}

int EarlierVerdicts::end_early(const std::string& why, int status) {
  if (status == exit_not_compared && judged_ && is_worse_status(*judged_, status))
    status = *judged_;
  // Another start that works there leaves its own verdict.
  if (!lock_ && is_in_use()) return status;
  for (const Place& known : places_) {
    const Place place = read(known.directory);
    for (const char* folder : {gate_folder, report_folder})
      if (!judged_ || told(place, folder) != status) supersede(place, folder, status, why);
  }
  for (const auto& [file, complaint] : complaints_)
    if (why.find(complaint) == why.npos)
      std::cerr << "slosh: " << legible_message(complaint) << "\n";
  return status;
}

std::optional<int> EarlierVerdicts::told(const Place& place, const char* folder) {
  std::optional<int> found;
  for (const auto& [file, text] : place.texts)
    if (file.parent_path().filename() == folder)
      if (const auto one = told_status(file, text);
          one && (!found || is_worse_status(*found, *one)))
        found = one;
  return found;
}

void EarlierVerdicts::put_back(const Place& place, const char* folder) {
  for (const auto& [file, text] : place.texts)
    if (file.parent_path().filename() == folder) replace_own(file, text);
}

void EarlierVerdicts::end(const char* folder, int status, int asked) {
  const Place& own = places_.front();
  const std::string why =
      fmt::format("a later start has ended with exit status {}{}", asked,
                  asked == status ? "" : " and the verdict " + headline_word(status));
  const bool has_failed = is_worse_status(status, exit_not_compared);
  for (auto whole = places_.begin() + 1; whole != places_.end(); ++whole)
    for (const char* one : {gate_folder, report_folder})
      if (has_failed && is_worse_status(status, told(*whole, one).value_or(exit_pass)))
        supersede(*whole, one, asked, why);
      else
        put_back(*whole, one);
  const std::optional<int> before = told(own, folder);
  if (!before || is_worse_status(status, *before))
    supersede(own, folder, has_failed || asked == exit_pass ? asked : exit_not_compared, why);
  else
    put_back(own, folder);
  require_superseded();
}

int superseding(const CampaignOptions& options, const Installation& installation,
                const std::atomic<bool>& stop, const std::function<int(EarlierVerdicts&)>& start) {
  EarlierVerdicts earlier(options, installation, stop);
  try {
    return start(earlier);
  } catch (const std::exception& error) {
    const int without = status_of(error, stop), status = earlier.end_early(error.what(), without);
    if (status == without) throw;
    std::cerr << "slosh: " << legible_message(error.what()) << "\n";
    return status;
  }
}

int status_of(const std::exception& error, const std::atomic<bool>& stop) {
  if (is_one_of<CaseFileError, OutputError, MissingEngine>(error)) return exit_usage;
  if (is_one_of<SolverError>(error)) return exit_solver_failed;
  // An interrupt also ends the plotter, and is then the cause.
  if (is_one_of<InterruptedError>(error) || stop) return exit_interrupted;
  return exit_not_compared;
}

void supersede_for_mistake(const CLI::App& app, const Installation& installation,
                           const std::string& mistake) {
  const std::atomic<bool> never{false};
  for (const char* name : {"campaign", "gate"}) {
    const CLI::App& command = *app.get_subcommand(name);
    const auto is_given = [&](const char* option) {
      return command.get_option_no_throw(option) && command.get_option(option)->count() > 0;
    };
    if (!command.parsed() || is_given("--selftest")) continue;
    const auto words = [&](const char* option) { return command.get_option(option)->results(); };
    CampaignOptions options;
    options.selection.quick = is_given("--quick");
    options.selection.only = words("--only");
    options.selection.tags = words("--tag");
    options.all = is_given("--all");
    // The words that the parser could not place may be the output or the campaign.
    std::vector<std::string> outputs = words("--output"), names = words("name");
    for (const std::string& one : app.remaining(true)) {
      outputs.push_back(one.substr(one.find('=') + 1));
      if (!one.starts_with("-")) names.push_back(one);
    }
    const auto end_in = [&](const std::string& campaign, const std::string& output) {
      options.campaign = campaign;
      options.output = output;
      EarlierVerdicts(options, installation, never).end_early(mistake, exit_usage);
    };
    for (const std::string& one : outputs)
      if (const std::string place = one.substr(one.starts_with("=")); fs::is_directory(place))
        end_in(names.empty() ? "" : names.front(), place);
    if (!words("--output").empty()) continue;
    for (const std::string& one : names) end_in(one, "");
    if (options.all) end_in("", "");
  }
}

}  // namespace slosh
