"""A client of a Pizarra board for scripts: needs python3-zmq, and nothing else of Pizarra.

    from pizarra import Board, Symbol

    with Board("ipc:///tmp/cell/board.ipc", "script") as board:
        board.declare("(relation seen ((name string) (x number)) (key name))")
        board.tell('(seen "circle" 112.5)')                      # text, or data: [Symbol("seen"), "circle", 112.5]
        for answer in board.ask("(and (seen ?name ?x) (< ?x 200))"):
            print(answer.bindings["?name"], answer.facts[0].teller)
        lease = board.lease(2.0)                                  # seconds; keep it with board.renew(lease)
        fact = board.take("(job ?n)", lease)                      # None where nothing fits
        if fact: board.transact(steps=[settle(fact.id), tell("(done 1)")])
        watch = board.watch("(seen ?name ?x)")
        change = watch.next(timeout=5)                            # what holds now, then every change, in order
        eyes = board.stream("vision-left")                        # of a publisher that other machines may see
        frame = eyes.next(timeout=5)                              # the newest: number, width, height, channels, pixels

A symbol is a Symbol, a string a str, a list a list; integers and reals are int and float. What fails raises Failure, with
its symbol, sentence and subject: undeclared-relation, wrong-shape, precondition-failed, unknown-lease, not-permitted,
too-large, unreachable, timeout; bad-datum for what cannot be said to a board, as None, nan or bytes; bad-address,
bad-name, unreadable-file and bad-key for what it cannot begin with; closed for what is asked of it after close(). With
key="NAME.secret" (board.key stands beside it) the board may be on another machine.

There are no replicas here: every ask goes to the server and back. A script that asks often watches instead, and keeps
what the changes say.

One thread uses a Board. Every call lets it speak with the server; between calls use board.wait(seconds): a client
that is silent for ten seconds is forgotten, and its watches then begin again with a resynchronised change. A request is
sent again while it is not answered; when the server was lost, relations are declared again and watches begin again.
"""

import math
import os
import re
import stat
import struct
import time

import zmq
from zmq.utils import z85

FRAME_BYTES = 1 << 20
FRAME_DEPTH = 64
FRAME_ELEMENTS = 200_000
ENVELOPE_BYTES = 64
ENVELOPE_ELEMENTS = 4
TELLER_BYTES = 128


class Failure(Exception):
    def __init__(self, symbol, sentence, subject=()):
        super().__init__(f"{symbol}: {sentence}")
        self.symbol, self.sentence, self.subject = str(symbol), str(sentence), subject


class Symbol(str):
    """A name; never equal to the string of the same letters."""

    __slots__ = ()

    def __eq__(self, other):
        return isinstance(other, Symbol) and str.__eq__(self, other)

    def __ne__(self, other):
        return not self == other

    __hash__ = str.__hash__

    def __repr__(self):
        return f"Symbol({str.__repr__(self)})"


# ---- the language

_LETTERS = r"[A-Za-z0-9!$%&*/:<=>?^_~+\-.@]+"
_TOKEN = re.compile(rf'[ \t\r\n]+|;[^\n]*|([()])|"((?:[^"\\]|\\.)*)"|({_LETTERS})', re.DOTALL)
_SYMBOL = re.compile(rf"(?![+-]?\.?[0-9])(?!\.\Z){_LETTERS}\Z")
_NUMBER_LIKE = re.compile(r"[+-]?\.?[0-9]")
_NUMBER = re.compile(r"([+-]?[0-9]+(?:\.[0-9]+)?)([eE][+-]?[0-9]+)?\Z")
_NO_TEXT = re.compile("[\0\ud800-\udfff]")
_WHOLE = range(-1 << 63, 1 << 63)
_UNESCAPED = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}
_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}


