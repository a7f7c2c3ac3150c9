#include "programs/chaos/present_agents.hpp"

namespace pizarra::chaos {

PresentAgents::Change PresentAgents::look(const std::string& kind, int life, std::optional<FactId> presence) {
  if (!presence) return present_.erase(kind) > 0 ? Change::went : Change::none;
  const auto before = present_.find(kind);
  if (before != present_.end() && before->second.fact == *presence) return Change::none;
  present_.insert_or_assign(kind, Presence{*presence, life});
  return Change::came;
}

bool PresentAgents::is_present(const std::string& kind, int life) const {
  const auto found = present_.find(kind);
  return found != present_.end() && found->second.life == life;
}

}  // namespace pizarra::chaos
