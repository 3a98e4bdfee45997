#include "verification/cli/campaign/earlier_verdicts.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "reports/pages/report_documents.hpp"
#include "reports/summary/recorded_campaigns.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char *gate_folder = "gate", *report_folder = "report", *page_name = "index.html",
                     *data_name = "results.json";

reports::GateDocument superseded_gate(const std::string& campaign, int status,
                                      const std::string& why) {
  return {.title = campaign,
          .verdict = headline_word(exit_not_compared) + ": " + why,
          .entries = {bare_entry(campaign, "the campaign", reports::GateOutcomeKind::not_compared,
                                 why)},
          .exit_status = status};
}

// The exit status that the texts of a folder tell; nullopt where none does.
std::optional<int> told_status(const fs::path& file, const std::string& text) try {
  if (file.filename() == gate_page_name) return reports::exit_status_in(text);
  if (file.filename() == data_name) return recorded_campaign(text, "").exit_status;
  return std::nullopt;
} catch (const std::invalid_argument&) {
  return std::nullopt;
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
      if (!foreign_at(file)) place.texts[file] = read_bytes(file);
    } catch (const fs::filesystem_error&) {  // there is none, or a device
    }
  return place;
}

EarlierVerdicts::EarlierVerdicts(const CampaignOptions& options, const Installation& installation)
    : campaign_(options.all ? "all campaigns" : options.campaign) {
  places_.push_back(read(known_place(options, installation)));
  if (options.selection.is_partial())
    places_.push_back(read(places_.front().directory.parent_path()));
}

void EarlierVerdicts::supersede(const Place& place, const char* folder, int status,
                                const std::string& why) const {
  const fs::path directory = place.directory / folder;
  std::vector<fs::path> files;
  for (const auto& [file, text] : place.texts)
    if (file.parent_path() == directory) files.push_back(file);
  if (files.empty()) return;
  try {
    if (folder == std::string(gate_folder))
      return write_gate_files(superseded_gate(campaign_, status, why), directory);
    const reports::Report report = superseded_report(campaign_, status, why);
    replace_own(directory / data_name, report.results_json);
    replace_own(directory / page_name, reports::html_pages(report, {}).front().text);
  } catch (const fs::filesystem_error&) {  // no room: an old verdict must not stay for that
    for (const fs::path& file : files)
      if (fs::is_regular_file(file)) fs::remove(file);
    throw;
  }
}

void EarlierVerdicts::begin(const std::vector<std::string>& written) {
  const Place& own = places_.front();
  for (const char* folder : {gate_folder, report_folder}) require_no_input(own.directory / folder);
  for (const std::string& output : written) require_own(own.directory / output);
  end_early("the start has not come to its verdict");
  for (const Place& place : places_) left_.push_back(read(place.directory));
}

void EarlierVerdicts::end_early(const std::string& why) const {
  for (const Place& place : places_)
    for (const char* folder : {gate_folder, report_folder})
      supersede(place, folder, exit_not_compared, why);
}

std::optional<int> EarlierVerdicts::told(const Place& place, const char* folder) {
  std::optional<int> found;
  for (const auto& [file, text] : place.texts)
    if (file.parent_path().filename() == folder)
      if (const auto one = told_status(file, text)) found = one;
  return found;
}

void EarlierVerdicts::put_back(std::size_t place, const char* folder) const {
  std::map<fs::path, std::string> now = read(places_[place].directory).texts,
                                  left = left_[place].texts;
  for (const auto& [file, text] : places_[place].texts)
    if (file.parent_path().filename() == folder && now[file] == left[file]) replace_own(file, text);
}

void EarlierVerdicts::end(const char* folder, int status) const {
  const std::string why = fmt::format("a later start has ended with exit status {}", status);
  const bool has_failed = is_worse_status(status, exit_not_compared);
  for (std::size_t whole = 1; whole < places_.size(); ++whole)
    for (const char* one : {gate_folder, report_folder})
      if (has_failed && is_worse_status(status, told(places_[whole], one).value_or(exit_pass)))
        supersede(places_[whole], one, status, why);
      else
        put_back(whole, one);
  const std::optional<int> before = told(places_.front(), folder);
  if (!before || is_worse_status(status, *before))
    return supersede(places_.front(), folder, has_failed ? status : exit_not_compared, why);
  put_back(0, folder);
}

int superseding(const CampaignOptions& options, const Installation& installation,
                const std::function<int(EarlierVerdicts&)>& start) {
  EarlierVerdicts earlier(options, installation);
  try {
    return start(earlier);
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception& error) {
    earlier.end_early(error.what());
    throw;
  }
}

void supersede_for_mistake(const CLI::App& app, const Installation& installation,
                           const std::string& mistake) {
  for (const char* name : {"campaign", "gate", "report"}) {
    const CLI::App& command = *app.get_subcommand(name);
    if (!command.parsed()) continue;
    const auto words = [&](const char* option) { return command.get_option(option)->results(); };
    CampaignOptions options;
    options.selection.quick = command.get_option("--quick")->count() > 0;
    options.selection.only = words("--only");
    options.selection.tags = words("--tag");
    options.all = command.get_option_no_throw("--all") && command.get_option("--all")->count() > 0;
    // The words that the parser could not place may be the output or the campaign.
    std::vector<std::string> outputs = words("--output"), names = words("name");
    for (const std::string& one : app.remaining(true)) {
      outputs.push_back(one.substr(one.find('=') + 1));
      if (!one.starts_with("-")) names.push_back(one);
    }
    const auto end_in = [&](const std::string& campaign, const std::string& output) {
      options.campaign = campaign;
      options.output = output;
      EarlierVerdicts(options, installation).end_early(mistake);
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
