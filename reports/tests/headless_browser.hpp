// Measures a page as headless Chromium shows it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace slosh::reports {

struct BrowserRun {
  nlohmann::json phone, desk;  // what the page measures at either width (headless_browser.cpp)
  std::string log;             // holds "CONSOLE" where a script or a resource failed
};

bool browser_is_installed();

// Opens the page, whose path is relative to the directory, for at most five seconds of its own
// clock. The browser's own files stay there. Throws std::runtime_error if the browser does not
// answer within a minute.
BrowserRun open_in_browser(const std::filesystem::path& directory, const std::string& page,
                           bool dark);

// What no page may have at either width, each with its measure: text that is cut off, overlaps, is
// too small or too faint, figures and tables that do not fit or lack a name, links and ids that
// lead nowhere or stand twice, no way by keyboard. Empty where nothing is wrong.
std::vector<std::string> faults_of(const BrowserRun& run);

// Whether levels of headings start at the first and skip none on the way down.
bool in_order(const std::vector<int>& levels);

}  // namespace slosh::reports
