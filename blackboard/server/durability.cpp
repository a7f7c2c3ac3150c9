#include "blackboard/server/durability.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

namespace {

bool is_durable(const store::Store& store, const Datum& pattern) {
  const auto table = store.tables().find(pattern.head());
  return table != store.tables().end() && table->second.relation().durable;
}

bool step_is_durable(const store::Store& store, const Datum& step) {
  if (step.size() < 2) return false;
  if (!step.is_form("settle")) return is_durable(store, step[1]);
  const Fact* held = store.held(wire::count_from(step[1]).value_or(0));
  return held != nullptr && is_durable(store, held->datum);
}

// Whether a query has a durable relation in any of its clauses.
bool asks_durable(const store::Store& store, const Datum& query) {
  const bool is_made_of_others = query.is_form("and") || query.is_form("not") || query.is_form("query");
  if (!is_made_of_others) return is_durable(store, query);
  return std::ranges::any_of(query.items(), [&](const Datum& part) { return asks_durable(store, part); });
}

bool declares_durable(const Datum& relation) {
  return std::ranges::any_of(relation.items(), [](const Datum& part) { return part.is_form("durable"); });
}

// Whether nothing stands after it that did not stand before.
bool only_removes(const Datum& body) {
  const auto removes = [](const Datum& step) { return step.is_form("retract") || step.is_form("settle"); };
  return body.is_form("transact") && body.size() > 2 && std::ranges::all_of(body[2].items(), removes);
}

// What the journal says beside the request: when and who, and its reply.
constexpr std::size_t said_beside = 512;
// " (retract 18446744073709551615)"
constexpr std::size_t bytes_of_a_removal = 31;

// Of the line, and of the reply that is remembered with it: that to a `take` has the fact.
std::size_t bytes_at_most(const Datum& body) {
  if (body.is_form("take")) return limits::frame_bytes + said_beside;
  // Of each fact that is told its id, and the one that it replaces.
  constexpr std::size_t bytes_of_a_step = 3 * bytes_of_a_removal;
  const std::size_t steps = body.is_form("transact") && body.size() > 2 ? body[2].size() : 0;
  return weigh(body).bytes + steps * bytes_of_a_step + said_beside;
}

std::size_t removed_at_most(const store::Store& store, const Transaction& transaction) {
  std::size_t removed = 0;
  for (const Transaction::Step& step : transaction.steps) {
    const auto* retract = std::get_if<Transaction::Retract>(&step);
    if (retract == nullptr) continue;
    const auto table = store.tables().find(retract->pattern.head());
    const bool known = table != store.tables().end() && check_pattern_shape(table->second.relation(), retract->pattern);
    if (known) removed += std::min(table->second.candidates(retract->pattern), table->second.size());
  }
  return removed;
}

}  // namespace

Durability::Durability(journal::JournalWriter* journal, Send send, bool of_all)
    : journal_(journal), send_(std::move(send)), of_all_(of_all) {
  if (journal_ != nullptr) journal_->on_progress = [this] { progress(); };
}

Durability::~Durability() {
  if (journal_ != nullptr) journal_->on_progress = nullptr;
}

bool Durability::concerns_durable(const store::Store& store, const Datum& body) const {
  if (journal_ == nullptr || body.size() < 2) return false;
  if (body.is_form("take")) return is_durable(store, body[1]);
  if (body.is_form("declare")) return std::ranges::any_of(body.items(), declares_durable);
  if (!body.is_form("transact") || body.size() < 3) return false;
  return std::ranges::any_of(body[2].items(), [&](const Datum& step) { return step_is_durable(store, step); });
}

Durability::Position Durability::awaited(const store::Store& store, const Datum& body, bool durable) const {
  if (has_all()) return 0;
  if (durable || of_all_) return position();
  // A board whose journal cannot be written answers all the same.
  const bool is_under_way = last_change_ > journal_->kept() && !journal_->stuck();
  const bool shows_change = is_under_way && body.is_form("ask") && body.size() > 1;
  return shows_change && asks_durable(store, body[1]) ? last_change_ : 0;
}

Result<Durability::Before> Durability::begin(const store::Store& store, const Datum& body) const {
  const Before before{concerns_durable(store, body), position()};
  const bool changes = body.is_form("take") || body.is_form("transact") || body.is_form("declare");
  const Result<void> room = changes ? check_room(body, before.durable, 0) : Result<void>();
  if (!room) return fail(room);
  return before;
}

Durability::After Durability::end(const store::Store& store, const Datum& body, const Before& before) {
  const bool changed = before.durable && position() > before.journal_end;
  if (changed) last_change_ = position();
  return {changed, awaited(store, body, before.durable)};
}

Result<void> Durability::check_room(const store::Store& store, const Datum& body,
                                    const Transaction& transaction) const {
  const std::size_t removals = journal_ == nullptr ? 0 : removed_at_most(store, transaction);
  // More than may be looked at is the board's to refuse.
  if (removals == 0 || removals > limits::examined) return {};
  return check_room(body, concerns_durable(store, body), removals);
}

Result<void> Durability::check_room(const Datum& body, bool durable, std::size_t removals) const {
  if (journal_ == nullptr) return {};
  const Change change = change_of(body, durable);
  // Weighing takes its time, and there is room as a rule.
  const std::size_t named = removals * bytes_of_a_removal;
  const Result<void> room = journal_->check_room(change, limits::frame_bytes + said_beside + named);
  return room ? room : journal_->check_room(change, bytes_at_most(body) + named);
}

Durability::Change Durability::change_of(const Datum& body, bool durable) {
  if (!durable) return Change::passing;
  return only_removes(body) ? Change::removing : Change::lasting;
}

void Durability::hold(wire::SessionId session, wire::RequestId request, Reply reply) {
  held_.push_back({session, request, std::move(reply)});
  journal_->keep();
}

void Durability::answer_again(wire::SessionId session, wire::RequestId request, const Reply& reply) const {
  if (journal_ == nullptr || reply.after <= journal_->kept()) return send_(session, reply.text);
  if (journal_->stuck()) send_(session, in_doubt(request, reply));
}

void Durability::progress() {
  std::string frame;
  std::size_t in_frame = 0;
  while (!held_.empty() && held_.front().reply.after <= journal_->kept()) {
    const Held held = std::move(held_.front());
    held_.pop_front();
    frame += held.reply.text;
    const Held* next = held_.empty() ? nullptr : &held_.front();
    const bool goes_on = next != nullptr && next->session == held.session && next->reply.after <= journal_->kept() &&
                         frame.size() + next->reply.text.size() <= wire::bytes_together;
    if (goes_on && ++in_frame < wire::most_messages) continue;
    send_(held.session, frame);
    frame.clear();
    in_frame = 0;
  }
  if (!journal_->stuck()) return;
  for (const Held& held : std::exchange(held_, {})) send_(held.session, in_doubt(held.request, held.reply));
}

std::string Durability::in_doubt(wire::RequestId request, const Reply& reply) const {
  if (!reply.stands) return reply.text;
  const Result<Datum> answered = wire::read_frame(reply.text);
  const Datum value = answered ? (*answered)[2][1] : Datum();
  const Failure failure{"not-durable",
                        "it stands on the board, so do not repeat it, but it goes with the board that ends before it "
                        "can be written: " +
                            journal_->failure()->sentence,
                        value,
                        {}};
  return write(list("reply"_sym, request, failure_to_datum(failure)));
}

}  // namespace pizarra::server
