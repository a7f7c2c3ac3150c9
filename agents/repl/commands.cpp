#include "agents/repl/commands.hpp"

namespace pizarra::repl {

std::span<const Command> Command::all() {
  static constexpr Command commands[] = {
      {"goal", "(goal FACT ...)", "build it: (goal (on circle triangle) (on triangle square))", &Interpreter::goal},
      {"cancel", "(cancel)", "give the goal up", &Interpreter::cancel},
      {"plan", "(plan)", "the plan in use and the operation in hand", &Interpreter::plan},
      {"why", "(why) (why PATTERN) (why not GOAL ...)",
       "why the plan is what it is: which sighting broke which expectation; why facts that fit stand; why a goal does "
       "not hold, and what would bring it about",
       &Interpreter::why},
      {"objects", "(objects)", "the learned objects and where they are seen", &Interpreter::objects},
      {"agents", "(agents)", "the agents that are present and what they offer", &Interpreter::agents},
      {"find", "(find KIND CONDITION ...)", "the agents of a kind, by properties: (find robot (reach > 600) (host ?))",
       &Interpreter::find},
      {"bind", "(bind PATH AGENT)",
       "name an agent in the tree of contexts: (bind (cell arms left) robot); the name goes with this prompt",
       &Interpreter::name_agent},
      {"rebind", "(rebind PATH AGENT)", "the same, in place of whoever has the name", &Interpreter::name_agent},
      {"unbind", "(unbind PATH)", "take a name away; an agent binds its own name again", &Interpreter::unbind},
      {"resolve", "(resolve PATH)", "who has a name: (resolve (cell arms robot))", &Interpreter::resolve},
      {"list", "(list PATH)", "the names and contexts in a context: (list (cell arms)); (list) those above all",
       &Interpreter::list_names},
      {"wire", "(wire CLIENT ROLE AGENT)",
       "have another agent serve: (wire coordinator eyes vision-2); without AGENT the usual one, (wire) lists who "
       "serves",
       &Interpreter::wire},
      {"ask", "(ask QUERY)", "the facts that hold now: (ask (on ?x ?y)), (ask (and (clear ?x) (not (on ?x ?y))))",
       &Interpreter::ask},
      {"watch", "(watch QUERY)", "the facts that hold now, then every change", &Interpreter::watch},
      {"unwatch", "(unwatch N)", "end watch N", &Interpreter::unwatch},
      {"declare", "(declare RELATION)",
       "say what facts are called and hold: (declare (relation seen ((name symbol) (x number)) (key name)))",
       &Interpreter::declare},
      {"tell", "(tell FACT)", "put a fact on the board: (tell (stop me \"wait\")) stops the arm", &Interpreter::tell},
      {"retract", "(retract PATTERN)",
       "take every fact that fits off the board: (retract (stop me ?)) lets the arm move again", &Interpreter::retract},
      {"help", "(help) (help COMMAND)", "this list, or one line of it; (help AGENT): what that agent offers",
       &Interpreter::help},
      {"quit", "(quit)", "leave; Ctrl-D or Ctrl-C on an empty line do the same, Ctrl-C after text drops it",
       &Interpreter::quit},
  };
  return commands;
}

}  // namespace pizarra::repl
