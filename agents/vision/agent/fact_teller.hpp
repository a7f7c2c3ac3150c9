#pragma once

// How the vision agent tells: everything under its name and its presence, so that it goes with the agent. Facts that a
// lapsed presence or an absent board took away are lost() until they are told anew. What is told, each teller knows for
// itself: look_teller.hpp, tag_teller.hpp, object_teller.hpp, state_teller.hpp.
//
//   FactTeller facts(context, service);
//   facts.begin_anew();
//   co_await facts.tell({...});
//   if (facts.lost()) ...                             // tell all that lasts again

#include <cstdint>
#include <optional>
#include <vector>

#include "agents/runtime/service.hpp"
#include "agents/vision/database/told_by.hpp"

namespace pizarra::vision {

class FactTeller {
 public:
  // Both outlive it; `service` is there before anything is told.
  FactTeller(runtime::AgentContext& context, const std::optional<runtime::Service>& service)
      : context_(context), service_(service) {}

  bool lost() const { return told_under_ != presence(); }
  // Facts that are told from here on stand under the current presence.
  void begin_anew();
  // Another number each time that what was told before is gone: whoever remembers what it told forgets it then.
  std::uint64_t beginnings() const { return beginnings_; }
  LeaseId presence() const { return service_->presence(); }

  // These as they come, in one transaction.
  Task<void> tell(std::vector<Datum> facts);
  // A transaction with nothing in it is not sent.
  Task<void> transact(Transaction transaction);
  void add(Transaction& transaction, const std::vector<Datum>& facts) const;
  // The agent's own facts of these relations: as many arguments as they may have besides its name.
  void retract_all(Transaction& transaction, Datum relation, std::size_t arguments) const;
  void retract(Transaction& transaction, const Datum& fact) const;
  // What stands of these.
  Task<Result<std::vector<Fact>>> standing(Datum relation, std::size_t arguments);

 private:
  runtime::AgentContext& context_;
  const std::optional<runtime::Service>& service_;
  LeaseId told_under_ = 0;
  std::uint64_t beginnings_ = 0;
};

}  // namespace pizarra::vision
