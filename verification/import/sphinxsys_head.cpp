// SPHinXsys' files of observed and reduced quantities (io_observation.h, io_plt.cpp): names in
// quotes, blanks between, the first "run_time" in s; a program that is restarted writes its head
// again, which is refused where it stands.
#include "verification/import/table_head.hpp"

namespace slosh {

TableHead read_sphinxsys_head(TableReader& reader) {
  TableHead head;
  for (std::string_view name : fields_of(reader.line(), ' ')) {
    if (name.starts_with('"')) name.remove_prefix(1);
    if (name.ends_with('"')) name.remove_suffix(1);
    head.columns.push_back({std::string(name), head.columns.empty() ? "s" : ""});
  }
  if (head.columns.size() < 2 || head.columns[0].name != "run_time")
    reader.refuse("head", reader.line(), "\"run_time\" and more, as SPHinXsys writes");
  reader.next();
  return head;
}

}  // namespace slosh
