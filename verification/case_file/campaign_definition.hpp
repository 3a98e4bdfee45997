// A campaign: cases that are run, compared, gated and reported together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh {

struct CampaignDefinition {
  std::string name, title, source;
  std::string paper;  // whose printed numbers and errata the report sets beside ours: "li2010",
                      // "zhao2021", or empty
  std::vector<std::filesystem::path> cases;  // case files, in the order of the report
  std::string text;                          // the file as read
  std::filesystem::path file;
};

}  // namespace slosh
