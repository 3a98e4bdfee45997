// Prints an HTML document to PDF with headless Chromium.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace slosh::reports {

// Whether there is one on the PATH, under one of the names that it has.
bool can_print_pdf();

// "chromium, which prints the report to PDF, is not on the PATH ..."
std::string no_browser_message();

// No shell; the browser's files go to `scratch`. Throws ReportError where no browser is on the
// PATH, where it fails, leaves no PDF, or is not done within the limit: then what it said is in
// <pdf>.log.
void print_pdf(const std::string& html, const std::filesystem::path& scratch,
               const std::filesystem::path& pdf,
               std::chrono::seconds limit = std::chrono::minutes(5));

}  // namespace slosh::reports
