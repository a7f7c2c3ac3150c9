#pragma once

// A client asks for its own permissions. They are facts that are made up for each who asks, alone.
//
//   (own-permission VERB RELATION)
//
// VERB is tell, take, read or override; RELATION is as in a key: `vision-*` and `*` too.
//
//   if (store::asks_for(query, own_permission)) answers = own_permissions({{"tell", "stop"}}, query, asked, examined);

#include <string>
#include <utility>
#include <vector>

#include "blackboard/store/made_up.hpp"

namespace pizarra::memory {

using ListedPermissions = std::vector<std::pair<std::string, std::string>>;  // a verb, and the relations that it is for

// Of a client without a key.
ListedPermissions every_permission();

Result<Answers> own_permissions(const ListedPermissions& listed, const Query& query, const store::AskedAt& asked,
                                std::size_t& examined);

}  // namespace pizarra::memory
