#pragma once

// The beliefs on the board: each as itself and as (believed BELIEF), and the places of the objects seen, all under the
// coordinator's presence and because of the look that showed it. It undoes changes that others make to the beliefs.
//
//   teller.start();
//   co_await teller.tell(sightings, change, look.id);      // once a look

#include <map>

#include "agents/coordinator/geometry/sightings.hpp"
#include "agents/coordinator/options.hpp"
#include "agents/coordinator/perceive/beliefs.hpp"
#include "agents/coordinator/plan/task_domain.hpp"
#include "agents/runtime/service.hpp"

namespace pizarra::coordinator {

class BeliefTeller {
 public:
  // Everything outlives it.
  BeliefTeller(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
               const runtime::Service& service, const Beliefs& beliefs)
      : context_(context), options_(options), domain_(domain), service_(service), beliefs_(beliefs) {}

  void start();
  // In one transaction: the places that changed in a look, and the beliefs that came and went with it.
  Task<void> tell(const Sightings& sightings, Beliefs::Change change, FactId look);

 private:
  void add_places(Transaction& transaction, const Sightings& sightings, FactId look);
  void add_beliefs(Transaction& transaction, const Beliefs::Change& change) const;
  void add_fact(Transaction& transaction, const Datum& fact) const;
  // Keeps what stands on the board of one of the relations that beliefs are told in to what is believed.
  Task<void> put_right(Datum pattern, Change change);
  bool is_to_be_told(const Datum& fact) const;
  Facts to_be_told(const Datum& pattern) const;

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  const TaskDomain& domain_;
  const runtime::Service& service_;
  const Beliefs& beliefs_;

  std::map<std::string, Eigen::Vector3d, std::less<>> told_places_;
  bool all_told_ = true;
  LeaseId told_under_ = 0;  // the presence under which it was told
  std::vector<Job> jobs_;
};

}  // namespace pizarra::coordinator
