#include "verification/baseline/baseline_ledger.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/own_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json json_of(const std::optional<BaselineValue>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

std::optional<double> number_from(const Json& number) {
  return number.is_null() ? std::optional<double>() : number.get<double>();
}

std::optional<BaselineValue> optional_value_from(const Json& value) {
  return value.is_null() ? std::optional<BaselineValue>() : value_from(value);
}

}  // namespace

Json json_of(const BaselineValue& value) {
  Json entry{{"value", json_of(value.value)},
             {"half_width_95", value.half_width},
             {"lower", json_of(value.lower)},
             {"upper", json_of(value.upper)}};
  if (value.uncertainty)
    entry["uncertainty_95"] =
        std::isfinite(*value.uncertainty) ? Json(*value.uncertainty) : Json(nullptr);
  if (const auto& terms = value.terms)
    entry["terms"] = {{"kind", terms->kind},         {"window", terms->window},
                      {"inputs", terms->inputs},     {"setup", terms->setup},
                      {"evidence", terms->evidence}, {"measured_with", terms->measured_with},
                      {"tags", terms->tags}};
  return entry;
}

BaselineValue value_from(const Json& value) {
  BaselineValue read{number_from(value.at("value")), value.at("half_width_95").get<double>(),
                     number_from(value.at("lower")), number_from(value.at("upper"))};
  if (value.contains("terms")) {
    const Json& terms = value.at("terms");
    read.terms = {terms.at("kind"),
                  terms.at("window"),
                  terms.at("inputs"),
                  terms.at("setup"),
                  terms.value("evidence", ""),
                  terms.value("measured_with", ""),
                  terms.value("tags", std::vector<std::string>())};
  }
  if (value.contains("uncertainty_95"))
    read.uncertainty =
        number_from(value.at("uncertainty_95")).value_or(std::numeric_limits<double>::infinity());
  return read;
}

Json json_of(const std::vector<BaselineChange>& changes) {
  Json list = Json::array();
  for (const BaselineChange& change : changes)
    list.push_back(
        {{"row", change.row}, {"old", json_of(change.before)}, {"new", json_of(change.after)}});
  return list;
}

std::vector<BaselineChange> changes_from(const Json& changes) {
  std::vector<BaselineChange> list;
  for (const Json& change : changes)
    list.push_back({change.at("row"), optional_value_from(change.at("old")),
                    optional_value_from(change.at("new"))});
  return list;
}

void write_proposal(const Proposal& proposal, const fs::path& file) {
  const Json content{{"campaign", proposal.campaign}, {"changes", json_of(proposal.changes)}};
  try {
    replace_own(file, content.dump(2) + "\n");
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

Proposal read_proposal(const fs::path& file) {
  if (!fs::exists(file))
    throw LedgerError(file.string() +
                      ": there is no proposal; expected one by `slosh baseline propose`");
  try {
    const Json content = parsed_json<Json>(read_bytes(file));
    return {content.at("campaign"), changes_from(content.at("changes"))};
  } catch (const Json::exception& error) {
    throw LedgerError(file.string() + ": not a proposal: " + words_of(error));
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

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
