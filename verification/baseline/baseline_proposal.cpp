#include "verification/baseline/baseline_proposal.hpp"

#include <nlohmann/json.hpp>

#include "verification/baseline/baseline_json.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"

namespace slosh {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements) {
  std::vector<BaselineChange> changes;
  for (const RowMovement& movement : movements) {
    const bool lost = !movement.after && movement.declared;
    if (movement.has_changed() && !lost)
      changes.push_back({movement.row, movement.before, movement.after});
  }
  return changes;
}

void write_proposal(const Proposal& proposal, const fs::path& file) {
  const Json content{{"campaign", proposal.campaign}, {"changes", json_of(proposal.changes)}};
  try {
    replace_file(file, content.dump(2) + "\n", Durability::process_crash);
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

Proposal read_proposal(const fs::path& file) {
  if (!fs::exists(file))
    throw LedgerError(file.string() +
                      ": there is no proposal; expected one by `slosh baseline propose`");
  try {
    const Json content = Json::parse(read_bytes(file));
    return {content.at("campaign"), changes_from(content.at("changes"))};
  } catch (const Json::exception& error) {
    throw LedgerError(file.string() + ": not a proposal: " + error.what());
  } catch (const fs::filesystem_error& error) {
    throw LedgerError(error.what());
  }
}

}  // namespace slosh
