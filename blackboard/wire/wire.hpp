#pragma once

// The messages between clients and the board server: each message an s-expression, in text. A frame holds one, or some
// that go together, one after another: `most_messages` at most.
//
// Client to server                              Server to client
//
//   (hello TELLER SESSION [PROTOCOL [doubts]])     (welcome SESSION LIFE) or (unavailable MICROSECONDS)
//   (request SESSION ID BODY [TIME])               (reply ID RESULT) or (reply ID RESULT REVISION SENT)
//
//   (ack SESSION WATCH SEQ [RELATION TOOK])        (change WATCH SEQ REVISION KIND (ANSWER ...) (ANSWER ...))
//   (unwatch SESSION WATCH)                        (watch-failed WATCH (fail ...))
//
//   (ping SESSION)                                 (pong TIME)
//   (bye SESSION)                                  (unknown-session SESSION), (refused (fail ...)), (goodbye)
//
// SESSION 0 in a hello asks for a new one. A hello without PROTOCOL is of protocol 1, which had no such word.
//
// A board that may have been replaced is silent, except to clients whose hello says `doubts`. To these it says
// `unavailable`, and how long ago it knew that it led. It answers a `recall` at the beginning of their frames too. Such
// a frame is no sign of life.
//
// A RESULT is (ok VALUE) or (fail ...). A client with a `held` watch is also told the board's REVISION at that moment,
// and by SENT, `yes` or `no`, whether all changes up to it were sent before the reply. A reply that is repeated leaves
// both out. A change has the answers that came, then those that went. Its KIND is `no` for a change, `yes` for all that
// holds. Where all that holds is more than a message, it comes in parts of the KINDs `first`, `more` ... and `last`:
// the answers that went are then of earlier parts, and the client knows what holds with the last part.
//
// An `ack` acknowledges all changes up to SEQ. Times are the server's, in microseconds. A client that knows its clock
// from pongs may say when it sent a request, and how long a fact of a relation TOOK from its commit to the client.
//
// A BODY and the VALUE of its reply:
//
//   (declare RELATION ...) -> ()                       (take PATTERN LEASE) -> () or (FACT)
//   (transact (PRECONDITION ...) (STEP ...)) -> N      (lease MICROSECONDS) -> LEASE
//
//   (ask QUERY) -> (REVISION ANSWER ...)               (renew LEASE), (release LEASE) -> ()
//   (recall QUERY) -> (MICROSECONDS SETTLED REVISION ANSWER ...)
//
//   (watch WATCH QUERY), (watch WATCH QUERY kept), (watch WATCH QUERY held) -> ()
//
// PRECONDITION is (present P), (absent P), (unchanged P REVISION); STEP is (tell FACT LEASE CAUSE ...), (retract P),
// (settle ID); FACT is (ID REVISION MICROSECONDS TELLER DATUM CAUSE ...). An ANSWER is the list of its facts: the
// bindings follow from the query. A `kept` or `held` watch is for clients that keep what they were sent. There an
// ANSWER of one fact is written without the list. One that came is a FACT, or (ID DATUM CAUSE ...) where teller and
// time are those of the fact before it. One that went is its ID. The MICROSECONDS of `recall` say how old its answers
// may be. SETTLED is `no` where some of them may be undone when another board takes over, else `yes`.
//
// A fault of a request is told in its reply, if `(request SESSION ID` can be read. `refused` is the answer to a hello,
// and to anything of which less can be read. It does not say to which message: a client that has joined then takes
// every request that it has sent and not had answered as refused. A frame that cannot be read is refused as a whole, in
// reply to the request that it begins with.
//
// A server that is ended in order says goodbye to every client. A session lives while its client is heard from. Changes
// of one watch are numbered from 1. A bounded number of them is under way before the client acknowledges some.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/limits.hpp"
#include "lisp/reader.hpp"

namespace pizarra::wire {

using SessionId = std::uint64_t;
using RequestId = std::uint64_t;
using WatchId = std::uint64_t;

// Of this build. Builds understand each other whose protocols are the same, or neighbours.
constexpr std::uint64_t protocol = 2;
// Whether a board understands such a client. Failure other-protocol.
Result<void> check_protocol(std::uint64_t of_client);

// The messages that go together in a frame: so many messages, and no more once it has so many bytes.
constexpr std::size_t most_messages = 64;
constexpr std::size_t bytes_together = 64 << 10;

// The strict reader with the limits of a frame.
Result<Datum> read_frame(std::string_view text);
// The same, of all that it holds.
Result<std::vector<Datum>> read_messages(std::string_view frame);

// The request that a frame begins as, `(request SESSION ID`, whatever comes then.
std::optional<RequestId> request_begun(std::string_view frame, SessionId session);

// The datum as a number that counts something; nothing where it is none.
std::optional<std::uint64_t> count_from(const Datum& datum);
// The same for an element of a list, which need not be there.
std::optional<std::uint64_t> count_at(const Datum& form, std::size_t index);

// Failure bad-frame, here and below.
// The causes of a fact.
Result<std::vector<FactId>> ids_from(std::span<const Datum> forms);
// Adds `(transact ...)`, and answers what it weighs.
Weight write_transaction(std::string& out, const Transaction& transaction);
Result<Transaction> transaction_from_datum(const Datum& body);

}  // namespace pizarra::wire
