// Who serves whom: what the prompt says of roles, and changes in them.

#include <fmt/format.h>

#include "agents/repl/commands.hpp"
#include "agents/runtime/declared.hpp"
#include "agents/runtime/roles.hpp"
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

}  // namespace

Task<std::string> Interpreter::serving(runtime::Role role) {
  const std::string usual = role.usual;
  const Result<runtime::Holder> holder = co_await runtime::holder_of(context_.board, every_prompt, std::move(role));
  co_return holder ? holder->server : usual;
}

Task<Result<std::string>> Interpreter::present_coordinator(std::string needed_for) {
  runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> holder = co_await runtime::present_holder_of(context_, every_prompt, std::move(role));
  if (!holder) co_return fail(holder);
  if (holder->is_present()) co_return holder->server;
  co_return fail("absent", fmt::format("no coordinator is present, so nobody {}; (agents) shows who is", needed_for));
}

Task<Evaluation> Interpreter::wire(Datum form) {
  if (form.size() == 1) {
    const Evaluation listed = co_await list_wiring();
    co_return listed;
  }
  if (form.size() < 3 || form.size() > 4) co_return usage("wire");
  for (const Datum& word : form.items()) {
    if (!word.is_symbol() || word.text().starts_with('?')) co_return usage("wire");
  }
  const Result<Datum> standing = co_await role_of(form[1], form[2]);
  if (!standing) co_return show(standing.error(), Evaluation::failed);
  // A board where nobody but prompts is served has it from here.
  std::vector<Relation> relations = runtime::role_relations();
  const Result<void> declared = co_await context_.board.declare(std::move(relations));
  if (!declared) co_return show(declared.error());
  if (form.size() == 3) {
    const Result<Revision> retracted = co_await context_.board.retract(pattern("wired", form[1], form[2], 1));
    if (!retracted) co_return show(retracted.error());
    say("the usual one serves again", fmt::format("{{\"revision\":{}}}", *retracted));
    co_return Evaluation::done;
  }
  const Result<std::string> remark = co_await remark_on_server(form[3], (*standing)[3]);
  if (!remark) co_return show(remark.error(), Evaluation::failed);
  const Datum wired = list("wired"_sym, form[1], form[2], form[3]);
  const Result<Revision> told = co_await context_.board.tell(wired);
  if (!told) co_return show(told.error());
  say(fmt::format("{} serves {} as {}{}", form[3].text(), form[1].text(), form[2].text(), *remark),
      fmt::format("{{\"client\":{},\"role\":{},\"server\":{},\"revision\":{}}}", json_string(form[1].text()),
                  json_string(form[2].text()), json_string(form[3].text()), *told));
  co_return Evaluation::done;
}

Task<Evaluation> Interpreter::list_wiring() {
  const Result<std::vector<Datum>> all = co_await holders();
  if (!all) co_return show(all.error());
  for (const Datum& holder : *all) output_(wiring_text(holder));
  co_return Evaluation::done;
}

Task<Result<std::vector<Datum>>> Interpreter::holders() {
  const Result<std::vector<Fact>> told =
      co_await runtime::facts_if_declared(context_.board, read_pattern("(holder ? ? ? ?)"));
  if (!told) co_return fail(told);
  std::vector<Datum> all;
  for (const Fact& holder : *told) all.push_back(holder.datum);
  const runtime::Role role = runtime::coordinator_role();
  const Result<runtime::Holder> ours = co_await runtime::holder_of(context_.board, every_prompt, role);
  if (!ours) co_return fail(ours);
  all.push_back(list("holder"_sym, Datum::symbol(every_prompt), Datum::symbol(role.name), Datum::symbol(ours->server),
                     Datum::symbol(ours->state)));
  co_return all;
}

// The (holder CLIENT ROLE SERVER STATE) that is meant, or what is near it.
Task<Result<Datum>> Interpreter::role_of(Datum client, Datum role) {
  const Result<std::vector<Datum>> all = co_await holders();
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
Task<Result<std::string>> Interpreter::remark_on_server(Datum server, Datum present) {
  const Result<std::vector<Fact>> agents = co_await context_.board.facts(read_pattern("(agent ? ? ?)"));
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

}  // namespace pizarra::repl
