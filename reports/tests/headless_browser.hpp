// A page as headless Chromium shows it, measured: for the tests that look at reports.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace slosh::reports {

struct BrowserRun {
  nlohmann::json phone, desk;  // what the page measures at either width (headless_browser.cpp)
  std::string log;             // holds "CONSOLE" where a script or a resource failed
};

bool browser_is_installed();

// Opens the page, its path relative to the directory, which is left with the browser's own files
// too. Throws std::runtime_error where the browser has not answered within a minute.
BrowserRun open_in_browser(const std::filesystem::path& directory, const std::string& page,
                           bool dark);

}  // namespace slosh::reports
