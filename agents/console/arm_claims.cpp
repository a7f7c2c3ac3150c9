#include "agents/console/arm_claims.hpp"

#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

const Datum anybody = "?"_sym;

Datum commander(const Datum& robot, const Datum& client) { return list("commander"_sym, robot, client); }

Datum wish(const Datum& robot, const Datum& client) { return list("commander-wanted"_sym, robot, client); }

}  // namespace

Task<void> ArmClaims::declare() {
  const char* const wishes = "(relation commander-wanted ((robot symbol) (client symbol)) (key robot client))";
  const std::vector<Relation> relations(1, relation_from_datum(read_one(wishes).value()).value());
  [[maybe_unused]] const Result<void> declared = co_await board_.facts().declare(relations);
}

void ArmClaims::command(const Datum& form) {
  Transaction transaction;
  transaction.require(Transaction::Absent{commander(form[2], anybody)});
  transaction.tell(commander(form[2], board_.client()), {}, board_.presence());
  change_board(form, std::move(transaction),
               {"in-other-hands", "another has this arm in hand: take it over, or wait", {}, {}});
}

void ArmClaims::take_over(const Datum& form) {
  Transaction transaction;
  transaction.retract(commander(form[2], anybody));
  transaction.tell(commander(form[2], board_.client()), {}, board_.presence());
  change_board(form, std::move(transaction));
}

void ArmClaims::let_go(const Datum& form) {
  Transaction transaction;
  transaction.retract(commander(form[2], board_.client()));
  change_board(form, std::move(transaction));
}

void ArmClaims::ask_for(const Datum& form) {
  Transaction transaction;
  transaction.tell(wish(form[2], board_.client()), {}, board_.presence());
  change_board(form, std::move(transaction));
}

void ArmClaims::ask_no_more(const Datum& form) {
  Transaction transaction;
  transaction.retract(wish(form[2], board_.client()));
  change_board(form, std::move(transaction));
}

void ArmClaims::clear_stops(const Datum& form) {
  Transaction transaction;
  transaction.require(Transaction::Present{commander(anybody, board_.client())});
  transaction.retract(list("stop"_sym, anybody, anybody));
  change_board(form, std::move(transaction),
               {"not-commander", "take an arm in hand first: who clears a stop sets it free", {}, {}});
}

void ArmClaims::change_board(const Datum& form, Transaction transaction, Failure unmet) {
  requests_.change_board(form[1].integer(), board_.facts(), std::move(transaction), std::move(unmet));
}

}  // namespace pizarra::console
