#pragma once

// A process between us and a foreign program, to which everything falls that the program starts, whatever sessions and
// groups it makes: it is their subreaper. It ends as the program ended, when all of them are gone; and it ends them
// when the program has ended, or when the other end of `life` is closed: by us, or by our own end, however sudden.
//
//   const pid_t keeper = fork();
//   if (keeper == 0) keep(life_read_end, [&] { execl("/bin/sh", "sh", "-c", command, nullptr); _exit(127); });

#include <functional>

namespace pizarra::pddl_planner {

// In the child after fork(). `become` turns the program's own process into it.
[[noreturn]] void keep(int life, const std::function<void()>& become);

}  // namespace pizarra::pddl_planner