def _atom(text):
    if not _NUMBER_LIKE.match(text):
        if text == ".":
            raise Failure("bad-character", "a dot has no meaning here")
        return Symbol(text)
    number = _NUMBER.match(text)
    if not number:
        raise Failure("bad-number", f"{text[:40]} begins like a number but is none")
    if set(text) & set(".eE"):
        value = float(text)
        fits = math.isfinite(value) and (value != 0 or not set(number[1]) & set("123456789"))
    else:
        value = int(text) if len(text.lstrip("+-0")) < 20 else _WHOLE.stop
        fits = value in _WHOLE
    if not fits:
        raise Failure("bad-number", f"{text[:40]} is too large, or too small, for a number")
    return value


def _string(text):
    try:
        return re.sub(r"\\(.)", lambda escape: _UNESCAPED[escape[1]], text, flags=re.DOTALL)
    except KeyError as escape:
        raise Failure("bad-escape", f"a string has no escape of {escape}") from None


def read(text):
    """The one datum that the text holds."""
    data = read_all(text)
    if len(data) != 1:
        raise Failure("more-than-one" if data else "nothing-to-read", "a text holds one datum")
    return data[0]


def read_all(text):
    if _NO_TEXT.search(text):
        raise Failure("bad-text", "no text holds a NUL or half a character")
    stack, at = [[]], 0
    while at < len(text):
        token = _TOKEN.match(text, at)
        if not token:
            symbol = "unclosed-string" if text[at] == '"' else "bad-character"
            raise Failure(symbol, f"this is no datum from character {at} on: {text[at:at + 20]!r}")
        at = token.end()
        if token[1] == "(":
            stack.append([])
        elif token[1] == ")":
            if len(stack) == 1:
                raise Failure("unexpected-close", "a ) that closes nothing")
            done = stack.pop()
            stack[-1].append(done)
        elif token[2] is not None:
            stack[-1].append(_string(token[2]))
        elif token[3] is not None:
            stack[-1].append(_atom(token[3]))
    if len(stack) > 1:
        raise Failure("unclosed-list", "a list is not closed")
    return stack[0]


def write(datum, deepest=FRAME_DEPTH):
    if isinstance(datum, Symbol):
        if not _SYMBOL.match(datum):
            raise Failure("bad-datum", f"{str.__repr__(datum)[:60]} is no symbol")
        return str(datum)
    if isinstance(datum, str):
        if _NO_TEXT.search(datum):
            raise Failure("bad-datum", "no string holds a NUL or half a character")
        return '"' + "".join(_ESCAPES.get(letter, letter) for letter in datum) + '"'
    if isinstance(datum, (list, tuple)):
        if deepest == 0:
            raise Failure("too-large", "lists nest deeper than the board takes them")
        return "(" + " ".join(write(item, deepest - 1) for item in datum) + ")"
    if isinstance(datum, int) and not isinstance(datum, bool) and datum in _WHOLE:
        return int.__repr__(datum)
    if isinstance(datum, float) and math.isfinite(datum):
        return float.__repr__(datum)
    kind = "out of range" if isinstance(datum, (int, float)) and not isinstance(datum, bool) else "no datum"
    raise Failure("bad-datum", f"a value of the type {type(datum).__name__} is {kind}: "
                               "data are lists, Symbols, strings, integers of 64 bits and finite reals")


def _check_teller(name):
    """Agents speak of who asked them by that name, as a symbol, which must not be a variable."""
    if not _SYMBOL.match(name) or name.startswith("?"):
        raise Failure("bad-name", f"no teller is called {str.__repr__(name)[:60]}: the name is a symbol's, of letters, "
                                  "digits, dashes and the like, without blanks, no digit and no question mark first", name)
    if len(name) > TELLER_BYTES:
        raise Failure("too-large", f"the name of a teller has at most {TELLER_BYTES} bytes")


def _elements(datum):
    return 1 + sum(map(_elements, datum)) if isinstance(datum, (list, tuple)) else 1


def _datum(given):
    return read(given) if isinstance(given, str) and not isinstance(given, Symbol) else given


