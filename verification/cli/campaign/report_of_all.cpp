#include "verification/cli/campaign/report_of_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "reports/pages/write_report.hpp"
#include "reports/summary/recorded_campaigns.hpp"
#include "reports/summary/results_json.hpp"
#include "sph/threads.hpp"
#include "verification/cli/campaign/assessed_campaign.hpp"
#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// The results.json that the campaigns' reports have or should have, in the order of their names.
std::vector<fs::path> results_in(const fs::path& directory) {
  std::vector<fs::path> files;
  if (!fs::is_directory(directory)) return files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (const fs::path report = entry.path() / "report"; fs::exists(report))
      files.push_back(report / "results.json");
  std::sort(files.begin(), files.end());
  return files;
}

int write_report_of_all(const CampaignOptions& options, const Installation& installation,
                        EarlierVerdicts& earlier) {
  const fs::path directory =
      whole(options.output.empty() ? installation.build / "campaigns" : options.output);
  std::vector<RecordedCampaign> campaigns;
  std::vector<std::string> left_out;
  for (const fs::path& file : results_in(directory)) try {
      if (!fs::is_regular_file(file)) throw std::invalid_argument("expected a file");
      campaigns.push_back(recorded_campaign(
          read_input(file), fs::relative(file.parent_path() / "index.html", directory).string()));
    } catch (const std::invalid_argument& error) {
      left_out.push_back(legible_message(file.lexically_relative(directory).string()));
      std::cerr << legible_message(
          fmt::format("{}: {}; `slosh report NAME` writes the campaign's report anew\n",
                      file.string(), error.what()));
    }
  if (campaigns.empty() && left_out.empty())
    throw CaseFileError(fmt::format(
        "--all: expected reports of campaigns, NAME/report/results.json, in {}; `slosh campaign "
        "NAME` leaves one",
        directory.string()));
  earlier.begin(written_pages);
  reports::Report report = report_of_campaigns(campaigns, left_out);
  const int status = exit_status(campaigns, left_out), asked = requested_exit(status, options);
  earlier.judged(status);
  if (asked != status) report.results_json = with_exit_status(asked, report.results_json);
  reports::write_report(report, directory / "report", {.threads = sph::usable_cores()});
  print_lines(fmt::format("{}: {}\nreport: {}\n", headline_word(status), report.verdict,
                          (directory / "report/index.html").string()));
  return asked;
}

}  // namespace

int report_of_all(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop) {
  return superseding(options, installation, stop, [&](EarlierVerdicts& earlier) {
    return write_report_of_all(options, installation, earlier);
  });
}

}  // namespace slosh
