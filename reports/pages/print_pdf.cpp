#include "reports/pages/print_pdf.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <boost/process.hpp>
#include <system_error>
#include <thread>
#include <vector>

#include "reports/model/report_files.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {
namespace {

namespace fs = std::filesystem;
namespace process = boost::process;

boost::filesystem::path browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (auto found = process::search_path(name); !found.empty()) return found;
  return {};
}

std::vector<std::string> arguments(const fs::path& page, const fs::path& profile,
                                   const fs::path& pdf) {
  std::vector<std::string> list{"--headless",
                                "--disable-gpu",
                                "--disable-background-networking",
                                "--disable-component-update",
                                "--disable-sync",
                                "--no-first-run",
                                "--no-pdf-header-footer",
                                "--generate-pdf-document-outline",
                                "--user-data-dir=" + profile.string(),
                                "--print-to-pdf=" + pdf.string(),
                                page.string()};
  if (geteuid() == 0) list.insert(list.begin(), "--no-sandbox");  // root needs it
  return list;
}

// Returns the exit status. All processes that the browser started end with it.
int run_browser(const std::vector<std::string>& list, const fs::path& log,
                std::chrono::seconds limit) {
  process::group group;
  std::error_code failure;
  process::child child(
      browser(), process::args(list), group, failure,
      process::std_in<process::null, (process::std_out & process::std_err)> log.string());
  if (failure) throw ReportError("the browser did not start: " + failure.message());
  const auto end = std::chrono::steady_clock::now() + limit;
  while (child.running()) {
    if (std::chrono::steady_clock::now() > end) {
      group.terminate();
      throw ReportError(
          fmt::format("the browser has not printed the report within {} s", limit.count()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  std::error_code over;
  group.terminate(over);
  return child.exit_code();
}

}  // namespace

bool can_print_pdf() { return !browser().empty(); }

std::string no_browser_message() {
  return "chromium, which prints the report to PDF, is not on the PATH (Debian: apt-get install "
         "chromium)";
}

void print_pdf(const std::string& html, const fs::path& scratch, const fs::path& pdf,
               std::chrono::seconds limit) {
  if (!can_print_pdf()) throw ReportError(no_browser_message());
  const fs::path page = scratch / "whole.html", log = pdf.string() + ".log";
  write_text(page, html);
  const int status = run_browser(arguments(page, scratch / "profile", pdf), log, limit);
  if (status != 0)
    throw ReportError(fmt::format("the browser ended with status {} instead of a PDF", status));
  std::error_code none;
  if (fs::file_size(pdf, none) == 0 || none || read_text(pdf).substr(0, 5) != "%PDF-")
    throw ReportError("the browser left no PDF");
  fs::remove(log);
}

}  // namespace slosh::reports