def _query(given):
    query = read(write(_datum(given)))
    if not isinstance(query, list) or len(query) < 1 + (query[:1] == [Symbol("query")]):
        raise Failure("bad-query", "a query is a pattern, (and CLAUSE ...) or (query QUERY OPTION ...)", query)
    return query


def _same(a, b):
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(_same, a, b))
    return type(a) is type(b) and a == b


def _match(pattern, datum, bindings):
    if isinstance(pattern, Symbol) and pattern.startswith("?"):
        return pattern == Symbol("?") or _same(bindings.setdefault(str(pattern), datum), datum)
    if isinstance(pattern, list):
        fits = isinstance(datum, list) and len(pattern) == len(datum)
        return fits and all(_match(p, d, bindings) for p, d in zip(pattern, datum))
    return _same(pattern, datum)


# ---- what the board answers


class Fact:
    def __init__(self, form):
        self.id, self.revision, self.microseconds, self.teller, self.datum, *self.because = form


class Answer:
    """One way to satisfy a query: variables' values by "?name", and the facts of its positive patterns."""

    def __init__(self, patterns, form):
        self.facts = [Fact(fact) for fact in form]
        self.bindings = {}
        for pattern, fact in zip(patterns, self.facts):
            _match(pattern, fact.datum, self.bindings)


def _answers(query, forms):
    """What a board answers to a query that it has understood."""
    query = query[1] if query[0] == Symbol("query") else query
    clauses = query[1:] if query[0] == Symbol("and") else [query]
    patterns = [clause for clause in clauses if clause[0] not in map(Symbol, ("not", "<", "<=", ">", ">=", "=", "/="))]
    return [Answer(patterns, form) for form in forms]


class Change:
    """What became true and false at a revision; resynchronised: `added` is all that holds, what was known is void."""

    def __init__(self, revision, resynchronised, added, removed):
        self.revision, self.resynchronised, self.added, self.removed = revision, resynchronised, added, removed


# ---- what a transaction is made of


def tell(fact, lease=0, because=()):
    return [Symbol("tell"), _datum(fact), lease, *because]


def retract(pattern):
    return [Symbol("retract"), _datum(pattern)]


def settle(taken):
    return [Symbol("settle"), taken]


def present(pattern):
    return [Symbol("present"), _datum(pattern)]


def absent(pattern):
    return [Symbol("absent"), _datum(pattern)]


def unchanged(pattern, revision):
    return [Symbol("unchanged"), _datum(pattern), revision]


# ---- the client


class Request:
    """A request under way: done when `result` is no longer None, a value in a list or a Failure."""

    def __init__(self, body, repeatable):
        self.body, self.repeatable, self.sent, self.result = body, repeatable, None, None


class Watch:
    ACKNOWLEDGE_AFTER = 8

    def __init__(self, board, query):
        self.board, self.query = board, query
        self.unread, self.ended = [], None
        self.enrol()

    def enrol(self):
        self.id, self.expected, self.read, self.acknowledged, self.parts = self.board._next_watch, 1, 0, 0, {}
        self.board._next_watch += 1
        self.board._watches[self.id] = self
        self.request = self.board.begin([Symbol("watch"), self.id, self.query], True)

    def begin_again(self):
        self.board._watches.pop(self.id, None)
        self.board._send([Symbol("unwatch"), self.board._session, self.id])
        self.unread = [(0, change) for _, change in self.unread]
        self.enrol()

    def receive(self, sequence, form):
        revision, kind = form[0], str(form[1])
        added, removed = (_answers(self.query, answers) for answers in form[2:4])
        if sequence < self.expected:
            return
        if sequence > self.expected and kind not in ("yes", "first"):
            return self.begin_again()
        self.expected = sequence + 1
        if kind in ("no", "yes"):
            self.unread.append((sequence, Change(revision, kind == "yes", added, removed)))
            return
        # What holds is more than a message holds: parts, the first of which voids what was known.
        if kind == "first":
            self.parts = {}
        for answer in removed:
            self.parts.pop(answer.facts[0].id, None)
        self.parts.update((answer.facts[0].id, answer) for answer in added)
        if kind == "last":
            whole = [answer for _, answer in sorted(self.parts.items())]
            self.unread.append((sequence, Change(revision, True, whole, [])))
        else:
            self.read = sequence
            self.acknowledge()

    def poll(self):
        """The next change, or None where there is none yet."""
        self.board._check_open()
        if not self.unread:
            failed = isinstance(self.request.result, Failure) and self.request.result
            if self.ended or failed:
                raise self.ended or failed
            return None
        sequence, change = self.unread.pop(0)
        if sequence:
            self.read = sequence
        if not self.unread or self.read - self.acknowledged >= self.ACKNOWLEDGE_AFTER:
            self.acknowledge()
        return change

    def acknowledge(self):
        owed = self.read > self.acknowledged
        if owed and self.board._send([Symbol("ack"), self.board._session, self.id, self.read]):
            self.acknowledged = self.read

    def next(self, timeout=None):
        return self.board._until(self.poll, timeout, "no change came in time")

    def close(self):
        if self.board._watches.pop(self.id, None):
            self.board._send([Symbol("unwatch"), self.board._session, self.id])


