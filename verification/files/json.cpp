#include "verification/files/json.hpp"

template class nlohmann::basic_json<>;
template class nlohmann::basic_json<nlohmann::ordered_map>;
SLOSH_JSON_TEMPLATES(, json)
SLOSH_JSON_TEMPLATES(, ordered_json)
