// Measures a page as headless Chromium shows it.
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

// Opens the page, whose path is relative to the directory. The browser's own files stay in the
// directory. Throws std::runtime_error if the browser does not answer within a minute.
BrowserRun open_in_browser(const std::filesystem::path& directory, const std::string& page,
                           bool dark);

}  // namespace slosh::reports