class Frame:
    """An image: `pixels` are bytes, row by row, blue, green and red of each where there are three channels."""
    HEADER = struct.Struct("<5Q")

    def __init__(self, text):
        (self.number, self.microseconds, self.width, self.height, self.channels) = self.HEADER.unpack_from(text)
        self.pixels = text[self.HEADER.size:]
        if len(self.pixels) != self.width * self.height * self.channels:
            raise ValueError("not a frame")


class Stream:
    """Follows an image stream: newest wins, and the next publisher under its name is gone on with."""

    def __init__(self, board, name):
        self.watch = board.watch([Symbol("stream"), Symbol(name), Symbol("?kind"), Symbol("?place")])
        self.board, self.topic, self.socket = board, name.encode() + b" ", None

    def poll(self):
        """The newest frame, or None where there is none yet."""
        change = self.watch.poll()
        if change and change.added:
            self._connect(change.added[-1].facts[0].datum[3])
        if self.socket is None or not self.socket.poll(0):
            return None
        try:
            return Frame(self.socket.recv()[len(self.topic):])
        except (ValueError, struct.error):
            return None

    def _connect(self, place):
        ways = [way[1:] for way in place if way[0] == Symbol("tcp") and len(way) == 5]
        if not ways:
            raise Failure("no-image", "the stream is to be had on its publisher's machine alone, without Python")
        self._disconnect()
        self.socket = self.board._context.socket(zmq.SUB)
        _connect(self.socket, ways[0][0], ways[0][1:],
                 (zmq.LINGER, 0), (zmq.CONFLATE, 1), (zmq.SUBSCRIBE, self.topic))

    def _disconnect(self):
        if self.socket is not None:
            self.socket.close(linger=0)
        self.socket = None

    def next(self, timeout=None):
        return self.board._until(self.poll, timeout, "no frame came in time")

    def close(self):
        self.watch.close()
        self._disconnect()


