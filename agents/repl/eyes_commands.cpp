#include "agents/repl/eyes_commands.hpp"

#include <fmt/format.h>
#include <set>

#include "agents/repl/present_agents.hpp"
#include "agents/repl/role_commands.hpp"
#include "agents/runtime/declared.hpp"

namespace pizarra::repl {

namespace {

// A camera that is not there is known sooner; one that is slow to open need not be waited for.
constexpr Duration longest_opening = 3s;

// Of the facts that fit, and none where the board does not answer.
Task<std::vector<Fact>> facts_of(Board& board, Datum fitting) {
  const Result<std::vector<Fact>> facts = co_await runtime::facts_if_declared(board, std::move(fitting));
  co_return facts.value_or(std::vector<Fact>());
}

// Where the coordinator says that it stands; empty: nowhere.
std::string place_of(std::string_view name, const std::vector<Fact>& places) {
  for (const Fact& place : places) {
    const Datum& at = place.datum;
    if (at[1].text() != name) continue;
    return fmt::format("x {:.0f}  y {:.0f}  z {:.0f} mm, frame {}", at[2].number(), at[3].number(), at[4].number(),
                       at[5].integer());
  }
  return "";
}

// `("name" seen CONFIDENCE (left X Y) ... (range D SPREAD) ...)`, the same `bridged`, or `("name" lost)`
std::string sighting_text(const Datum& sighting, std::int64_t frame) {
  std::string at, away;
  for (const Datum& part : sighting.items()) {
    if (part.size() != 3) continue;
    if (part.is_form("left")) at = fmt::format(" ({:.2f}, {:.2f}) px", part[1].number(), part[2].number());
    if (part.is_form("range")) away = fmt::format(", {:.0f} mm away", part[1].number());
  }
  if (sighting[1].is_symbol("bridged")) return fmt::format("hidden just now, last near{}, frame {}", at, frame);
  if (!sighting[1].is_symbol("seen")) return "not seen";
  return fmt::format("seen{}{}{}, frame {}", at.empty() ? "" : " at", at, away, frame);
}

// What eyes that track it say of it; empty: none track it. Where one sees it the others need not.
std::string seen_by_eyes(std::string_view name, const std::vector<Fact>& looks) {
  std::string text;
  for (const Fact& look : looks) {
    for (const Datum& sighting : look.datum[4].items()) {
      const bool of_it = sighting.size() > 1 && sighting[0].text() == name;
      if (!of_it) continue;
      if (text.empty() || sighting[1].is_symbol("seen")) text = sighting_text(sighting, look.datum[2].integer());
    }
  }
  return text;
}

// A mode belongs to who asked for it, which here is the prompt.
Task<std::vector<Datum>> remarks_on_mode(runtime::AgentContext& context, Datum eyes) {
  const Datum held = list("vision-held"_sym, eyes, Datum::symbol(context.name), "?"_sym);
  const std::vector<Fact> ours = co_await facts_of(context.board, held);
  std::vector<Datum> out;
  if (ours.empty()) co_return out;
  const std::string sentence =
      fmt::format("until this prompt ends; ({} (keep)) lets it go on until somebody ends it", eyes.text());
  out.push_back(Datum::string(sentence));
  co_return out;
}

// Why these eyes have no images though somebody wants them, once that is known; empty: they have, or have no camera.
Task<std::string> why_blind(runtime::AgentContext& context, Datum eyes) {
  const Datum state = list("camera-state"_sym, eyes, "?state"_sym, "?trouble"_sym);
  const std::vector<Fact> cameras = co_await facts_of(context.board, state);
  if (cameras.empty()) co_return "";
  const Datum settled =
      list("and"_sym, state, list("/="_sym, "?state"_sym, "closed"_sym), list("/="_sym, "?state"_sym, "opening"_sym));
  const Time deadline = context.executor.now() + longest_opening;
  Query query = query_from_datum(settled).value();
  const Result<Answer> camera = co_await await_answer(context.board, std::move(query), deadline, context.executor);
  if (!camera) co_return fmt::format("{} has no images yet: its camera is being opened", eyes.text());
  const bool lost = camera->bindings.find("?state")->is_symbol("lost");
  if (!lost) co_return "";
  co_return fmt::format("{} has no images: {}", eyes.text(), camera->bindings.find("?trouble")->text());
}

}  // namespace

Task<Evaluation> list_objects(Prompt& prompt, Typed) {
  const Result<std::vector<Fact>> learned =
      co_await runtime::facts_if_declared(prompt.board, read_pattern("(learned ? ? ? ? ? ? ? ? ?)"));
  if (!learned) co_return prompt.show(learned.error());
  const std::vector<Fact> places = co_await facts_of(prompt.board, read_pattern("(place ? ? ? ? ?)"));
  const std::vector<Fact> looks = co_await facts_of(prompt.board, read_pattern("(look ? ? ? ?)"));
  const std::string coordinator = co_await coordinator_of_prompts(prompt.board);
  const bool pursued = co_await is_present(prompt.board, coordinator);
  if (learned->empty()) prompt.print("nothing has been learned");
  std::set<std::string> said;
  for (const Fact& object : *learned) {
    const std::string name(object.datum[2].text());
    if (!said.insert(name).second) continue;
    std::string where = place_of(name, places);
    if (where.empty()) where = seen_by_eyes(name, looks);
    const std::string to_follow = pursued ? "it is followed from the first goal on"
                                          : fmt::format("({} (track \"{}\")) follows it", object.datum[1].text(), name);
    prompt.print(fmt::format("  {:14} {}", name, where.empty() ? "learned; " + to_follow : where));
  }
  const std::vector<Fact> alike = co_await facts_of(prompt.board, read_pattern("(look-alike ? ? ? ? ?)"));
  for (const Fact& fact : alike) prompt.print(std::string(fact.datum[5].text()));
  const std::vector<Fact> damaged = co_await facts_of(prompt.board, read_pattern("(objects-damaged ? ? ? ?)"));
  for (const Fact& fact : damaged) prompt.print(fmt::format("{}: {}", fact.datum[2].text(), fact.datum[4].text()));
  co_return Evaluation::done;
}

std::optional<Datum> why_failed(const Datum& answer) {
  const bool gives_reason = answer.size() == 3 && answer[0].is_string() && answer[2].is_string();
  if (!gives_reason || !answer[0].text().ends_with(" FAIL)")) return std::nullopt;
  return answer[2];
}

Task<std::vector<Datum>> remarks_on(runtime::AgentContext& context, std::string agent, Datum operation, Datum answer) {
  const bool learns = operation.is_form("learn");
  const bool lasts = operation.is_form("track") || operation.is_form("connect");
  const Datum eyes = Datum::symbol(agent);
  std::vector<Datum> out;
  if (!learns && !lasts) co_return out;
  // Others may have operations of these names, as an arm learns where it stands.
  const std::vector<Fact> are_eyes = co_await facts_of(context.board, list("agent"_sym, eyes, "vision"_sym, "?"_sym));
  if (are_eyes.empty()) co_return out;
  if (lasts) out = co_await remarks_on_mode(context, eyes);
  if (lasts) {
    const std::string blind = co_await why_blind(context, eyes);
    if (!blind.empty()) out.push_back(Datum::string(blind));
  }
  if (!learns || answer.size() != 1) co_return out;
  const Datum& name = operation.items().back();
  const Datum any_alike = list("look-alike"_sym, eyes, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  const std::vector<Fact> alike = co_await facts_of(context.board, any_alike);
  for (const Fact& fact : alike) {
    if (fact.datum[2] == name || fact.datum[3] == name) out.push_back(fact.datum[5]);
  }
  co_return out;
}

}  // namespace pizarra::repl
