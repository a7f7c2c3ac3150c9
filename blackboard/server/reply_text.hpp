#pragma once

// The reply to a request, as wire.hpp says it.
//
//   socket.send(peer, reply_text(number, result_to_datum(result)));

#include <string>

#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

// A failure's long sentence or subject is shortened.
Datum result_to_datum(const Result<Datum>& result);
std::string reply_text(wire::RequestId id, const Datum& result);

}  // namespace pizarra::server
