// Prints an HTML document to PDF with headless Chromium.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace slosh::reports {

// Whether Chromium is on the PATH, under one of its usual names.
bool can_print_pdf();

// "chromium, which prints the report to PDF, is not on the PATH ..."
std::string no_browser_message();

// Starts the browser without a shell and keeps its files in `scratch`. Throws ReportError if no
// browser is on the PATH, or if it fails, writes no PDF, or exceeds the time limit; its messages
// are then in <pdf>.log.
void print_pdf(const std::string& html, const std::filesystem::path& scratch,
               const std::filesystem::path& pdf,
               std::chrono::seconds limit = std::chrono::minutes(5));

}  // namespace slosh::reports