class Board:
    PING, RESEND, GREET, SILENCE = 0.5, 1.0, 0.5, 2.0
    # Where another board may take over: it serves within half a second.
    PING_AMONG_OTHERS, SILENCE_AMONG_OTHERS, TRIES_FIRST_FOR, TRIES_LONGEST_FOR = 0.1, 0.4, 0.15, 2.0
    # No request goes before the board has answered those so far behind it: it remembers the answers of the last 256.
    MOST_AHEAD = 128

    def __init__(self, address, teller, key=None, timeout=5.0):
        if not isinstance(address, str) or not isinstance(teller, str):
            raise Failure("wrong-shape", "a board's address and the name of a teller are strings")
        _check_teller(teller)
        self.address, self.teller, self.timeout = address, teller, timeout
        # Of boards that take over from each other, with commas between them. A path may have one.
        self._addresses = [address] if address.startswith("ipc://") else address.split(",")
        self._at, self._tried, self._tries_for = 0, time.monotonic(), self.TRIES_FIRST_FOR
        self._keys = None
        if key and not address.startswith("ipc://"):
            name, self._keys = _read_keys(key)
            if teller != name and not teller.startswith(name + "/"):
                self.teller = f"{name}/{teller}"
        self._session = self._life = 0
        self._joined = False
        self._heard = self._greeted = self._pinged = -1e9
        self._next_request = self._next_watch = 1
        self._pending, self._watches, self._declared = {}, {}, {}
        self._context = zmq.Context()
        try:
            self._connect()
        except Failure:
            self._context.destroy(linger=0)
            raise

    def _connect(self):
        self._socket = self._context.socket(zmq.DEALER)
        self._monitor = self._socket.get_monitor_socket(
            zmq.EVENT_HANDSHAKE_FAILED_AUTH | zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL)
        _connect(self._socket, self._addresses[self._at], self._keys, (zmq.LINGER, 50), (zmq.IMMEDIATE, 1), (zmq.RECONNECT_IVL, 50),
                 (zmq.RECONNECT_IVL_MAX, 1000))

    def _check_open(self):
        if self._context.closed:
            raise Failure("closed", "this board was closed", self.address)

    def close(self):
        if self._context.closed:
            return
        for watch in list(self._watches.values()):
            watch.close()
        if self._joined:
            self._send([Symbol("bye"), self._session])
        self._socket.disable_monitor()
        self._context.destroy(linger=50)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # Each of these waits for the board's answer.

    def declare(self, *relations):
        forms = [_datum(relation) for relation in relations]
        self._call([Symbol("declare"), *forms], True)
        self._declared.update((form[1], form) for form in forms)

    def transact(self, steps, preconditions=()):
        """The revision it happened at."""
        return self._call([Symbol("transact"), list(preconditions), list(steps)], False)

    def tell(self, fact, lease=0, because=()):
        return self.transact([tell(fact, lease, because)])

    def retract(self, pattern):
        return self.transact([retract(pattern)])

    def ask(self, query):
        """The answers; their revision is board.revision."""
        query = _query(query)
        self.revision, *forms = self._call([Symbol("ask"), query], True)
        return _answers(query, forms)

    def watch(self, query):
        watch = Watch(self, _query(query))
        try:
            self._finish(watch.request)
        except Failure:
            watch.close()
            raise
        return watch

    def stream(self, name):
        return Stream(self, name)

    def take(self, pattern, lease=0):
        taken = self._call([Symbol("take"), _datum(pattern), lease], False)
        return Fact(taken[0]) if taken else None

    def lease(self, seconds):
        if not isinstance(seconds, (int, float)) or not abs(seconds) < 1e12:
            raise Failure("wrong-shape", "a lease is a number of seconds, at most a year")
        return self._call([Symbol("lease"), round(seconds * 1e6)], True)

    def renew(self, lease):
        self._call([Symbol("renew"), lease], True)

    def release(self, lease):
        self._call([Symbol("release"), lease], True)

    def await_answer(self, query, timeout):
        """The first answer that holds now or comes to hold in time."""
        query = _query(query)
        for answer in self.ask(query):
            return answer
        watch, deadline = self.watch(query), time.monotonic() + timeout
        try:
            while True:
                change = watch.next(deadline - time.monotonic())
                if change.added:
                    return change.added[0]
        finally:
            watch.close()

    def wait(self, seconds):
        """Keeps in touch with the server meanwhile."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            self.turn(min(0.05, max(0.0, deadline - time.monotonic())))

    # For those who have a loop of their own: begin(), turn() often, look at the request's result.

    def begin(self, body, repeatable):
        self._check_open()
        size = len(write(body, FRAME_DEPTH - 1).encode())
        if size + ENVELOPE_BYTES > FRAME_BYTES or _elements(body) + ENVELOPE_ELEMENTS > FRAME_ELEMENTS:
            raise Failure("too-large", "the request does not fit one message of the board")
        number, self._next_request = self._next_request, self._next_request + 1
        request = self._pending[number] = Request(body, repeatable)
        if self._joined:
            self._transmit_due(lambda other: other is request)
        return request

    def turn(self, seconds=0.0):
        """Receives what has come, waiting that long for it, and says what is due."""
        self._check_open()
        self._tick()
        if self._socket.poll(int(seconds * 1000)):
            while self._socket.poll(0):
                for message in read_all(self._socket.recv().decode()):
                    self._receive(message)
        self._tick()

    def sockets(self):
        return [self._socket, self._monitor]

    def _call(self, body, repeatable):
        return self._finish(self.begin(body, repeatable))

    def _finish(self, request):
        try:
            self._until(lambda: request.result, self.timeout, None)
        except TimeoutError:
            self._forget(request)
            raise Failure("unreachable", "the board does not answer", self.address) from None
        if isinstance(request.result, Failure):
            raise request.result
        return request.result[0]

    def _until(self, ready, timeout, late):
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            found = ready()
            if found is not None:
                return found
            if deadline is not None and time.monotonic() >= deadline:
                raise Failure("timeout", late) if late else TimeoutError
            self.turn(0.01)

    def _forget(self, request):
        self._pending = {number: other for number, other in self._pending.items() if other is not request}

    def _send(self, message):
        self._check_open()
        try:
            self._socket.send(write(message).encode(), zmq.DONTWAIT)
            return True
        except zmq.Again:
            return False

    def _transmit(self, number, request):
        if self._send([Symbol("request"), self._session, number, request.body]):
            request.sent = time.monotonic()

    def _transmit_due(self, is_due):
        first = next(iter(self._pending), 0)
        for number, request in self._pending.items():
            if number >= first + self.MOST_AHEAD:
                break
            if is_due(request):
                self._transmit(number, request)

    def _tick(self):
        now = time.monotonic()
        if self._monitor.poll(0):
            self._refused()
        others = len(self._addresses) > 1
        if self._joined and self._heard + (self.SILENCE_AMONG_OTHERS if others else self.SILENCE) <= now:
            self._joined, self._greeted, self._tried = False, -1e9, now
        if not self._joined:
            if others and self._tried + self._tries_for <= now:
                self._try_next(now)
            due = self._greeted + self.GREET <= now
            if due and self._send([Symbol("hello"), self.teller, self._session]):
                self._greeted = now
            return
        if self._pinged + (self.PING_AMONG_OTHERS if others else self.PING) <= now and self._send([Symbol("ping"), self._session]):
            self._pinged = now
        self._transmit_due(lambda request: request.sent is None or request.sent + self.RESEND <= now)

    def _try_next(self, now):
        """One that does not welcome within its time stands by, or is gone; over a slow line it may take longer."""
        self._at = (self._at + 1) % len(self._addresses)
        if self._at == 0:
            self._tries_for = min(self._tries_for * 1.25, self.TRIES_LONGEST_FOR)
        self._tried, self._greeted = now, -1e9
        self._begin_connection_again()

    def _begin_connection_again(self):
        self._socket.disable_monitor()
        self._socket.close(linger=0)
        self._connect()

    def _receive(self, message):
        self._heard = time.monotonic()
        kind = str(message[0])
        if kind == "reply" and message[1] in self._pending:
            request, result = self._pending.pop(message[1]), message[2]
            request.result = [result[1]] if result[0] == Symbol("ok") else Failure(*result[1:4])
        elif kind == "welcome" and not self._joined:
            self._welcomed(*message[1:3])
        elif kind == "goodbye" or kind == "unknown-session" and message[1] == self._session:
            self._joined, self._greeted = False, -1e9
        elif kind == "refused":
            # Of a hello, on which everything waits; or of what the board could not read, any of what was sent to it.
            self._fail(Failure(*message[1][1:4]), lambda request: not self._joined or request.sent is not None)
        elif kind == "change" and message[1] in self._watches:
            self._watches[message[1]].receive(message[2], message[3:])
        elif kind == "change":
            self._send([Symbol("unwatch"), self._session, message[1]])
        elif kind == "watch-failed" and message[1] in self._watches:
            self._watches[message[1]].ended = Failure(*message[2][1:4])

    def _welcomed(self, session, life):
        self._joined, self._tries_for = True, self.TRIES_FIRST_FOR
        same_session, same_life = session == self._session, life == self._life
        self._session, self._life = session, life
        if not same_session:
            for number, request in list(self._pending.items()):
                if request.sent is not None and not request.repeatable:
                    del self._pending[number]
                    request.result = Failure("unreachable", "the board was lost: whether this happened is not known")
                request.sent = None
        if not (same_session and same_life):
            if self._declared:
                self.begin([Symbol("declare"), *self._declared.values()], True)
            for watch in list(self._watches.values()):
                if watch.request.result is not None:
                    watch.begin_again()
        self._transmit_due(lambda request: True)

    def _refused(self):
        while self._monitor.poll(0):
            self._monitor.recv_multipart()
        self._joined = False
        self._fail(Failure("not-permitted", "the board does not accept this key" if self._keys else
                           "the board asks for a key at this address"), lambda request: True)
        # ZeroMQ does not try again by itself.
        self._begin_connection_again()

    def _fail(self, failure, concerned):
        for number, request in list(self._pending.items()):
            if concerned(request):
                self._pending.pop(number).result = failure


# A peer that is silent for six seconds is gone: told by TCP, for ZeroMQ's heartbeats end a program whose peer goes at
# the wrong moment (blackboard/wire/half_open.hpp).
_LET_GO_WHEN_HALF_OPEN = ((zmq.TCP_KEEPALIVE, 1), (zmq.TCP_KEEPALIVE_IDLE, 2), (zmq.TCP_KEEPALIVE_INTVL, 2),
                          (zmq.TCP_KEEPALIVE_CNT, 3), (zmq.TCP_MAXRT, 6000))


def _connect(socket, address, keys, *options):
    """With the server's public key, our public and our secret one, where there are any."""
    for option, value in options + _LET_GO_WHEN_HALF_OPEN:
        socket.setsockopt(option, value)
    if keys:
        socket.curve_serverkey, socket.curve_publickey, socket.curve_secretkey = (key.encode() for key in keys)
    try:
        socket.connect(address)
    except zmq.ZMQError as error:
        raise Failure("bad-address", f"nothing can be connected to {address[:100]}: {error}", address) from None


