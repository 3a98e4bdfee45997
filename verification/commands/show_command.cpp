// The options of show.

#include "verification/show_command.hpp"

#include <memory>

#include "verification/commands/command_tree.hpp"

namespace slosh {

void add_show_command(const CommandTree& tree) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App& command = add_command(
      tree,
      {"show",
       "A picture of a case's histories, of the results that there are",
       {"./slosh run li2010_small_amplitude linear",
        "./slosh show li2010_small_amplitude -o histories.png"}},
      [options, &installation = tree.installation] { return show_case(*options, installation); });
  command
      .add_option("case", options->case_name, "A case of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
  CLI::Option* output =
      command
          .add_option("-o,--output", options->output,
                      "The picture, .png or .svg, or a page of all, .html (default: such a page in "
                      "build/shown, which $BROWSER or xdg-open then shows)")
          ->type_name(file_type);
  command
      .add_option("--quantity", options->quantity,
                  "What the picture is of, as elevation@right (default: the first that the case "
                  "compares)")
      ->needs(output);
  add_experiments_option(command, options->experiments);
  add_shared_store_option(command, options->store, tree.installation);
}

}  // namespace slosh
