// A page of figures alone, for whoever wants to look at curves and not at verdicts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// One HTML file that needs no network: a title, the figures with their titles and captions, and
// remarks below them. Throws as draw_figure() does.
std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
