#pragma once

// The messages between clients and the board server: each message an s-expression, in text. A frame holds one, or some
// that go together, one after another: 64 at most.
//
// Client to server                              Server to client
//   (hello TELLER SESSION [PROTOCOL [doubts]])     (welcome SESSION LIFE) or (unavailable MICROSECONDS)
//   (request SESSION ID BODY [TIME])               (reply ID RESULT) or (reply ID RESULT REVISION SENT)
//   (ack SESSION WATCH SEQ [RELATION TOOK])        (change WATCH SEQ REVISION KIND (ANSWER ...) (ANSWER ...))
//   (unwatch SESSION WATCH)                        (watch-failed WATCH (fail ...))
//   (ping SESSION)                                 (pong TIME)
//   (bye SESSION)                                  (unknown-session SESSION), (refused (fail ...)), (goodbye)
//
// SESSION 0 in a hello: a new one. A hello that says no PROTOCOL is of 1, whose boards knew no other hello.
//
// A board that may have been replaced says nothing, but to a client that says `doubts`: it is `unavailable`, and so
// long ago it knew that it led. It also answers `recall`, in a frame that begins so. Such a frame is no sign of life.
//
// A RESULT is (ok VALUE) or (fail ...). A client that holds what it watches is told the revision the board was at then,
// and whether all changes up to there went to it before the reply: SENT is `yes` or `no`. A reply that is given again
// does not say. The answers of a change are those that came, then those that went. Its KIND is `no` for what changed,
// `yes` for all that holds, or, where that is more than a message holds, `first`, `more` ... and `last` for the parts
// of it: what went is then of the parts before, and what holds is known with the last.
//
// An `ack` is of all changes up to SEQ. Times are the server's, in microseconds: a client that knows them from its
// pongs may say when it sent a request, and how long a fact of a relation TOOK from its commit to here.
//
// A BODY and the VALUE of its reply:
//   (declare RELATION ...) -> ()                       (take PATTERN LEASE) -> () or (FACT)
//   (transact (PRECONDITION ...) (STEP ...)) -> N      (lease MICROSECONDS) -> LEASE
//   (ask QUERY) -> (REVISION ANSWER ...)               (renew LEASE), (release LEASE) -> ()
//   (recall QUERY) -> (MICROSECONDS SETTLED REVISION ANSWER ...)
//   (watch WATCH QUERY), (watch WATCH QUERY kept), (watch WATCH QUERY held) -> ()
// PRECONDITION is (present P), (absent P), (unchanged P REVISION); STEP is (tell FACT LEASE CAUSE ...), (retract P),
// (settle ID); FACT is (ID REVISION MICROSECONDS TELLER DATUM CAUSE ...). An ANSWER is the list of its facts: the
// bindings follow from the query. To a client that keeps what it was sent, as one that holds it does too, an ANSWER
// that is one fact is no list of it: what came is a FACT, or (ID DATUM CAUSE ...) where it was told when and by whom
// the one before it was; what went is its ID. What is recalled may be so old. Where SETTLED is `no`, some of it may be
// undone when another board takes over; else it is `yes`.
//
// A fault of a request is told in its reply, also where no more than `(request SESSION ID` can be read. `refused` is of
// what is no request: of a hello, or of what cannot be read that far. Which that was, it does not say: a client that
// has joined takes whatever it has sent and waits for as refused. A frame that cannot be read is refused whole, to the
// request that it begins as.
//
// A server that is ended in order says goodbye to every client. A session lives while its client is heard from. Changes
// of one watch are numbered from 1; only so many are under way before they are acknowledged.

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
