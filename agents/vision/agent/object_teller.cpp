#include "agents/vision/agent/object_teller.hpp"

namespace pizarra::vision {

Task<void> ObjectTeller::tell(std::vector<Datum> facts) {
  Transaction transaction;
  facts_.retract_all(transaction, "to-accept"_sym, 2);
  facts_.retract_all(transaction, "look-alike"_sym, 4);
  facts_.retract_all(transaction, "objects-damaged"_sym, 3);
  facts_.retract_all(transaction, "searched-in"_sym, 5);
  facts_.retract_all(transaction, "looked-at-most"_sym, 2);
  facts_.add(transaction, facts);
  co_await facts_.transact(std::move(transaction));
}

Task<void> ObjectTeller::follow_found(Renames renames, const LearnedObjects& objects) {
  const Result<std::vector<Fact>> standing = co_await facts_.standing("found"_sym, 7);
  if (!standing) co_return;
  Transaction transaction;
  std::vector<Datum> renamed;
  for (const Fact& fact : *standing) {
    const Datum found = as_said(fact.datum);
    std::vector<Datum> items(found.items().begin(), found.items().end());
    bool gone = false;
    for (Datum* name : {&items[1], &items[4]}) {
      // Where nothing came near there is no second.
      if (name->text().empty()) continue;
      const LearnedObject* object = objects.find(name_now(renames, std::string(name->text())));
      gone = gone || object == nullptr;
      if (object != nullptr) *name = to_datum(object->name);
    }
    Datum now = Datum::list(std::move(items));
    if (!gone && now == found) continue;
    transaction.retract(fact.datum);
    if (!gone) renamed.push_back(std::move(now));
  }
  facts_.add(transaction, renamed);
  co_await facts_.transact(std::move(transaction));
}

}  // namespace pizarra::vision
