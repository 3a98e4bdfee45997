#include "verification/baseline/baseline_json.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json json_of(const std::optional<BaselineValue>& value) {
  if (!value) return nullptr;
  return {{"value", value->value},
          {"half_width_95", value->half_width},
          {"lower", json_of(value->lower)},
          {"upper", json_of(value->upper)}};
}

std::optional<double> number_from(const Json& number) {
  return number.is_null() ? std::optional<double>() : number.get<double>();
}

std::optional<BaselineValue> value_from(const Json& value) {
  if (value.is_null()) return {};
  return BaselineValue{value.at("value").get<double>(), value.at("half_width_95").get<double>(),
                       number_from(value.at("lower")), number_from(value.at("upper"))};
}

}  // namespace

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
    list.push_back({change.at("row"), value_from(change.at("old")), value_from(change.at("new"))});
  return list;
}

}  // namespace slosh
