// Processes that have lost their parent and became children of this process: what a child has
// started and left behind, also in a session of its own (setsid), which no signal to the child's
// process group reaches. prctl(2), PR_SET_CHILD_SUBREAPER.
#pragma once

#include <sys/types.h>

#include <set>

namespace slosh {

// From now on this process adopts what its descendants leave behind; once is enough.
void adopt_orphans();

// The adopted processes: children of this process in another process group, but for `own`, which
// this process has started itself. Reaps those that have ended.
std::set<pid_t> adopted_processes(const std::set<pid_t>& own);

// Ends all of them and what they leave behind in turn with SIGKILL.
void end_adopted_processes(const std::set<pid_t>& own);

}  // namespace slosh
