// The documents in which earlier starts have left their verdicts on a campaign: the gate's files,
// and the first page and the data of the report. None of them outlives a start that comes to no
// verdict or to a worse one.
#pragma once

#include <atomic>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/files/file_lock.hpp"

namespace slosh {

// What a start that writes a report gives begin().
inline const std::vector<std::string> written_pages{"report/index.html", "report/results.json",
                                                    "report/figures/one", "report/tables/one"};

class EarlierVerdicts {
 public:
  // Of the directory that the options name, as far as that is known: the campaign's file may be
  // wrong.
  EarlierVerdicts(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop);

  // Waits for other starts in the output as lock_output(), and replaces the documents that Slosh
  // has left or that carry its mark, for a selection those of the whole campaign too: whatever ends
  // the start leaves no old verdict. `written` are the outputs of this start, by their paths in the
  // directory. Throws as require_room() (files/own_files.hpp) for these, and std::runtime_error
  // with the names of the documents that cannot be replaced.
  void begin(const std::vector<std::string>& written);
  // Notes the exit status of the verdict: from here no error hides a worse one.
  void judged(int status) { judged_ = status; }
  // Replaces them where the start ends by an error with this status, and returns the status with
  // which it ends then.
  int end_early(const std::string& why, int status);
  // Puts back those of a folder that this start has not written, "gate" or "report", unless they
  // say better than its verdict's exit status; and those of the whole campaign, unless a selection
  // has failed and they say better. `asked` is the exit status for which its options ask. Throws as
  // begin().
  void end(const char* folder, int status, int asked);

 private:
  struct Place {
    std::filesystem::path directory;
    std::map<std::filesystem::path, std::string> texts;
  };
  static Place read(const std::filesystem::path& directory);
  // The exit status that the documents of a folder tell; nullopt where none does.
  static std::optional<int> told(const Place& place, const char* folder);
  static void put_back(const Place& place, const char* folder);
  void supersede(const Place& place, const char* folder, int status, const std::string& why);
  void require_superseded();
  bool is_in_use();  // by another start; takes the lock where it is not

  std::string campaign_;
  const std::atomic<bool>& stop_;
  std::filesystem::path output_;
  std::unique_ptr<FileLock> lock_;
  std::vector<Place> places_;  // the start's own, and for a selection that of the whole campaign
  std::map<std::filesystem::path, std::string> complaints_;
  std::optional<int> judged_;
};

// Does what `start` does and returns the same. Ends the earlier verdicts early where it throws.
int superseding(const CampaignOptions& options, const Installation& installation,
                const std::atomic<bool>& stop, const std::function<int(EarlierVerdicts&)>& start);

// Returns the exit status of a command that ends by this error.
int status_of(const std::exception& error, const std::atomic<bool>& stop);

// Does the same for a command line that cannot be read, in every directory and of every campaign
// that one of its words may be. It cannot where the command itself is misspelt.
void supersede_for_mistake(const CLI::App& app, const Installation& installation,
                           const std::string& mistake);

}  // namespace slosh
