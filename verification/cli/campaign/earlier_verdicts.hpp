// The documents in which earlier starts have left their verdicts on a campaign: the gate's files,
// and the first page and the data of the report. None of them outlives a start that comes to no
// verdict or to a worse one.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verification/cli/campaign/campaign_options.hpp"

namespace slosh {

class EarlierVerdicts {
 public:
  // Reads what is there in the directory that the options name, as far as that is known: the
  // campaign's file may be wrong.
  EarlierVerdicts(const CampaignOptions& options, const Installation& installation);

  // Replaces the documents as soon as the inputs are known, for a selection those of the whole
  // campaign too: whatever ends the start leaves no old verdict. `written` are the outputs of this
  // start, by their paths in the directory; none may be an input or foreign. Throws as
  // require_own() (files/own_files.hpp).
  void begin(const std::vector<std::string>& written);
  // Replaces them where the start ends without a verdict.
  void end_early(const std::string& why) const;
  // Puts back those of a folder that this start has not written, "gate" or "report", unless they
  // say better than its exit status; and those of the whole campaign, unless a selection has failed
  // and they say better. What another start has written meanwhile stays.
  void end(const char* folder, int status) const;

 private:
  struct Place {
    std::filesystem::path directory;
    std::map<std::filesystem::path, std::string> texts;
  };
  static Place read(const std::filesystem::path& directory);
  // The exit status that the documents of a folder tell; nullopt where none does.
  static std::optional<int> told(const Place& place, const char* folder);
  void put_back(std::size_t place, const char* folder) const;
  void supersede(const Place& place, const char* folder, int status, const std::string& why) const;

  std::string campaign_;
  std::vector<Place> places_;     // the start's own, and for a selection that of the whole campaign
  std::vector<Place> left_ = {};  // the same once this start has replaced the documents
};

// Does what `start` does and returns the same. Ends the earlier verdicts early where it throws.
int superseding(const CampaignOptions& options, const Installation& installation,
                const std::function<int(EarlierVerdicts&)>& start);

// Does the same for a command line that cannot be read, in every directory and of every campaign
// that one of its words may be. It cannot where the command itself is misspelt.
void supersede_for_mistake(const CLI::App& app, const Installation& installation,
                           const std::string& mistake);

}  // namespace slosh
