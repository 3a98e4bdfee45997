#include "verification/case/row_kind.hpp"

namespace slosh {

RowKind read_row_kind(const TomlTable& row) {
  if (!row.has("kind")) return RowKind::validation;
  const std::string given =
      row.choice("kind", "what the limit comes from",
                 {kind_name(RowKind::validation), kind_name(RowKind::regression)});
  return given == kind_name(RowKind::regression) ? RowKind::regression : RowKind::validation;
}

std::string kind_name(RowKind kind) {
  return kind == RowKind::regression ? "regression" : "validation";
}

}  // namespace slosh
