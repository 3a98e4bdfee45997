#include "verification/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "reports/write_report.hpp"
#include "verification/campaign/campaign_report.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/runs/progress_file.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::string gate_line(const CaseAssessment& assessment, const GateOutcome& outcome) {
  return fmt::format("{:<14} {} {} {} {} {}: {}", verdict_name(outcome.verdict),
                     assessment.definition.name, outcome.row.candidate, outcome.row.mode,
                     metric_name(outcome.row.metric), outcome.row.quantity, outcome.message);
}

std::vector<fs::path> definitions_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The interval at which a run tells how far it is; the parent looks five times a second.
constexpr auto progress_interval = std::chrono::milliseconds(200);

Progress progress_writer(const fs::path& file, double end_time) {
  if (file.empty()) return [](double, double) {};
  return [file, end_time, last = std::chrono::steady_clock::time_point{}](double time,
                                                                          double steps) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < progress_interval) return;
    last = now;
    write_progress({time, end_time, steps}, file);
  };
}

}  // namespace

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop) {
  const CampaignDefinition campaign =
      read_campaign(find_campaign(options.campaign, installation.campaigns), installation.cases);
  std::vector<CaseDefinition> cases;
  for (const fs::path& file : campaign.cases) cases.push_back(read_case(file));
  const fs::path output =
      options.output.empty()
          ? installation.build / "campaigns" / (campaign.name + (options.quick ? "-quick" : ""))
          : options.output;
  const CampaignSettings settings{
      fs::absolute(output), installation.executable, installation.openfoam_templates,
      options.quick,        options.solve,           options.at_once};
  std::vector<CaseRuns> runs = run_cases(cases, settings, stop);

  std::vector<CaseAssessment> assessed;
  for (std::size_t i = 0; i < cases.size(); ++i)
    assessed.push_back(assess(cases[i], std::move(runs[i])));
  const fs::path report = settings.output / "report";
  reports::write_report(campaign_report(campaign, options.quick, assessed), report);

  for (const CaseAssessment& one : assessed) {
    for (const auto& [run, status] : one.runs.status)
      if (status.state == RunState::failed)
        std::cerr << one.definition.name << "/" << run << ": " << status.message << "\n";
    for (const GateOutcome& outcome : one.gate) std::cout << gate_line(one, outcome) << "\n";
  }
  std::cout << verdict_sentence(assessed) << "\nreport: " << (report / "index.html").string()
            << "\n";
  return exit_status(assessed);
}

int run_one(const RunOptions& options, const Installation& installation) {
  const CaseDefinition definition = read_case(find_case(options.case_name, installation.cases));
  const auto run = std::find_if(definition.runs.begin(), definition.runs.end(),
                                [&](const RunDefinition& one) { return one.name == options.run; });
  if (run == definition.runs.end()) {
    std::string names;
    for (const RunDefinition& one : definition.runs)
      names += (names.empty() ? "" : ", ") + one.name;
    throw CaseFileError(fmt::format("{}: run = {}: expected one of {}", definition.file.string(),
                                    options.run, names));
  }
  const fs::path file = options.output.empty() ? fs::path(run->name + ".h5") : options.output;
  fs::path work = file;
  work.replace_extension(".work");
  RunSettings settings;
  settings.work_directory = work;
  settings.openfoam_templates = installation.openfoam_templates;
  settings.snapshot_interval = options.snapshot_interval;
  settings.key =
      run_key(definition, *run, installation.executable, installation.openfoam_templates);
  settings.command = repeat_command(definition, *run);
  write_result(execute(definition, *run, settings,
                       progress_writer(options.progress_file, definition.duration)),
               file);
  std::cout << "result: " << file.string() << "\n";
  return exit_pass;
}

int list_definitions(const Installation& installation) {
  std::cout << "campaigns:\n";
  for (const fs::path& file : definitions_in(installation.campaigns)) {
    const CampaignDefinition campaign = read_campaign(file, installation.cases);
    std::cout << fmt::format("  {:<36} {}\n", campaign.name, campaign.title);
  }
  std::cout << "cases:\n";
  for (const fs::path& file : definitions_in(installation.cases)) {
    const CaseDefinition definition = read_case(file);
    std::cout << fmt::format("  {:<36} {}\n", definition.name, definition.title);
    for (const RunDefinition& run : definition.runs) std::cout << "      " << run.name << "\n";
  }
  return exit_pass;
}

}  // namespace slosh
