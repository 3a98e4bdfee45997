#include "verification/baseline/baseline_change.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "verification/files/content_hash.hpp"
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

}  // namespace slosh
