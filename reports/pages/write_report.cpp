#include "reports/pages/write_report.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "reports/model/report_files.hpp"
#include "reports/pages/check_report.hpp"
#include "reports/pages/draw_report.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/templates.hpp"
#include "verification/files/own_files.hpp"

namespace slosh::reports {
namespace {

namespace fs = std::filesystem;

void write_files(const Report& report, const Drawings& drawings, const fs::path& directory) {
  for (const HtmlFile& file : html_pages(report, drawings))
    write_text(directory / file.name, file.text);
  for (const Section& section : report.sections)
    for (const Table& table : section.tables)
      if (rows_on_page(table) < table.rows.size()) {
        fs::create_directories(directory / "tables");
        write_text(directory / table_file(table), csv_of(table));
      }
  write_text(directory / "results.json", report.results_json);
  write_text(directory / "results.schema.json", results_schema);
}

// Renames the complete report to the target in one step if the file system can, else in two. An old
// report goes to `aside` or to the complete one's former name.
void swap_in(const fs::path& complete, const fs::path& target, const fs::path& aside) {
  const bool replaces = fs::exists(target);
  const unsigned flags = replaces ? RENAME_EXCHANGE : 0;
  if (renameat2(AT_FDCWD, complete.c_str(), AT_FDCWD, target.c_str(), flags) == 0) return;
  if (!replaces || (errno != EINVAL && errno != ENOSYS)) {
    throw ReportError("cannot rename " + complete.string() + " to " + target.string() + ": " +
                      std::strerror(errno));
  }
  fs::rename(target, aside);
  try {
    fs::rename(complete, target);
  } catch (const fs::filesystem_error&) {
    fs::rename(aside, target);
    throw;
  }
}

}  // namespace

void write_report(const Report& given, const fs::path& directory, const WriteOptions& options) try {
  check_report(given);
  const Report report = with_legible_figures(given);
  // The path is made absolute and loses a trailing slash, so that the temporary directory is beside
  // the target.
  fs::path target = fs::absolute(directory).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  require_own(target);
  if (fs::exists(target) && !fs::is_directory(target))
    throw ReportError("cannot write a report to " + target.string() + ": it is a file");
  fs::create_directories(target.parent_path());
  const TemporaryDirectory temporary(target.string() + ".writing-");
  const fs::path complete = temporary.path() / "report";
  const fs::path scratch = temporary.path() / "drawing";
  fs::create_directory(scratch);
  fs::create_directories(complete / "figures");
  const Drawings drawings =
      draw_report(report, options.threads, options.gnuplot, scratch, complete / "figures");
  write_files(report, drawings, complete);
  list_all_in(complete);
  swap_in(complete, target, temporary.path() / "old");
} catch (const fs::filesystem_error& error) {
  throw ReportError(
      fmt::format("cannot write the report {}: {}", directory.string(), error.what()));
}

}  // namespace slosh::reports
