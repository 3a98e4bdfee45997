#include "verification/baseline/baseline_ledger.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string text_of(const fs::path& file) {
  if (!fs::exists(file)) return "";
  try {
    // As version control of another system checks it out.
    return boost::replace_all_copy(read_bytes(file), "\r\n", "\n");
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

Approval approval_from(const Json& line) {
  return {line.at("campaign"), line.at("when_utc"), line.at("who"), line.at("reason"),
          changes_from(line.at("changes"))};
}

// The content of the head.
struct Head {
  std::size_t lines;
  std::string hash;

  bool operator==(const Head&) const = default;
};

constexpr const char* lock_suffix = ".lock";

fs::path beside(const fs::path& ledger, const char* suffix) {
  return fs::path(ledger.native() + suffix);
}

Head recorded_head(const fs::path& file) {
  try {
    const Json content = parsed_json<Json>(read_bytes(file));
    return {content.at("lines"), content.at("hash")};
  } catch (const Json::exception& error) {
    throw LedgerError(
        fmt::format("{}: not the head of a ledger: {}", file.string(), words_of(error)));
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

void require_recorded(const fs::path& ledger, const Head& found) {
  const fs::path file = head_of(ledger);
  if (!fs::exists(file)) {
    if (found.lines == 0) return;
    throw LedgerError(
        fmt::format("{}: holds {} approvals, but its head {} does not exist; restore "
                    "both from version control",
                    ledger.string(), found.lines, file.string()));
  }
  const Head recorded = recorded_head(file);
  if (recorded != found)
    throw LedgerError(fmt::format(
        "{}: holds {} approvals with the hash {}, but its head {} records {} with the hash {}: the "
        "last lines were altered, added or removed by hand, or an approval was interrupted; "
        "restore both from version control",
        ledger.string(), found.lines, found.hash, file.string(), recorded.lines, recorded.hash));
}

void write_ledger(const fs::path& file, const std::string& text, std::size_t lines) {
  const Json head{{"lines", lines}, {"hash", content_hash(text)}};
  replace_file(file, text, Durability::power_loss);
  replace_file(head_of(file), head.dump() + "\n", Durability::power_loss);
}

std::vector<Approval> approvals_in(const fs::path& file) {
  const std::string text = text_of(file);
  if (!text.empty() && text.back() != '\n')
    throw LedgerError(file.string() + ": the last line is cut off; expected a whole line");
  std::vector<Approval> approvals;
  std::string before;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); before += line + "\n") {
    const std::string place = fmt::format("{}:{}", file.string(), approvals.size() + 1);
    try {
      const Json content = parsed_json<Json>(line);
      if (content.at("previous") != content_hash(before))
        throw LedgerError(place + ": the lines before it have changed since it was added");
      approvals.push_back(approval_from(content));
    } catch (const Json::exception& error) {
      throw LedgerError(fmt::format("{}: not an approval: {}", place, words_of(error)));
    }
  }
  require_recorded(file, {approvals.size(), content_hash(text)});
  return approvals;
}

}  // namespace

fs::path head_of(const fs::path& ledger) { return beside(ledger, ".head"); }

bool holds_approvals(const fs::path& file) {
  return fs::is_regular_file(file) && !fs::is_empty(file);
}

std::vector<Approval> read_ledger(const fs::path& file) try {
  return approvals_in(file);
} catch (const LedgerError&) {
  // An approval may write it at this moment.
  if (!fs::exists(beside(file, lock_suffix))) throw;
  const FileLock alone(beside(file, lock_suffix), telling_once("changes " + file.string()));
  return approvals_in(file);
}

Baseline baseline_of(const std::vector<Approval>& approvals) {
  Baseline baseline;
  for (const Approval& approval : approvals)
    for (const BaselineChange& change : approval.changes) {
      const auto found = baseline.find(change.row);
      const auto standing =
          found == baseline.end() ? std::optional<BaselineValue>() : std::optional(found->second);
      if (standing != change.before)
        throw LedgerError(
            fmt::format("approval of {} by {}: {}: the old value differs from the baseline",
                        approval.when_utc, approval.who, change.row));
      if (change.after)
        baseline[change.row] = *change.after;
      else
        baseline.erase(change.row);
    }
  return baseline;
}

void append_approval(const Approval& approval, const fs::path& file) {
  try {
    const FileLock alone(beside(file, lock_suffix), telling_once("changes " + file.string()));
    std::vector<Approval> approvals = approvals_in(file);
    const std::string before = text_of(file);
    approvals.push_back(approval);
    baseline_of(approvals);
    const Json line{{"campaign", approval.campaign},
                    {"when_utc", approval.when_utc},
                    {"who", approval.who},
                    {"reason", approval.reason},
                    {"changes", json_of(approval.changes)},
                    {"previous", content_hash(before)}};
    write_ledger(file, before + line.dump() + "\n", approvals.size());
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  } catch (const Json::exception&) {  // of texts that are not
    throw LedgerError(file.string() + ": expected the texts of an approval in UTF-8");
  }
}

}  // namespace slosh
