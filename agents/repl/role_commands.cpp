#include "agents/repl/role_commands.hpp"

#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/nearest.hpp"

namespace pizarra::repl {

namespace {

// Prompts come and go, each under a name of its own: as clients of roles they are one.
constexpr const char* every_prompt = "prompt";

std::string wiring_text(const Datum& holder) {
  return fmt::format("  {} {}: {}{}", holder[1].text(), holder[2].text(), holder[3].text(),
                     holder[4].is_symbol("wired") ? "" : fmt::format(" ({})", holder[4].text()));
}

Datum pattern(std::string_view relation, Datum client, Datum role, std::size_t more) {
  std::vector<Datum> items{Datum::symbol(relation), std::move(client), std::move(role)};
  items.resize(3 + more, "?"_sym);
  return Datum::list(std::move(items));
}

// (holder CLIENT ROLE SERVER STATE) of each client, all prompts being one.
Task<Result<std::vector<Datum>>> holders(Board& board) {
  const Result<std::vector<Fact>> told = co_await runtime::facts_if_declared(board, read_pattern("(holder ? ? ? ?)"));
  if (!told) co_return fail(told);
  std::vector<Datum> all;
  for (const Fact& holder : *told) all.push_back(holder.datum);
  const runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> ours = co_await runtime::holder_of(board, every_prompt, role);
  if (!ours) co_return fail(ours);
  all.push_back(list("holder"_sym, Datum::symbol(every_prompt), Datum::symbol(role.name), Datum::symbol(ours->server),
                     Datum::symbol(ours->state)));
  co_return all;
}

Task<Evaluation> list_wiring(Prompt& prompt) {
  const Result<std::vector<Datum>> all = co_await holders(prompt.board);
  if (!all) co_return prompt.show(all.error());
  for (const Datum& holder : *all) prompt.print(wiring_text(holder));
  co_return Evaluation::done;
}

// The (holder CLIENT ROLE SERVER STATE) that is meant, or what is near it.
Task<Result<Datum>> role_of(Board& board, Datum client, Datum role) {
  const Result<std::vector<Datum>> all = co_await holders(board);
  if (!all) co_return fail(all);
  std::vector<std::string> clients, roles;
  for (const Datum& fact : *all) {
    if (fact[1] == client && fact[2] == role) co_return fact;
    clients.emplace_back(fact[1].text());
    if (fact[1] == client) roles.emplace_back(fact[2].text());
  }
  const bool known = !roles.empty();
  const std::string near = nearest_name((known ? role : client).text(), known ? roles : clients);
  const std::string hint = near.empty() ? "; (wire) lists who is served" : fmt::format("; did you mean {}?", near);
  if (known) co_return fail("unknown-role", fmt::format("{} has no role {}{}", client.text(), role.text(), hint), role);
  co_return fail("absent", fmt::format("{} is not served in any role{}", client.text(), hint), client);
}

// A remark on a server that is to take over from this one. A server that is not there yet serves when it comes.
Task<Result<std::string>> remark_on_server(Board& board, Datum server, Datum present) {
  const Result<std::vector<Fact>> agents = co_await board.facts(read_pattern("(agent ? ? ?)"));
  if (!agents) co_return fail(agents);
  std::string kind, wanted;
  for (const Fact& agent : *agents) {
    if (agent.datum[1] == server) kind = agent.datum[2].text();
    if (agent.datum[1] == present) wanted = agent.datum[2].text();
  }
  if (kind.empty()) co_return fmt::format(" once it is there: no agent {} is present", server.text());
  if (wanted.empty() || kind == wanted) co_return std::string();
  co_return fail("wrong-kind",
                 fmt::format("{} is of kind {}, and {} of kind {}", server.text(), kind, present.text(), wanted),
                 server);
}

}  // namespace

Task<std::string> coordinator_of_prompts(Board& board) {
  runtime::Role role = runtime::coordinator_role();
  const std::string usual = role.usual;
  const Result<runtime::Holder> holder = co_await runtime::holder_of(board, every_prompt, std::move(role));
  co_return holder ? holder->server : usual;
}

Task<Result<std::string>> present_coordinator(runtime::AgentContext& context, std::string needed_for) {
  runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> holder = co_await runtime::present_holder_of(context, every_prompt, std::move(role));
  if (!holder) co_return fail(holder);
  if (holder->is_present()) co_return holder->server;
  co_return fail("absent", fmt::format("no coordinator is present, so nobody {}; (agents) shows who is", needed_for));
}

Task<Evaluation> wire(Prompt& prompt, Typed typed) {
  if (typed.form.size() == 1) {
    co_return co_await list_wiring(prompt);
  }
  if (typed.form.size() < 3 || typed.form.size() > 4) co_return prompt.misused(typed);
  for (const Datum& word : typed.form.items()) {
    if (!word.is_symbol() || word.text().starts_with('?')) co_return prompt.misused(typed);
  }
  const Result<Datum> standing = co_await role_of(prompt.board, typed.form[1], typed.form[2]);
  if (!standing) co_return prompt.show(standing.error(), Evaluation::failed);
  // A board where nobody but prompts is served has it from here.
  std::vector<Relation> relations = runtime::role_relations();
  const Result<void> declared = co_await prompt.board.declare(std::move(relations));
  if (!declared) co_return prompt.show(declared.error());
  if (typed.form.size() == 3) {
    const Result<Revision> retracted = co_await prompt.board.retract(pattern("wired", typed.form[1], typed.form[2], 1));
    if (!retracted) co_return prompt.show(retracted.error());
    prompt.say("the usual one serves again", fmt::format("{{\"revision\":{}}}", *retracted));
    co_return Evaluation::done;
  }
  const Result<std::string> remark = co_await remark_on_server(prompt.board, typed.form[3], (*standing)[3]);
  if (!remark) co_return prompt.show(remark.error(), Evaluation::failed);
  const Datum wired = list("wired"_sym, typed.form[1], typed.form[2], typed.form[3]);
  const Result<Revision> told = co_await prompt.board.tell(wired);
  if (!told) co_return prompt.show(told.error());
  prompt.say(
      fmt::format("{} serves {} as {}{}", typed.form[3].text(), typed.form[1].text(), typed.form[2].text(), *remark),
      fmt::format("{{\"client\":{},\"role\":{},\"server\":{},\"revision\":{}}}", json_string(typed.form[1].text()),
                  json_string(typed.form[2].text()), json_string(typed.form[3].text()), *told));
  co_return Evaluation::done;
}

}  // namespace pizarra::repl