def _read_keys(path):
    """The name in the secret, (secret-key NAME PUBLIC SECRET), and three keys: the board's, (key board PUBLIC) beside it,
    and both of the secret."""
    name, *own = _read_key(path, "secret-key", 2)
    if os.stat(path).st_mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise Failure("exposed-key", "others may read this secret: chmod 600 it, and make a new key", str(path))
    _, board = _read_key(os.path.join(os.path.dirname(path), "board.key"), "key", 1)
    return name, [board, *own]


def _read_key(path, head, count):
    try:
        with open(path, encoding="utf-8") as file:
            form = read(file.read(1 << 16))
    except OSError as error:
        raise Failure("unreadable-file", f"{path}: {error.strerror}", str(path)) from None
    except (UnicodeDecodeError, Failure) as error:
        raise Failure("bad-key", f"{path}: {error}", str(path)) from None
    written = rf'\({head} {_LETTERS}(?: "[^"]{{40}}"){{{count}}}'
    try:
        if re.match(written, write(form)) and all(map(z85.decode, form[2:2 + count])):
            return form[1:2 + count]
    except (ValueError, KeyError, struct.error, Failure):
        pass  # 40 characters, and not of Z85; or deeper than anything is written
    raise Failure("bad-key", f"{path}: this file holds one form, ({head} NAME KEY ...), each KEY 40 characters of Z85",
                  str(path))
