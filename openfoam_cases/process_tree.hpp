// Ends a child process and all that it has started in turn, which stays in the caller's process
// group: a group of its own would not hear of the user's Ctrl-C.
#pragma once

#include <sys/types.h>

#include <functional>

namespace slosh::openfoam {

// SIGTERM to the child, so that mpirun ends its ranks; what is left of it and of its descendants
// three seconds later gets SIGKILL. `runs` tells whether the child still does, and reaps it.
void end_process_tree(pid_t child, const std::function<bool()>& runs);

}  // namespace slosh::openfoam
