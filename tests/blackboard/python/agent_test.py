"""The kit for agents: operations, presence, contract, what is asked twice, and a board that is started again.

agent_test.py PIZARRA-BOARD
"""

import os
import re
import signal
import subprocess
import sys
import textwrap
import threading

import a_board
from a_board import PATIENCE, BoardTest
from pizarra import Board, Contract, Failure, Presence, Symbol, read, settle, tell, write
from pizarra.contract import RUNTIME_RELATIONS

COUNTER = textwrap.dedent('''
    import asyncio
    from pizarra import Agent, Failure, Symbol

    agent = Agent("counter", posts=["(relation passed ((count integer)) (key))"],
                  reads=["(relation barrier ((name symbol) (state symbol)) (key name))"])
    count = 0

    @agent.operation("(count)")
    def tell_count():
        return count

    @agent.operation("(add (numbers number) ...)")
    async def add(*numbers):
        global count
        count += 1
        await asyncio.sleep(0)
        return sum(numbers), str(agent.request.teller)

    @agent.operation("(nothing)")
    def nothing():
        pass

    @agent.operation("(refuse (why symbol))")
    def refuse(why):
        raise Failure("refused", "as it was told to", why)

    @agent.operation("(break)")
    def fail():
        return 1 / 0

    @agent.operation("(variable)")
    def variable():
        return Symbol("?x")

    @agent.operation("(slow)")
    async def slow():
        await asyncio.sleep(0.3)
        return count

    @agent.watches("(barrier ?name blocked)")
    async def blocked(change):
        await agent.tell([Symbol("passed"), len(change.added)])

    agent.main()
''')


class AgentTest(BoardTest):
    def setUp(self):
        super().setUp()
        self.board = self.client()

    def start_agent(self, *words, program=COUNTER):
        agent = subprocess.Popen([sys.executable, "-c", program, self.address, *words], stderr=subprocess.PIPE, text=True)
        self.addCleanup(agent.stderr.close)
        self.addCleanup(a_board.end, agent, signal.SIGKILL)
        return agent

    def values(self, operation, agent="counter"):
        return self.board.request(agent, operation, timeout=PATIENCE)


class Operations(AgentTest):
    def test_what_a_function_returns_is_answered(self):
        self.start_agent()
        self.assertEqual(self.values("(count)"), [0])
        self.assertEqual(self.values("(nothing)"), [])
        self.assertEqual(self.values("(add 1 2.5 3)"), [6.5, "script"])
        self.assertEqual(self.values("(add)"), [0, "script"])

    def test_what_fails_is_said_with_its_symbol_and_the_agent_goes_on(self):
        agent = self.start_agent()
        self.assertEqual(self.refused("refused", self.values, "(refuse me)").subject, Symbol("me"))
        self.assertIn("did you mean count?", self.refused("unknown-operation", self.values, "(cuont)").sentence)
        self.refused("wrong-shape", self.values, "(count 1)")
        self.refused("wrong-shape", self.values, "(refuse \"me\")")
        self.assertIn("ZeroDivisionError", self.refused("broken", self.values, "(break)").sentence)
        self.refused("bad-reply", self.values, "(variable)")
        self.assertEqual(self.values("(count)"), [0])
        agent.terminate()
        self.assertIn("in fail\nZeroDivisionError", agent.stderr.read(), "its author is told where")

    def test_a_request_that_is_told_again_is_done_once(self):
        self.start_agent()
        self.values("(count)")
        for _ in range(2):
            self.board.tell("(request twice counter (add 1))")
            reply = self.board.await_answer("(reply twice ?result)", PATIENCE).bindings["?result"]
            self.assertEqual(reply, [Symbol("ok"), 1, "script"])
            self.board.retract("(reply twice ?)")
        self.assertEqual(self.values("(count)"), [1])

    def test_requests_are_done_side_by_side(self):
        self.start_agent()
        self.values("(count)")
        for n in range(20):
            self.board.send("counter", "(slow)")
        self.assertEqual(self.values("(count)"), [0])
        self.until(lambda: len(self.board.ask("(reply ?id (ok 0))")) == 20)
        self.assertEqual(self.board.ask("(request ? ? ?)"), [])

    def test_nobody_answers_for_an_agent_that_is_not_there(self):
        failure = self.refused("timeout", self.board.request, "nobody", "(count)", 0.5)
        self.assertEqual(failure.sentence, "nobody did not answer in 0.5 s: no agent of that name is there")
        self.assertEqual(self.board.ask("(request ? ? ?)"), [], "it is withdrawn")

    def test_a_failure_with_its_place_in_a_text_is_raised_whole(self):
        def refuse():
            with Board(self.address, "parser") as board:
                asked = board.await_answer("(request ?id parser ?)", PATIENCE).bindings["?id"]
                board.tell([Symbol("reply"), asked, read('(fail unknown "there is no x" x "goal:1:5\n  (on x)")')])

        self.board.declare(*RUNTIME_RELATIONS)
        parser = threading.Thread(target=refuse)
        parser.start()
        failure = self.refused("unknown", self.board.request, "parser", "(read)", PATIENCE)
        parser.join()
        self.assertEqual(failure.place, "goal:1:5\n  (on x)")
        self.assertEqual(str(failure), "unknown: there is no x\ngoal:1:5\n  (on x)")


class Life(AgentTest):
    def test_it_is_present_with_its_contract_and_bound_by_its_kind(self):
        self.start_agent("--name", "counter-7")
        self.assertEqual(self.values("(count)", "counter-7"), [0])
        [answer] = self.board.ask("(agent ?name ?kind ?host)")
        self.assertEqual(answer.bindings["?name"], Symbol("counter-7"))
        [answer] = self.board.ask("(contract counter-7 ?form)")
        form = write(answer.bindings["?form"])
        self.assertIn("(add (numbers number) ...)", form)
        self.assertIn("(reads barrier)", form)
        self.until(lambda: self.board.ask("(bound (cell counter) counter-7 counter counter-7)"))

    def test_told_to_end_it_leaves_at_once(self):
        agent = self.start_agent()
        self.values("(count)")
        agent.terminate()
        self.assertEqual(agent.wait(PATIENCE), 0)
        for relation in ("(agent ? ? ?)", "(contract ? ?)", "(bound ? ? ? ?)"):
            self.assertEqual(self.board.ask(relation), [], relation)

    def test_who_comes_second_waits_until_the_name_is_free(self):
        first = self.start_agent()
        self.values("(count)")
        [before] = self.board.ask("(agent counter ? ?)")
        self.start_agent()
        first.kill()
        watch = self.board.watch("(agent counter ? ?)")
        self.until(lambda: any(change.added and change.added[0].facts[0].id != before.facts[0].id
                               for change in iter(watch.poll, None)) or self.board.turn())
        self.assertEqual(self.values("(count)"), [0])

    def test_it_goes_on_when_the_board_is_started_again(self):
        self.start_agent()
        self.values("(count)")
        self.board.tell("(barrier exit blocked)")
        self.board.await_answer("(passed 1)", PATIENCE)
        self.restart_board()
        self.assertEqual(self.values("(count)"), [0])
        self.board.await_answer("(passed 0)", PATIENCE)
        self.board.tell("(barrier entry blocked)")
        self.board.await_answer("(passed 1)", PATIENCE)

    def test_what_it_watches_need_not_be_declared_when_it_comes(self):
        self.start_agent(program=COUNTER.replace('"(relation barrier ((name symbol) (state symbol)) (key name))"', '"barrier"'))
        self.values("(count)")
        self.assertEqual(self.board.ask("(passed ?)"), [])
        self.board.declare("(relation barrier ((name symbol) (state symbol)) (key name))")
        self.board.tell("(barrier exit blocked)")
        self.board.await_answer("(passed 1)", PATIENCE)

    def test_a_command_line_that_is_wrong_is_refused(self):
        for words in ([], ["--nothing"]):
            agent = subprocess.run([sys.executable, "-c", COUNTER, *words], capture_output=True, text=True, check=False)
            self.assertEqual(agent.returncode, 2)
            self.assertIn("BOARD-ADDRESS", agent.stderr)
        agent = subprocess.run([sys.executable, "-c", COUNTER, "nowhere"], capture_output=True, text=True, check=False)
        self.assertEqual(agent.returncode, 1)
        self.assertIn("counter: bad-address", agent.stderr)

    def test_who_waits_for_a_board_says_so(self):
        self.address = "ipc:///tmp/no-board-is-here"
        agent = self.start_agent()
        self.assertEqual(agent.stderr.readline(), "counter: no board answers at ipc:///tmp/no-board-is-here yet: waiting for it\n")

    def test_who_waits_for_its_name_says_so(self):
        self.start_agent()
        self.values("(count)")
        second = self.start_agent()
        self.assertEqual(second.stderr.readline(), "counter: another agent has this name: waiting until it is gone\n")


class PresenceOfAPlainScript(AgentTest):
    def test_it_comes_is_kept_and_leaves(self):
        presence = Presence("lamp", Contract("lamp"))
        presence.LEASE = 5.0  # of which a busy machine takes a part
        self.board.run(presence.come())
        began = [answer.facts[0].id for answer in self.board.ask("(agent lamp lamp ?)")]
        self.assertEqual(len(began), 1)
        watch = self.board.watch("(agent lamp lamp ?)")
        watch.next(PATIENCE)
        for _ in range(60):
            self.board.wait(0.1)
            self.assertFalse(self.board.run(presence.keep()))
        self.assertIsNone(watch.poll(), "longer than its lease, and it stood all the time")
        self.refused("timeout", self.board.request, "nobody", "(count)", 6)
        self.assertIsNone(watch.poll(), "a call that takes long keeps it, too")
        self.restart_board()
        self.until(lambda: self.board.wait(0.05) or self.board.run(presence.keep()))
        self.assertEqual(len(self.board.ask("(agent lamp lamp ?)")), 1)
        self.board.run(presence.leave())
        self.assertEqual(self.board.ask("(agent ? ? ?)"), [])


class Patterns(AgentTest):
    def test_pull_gives_the_newest(self):
        self.board.declare(a_board.NOTE)
        self.assertIsNone(self.board.pull("(note ?n ?)"))
        for n in (5, 3, 9, 1):
            self.board.tell([Symbol("note"), n, "a"])
        self.assertEqual(self.board.pull("(note ?n ?)").datum[1], 1)

    def test_an_event_is_one_clients_alone(self):
        self.board.declare(a_board.NOTE)
        with self.client("other") as other:
            self.board.tell("(note 1 a)")
            self.assertEqual(self.board.event("(note ?n ?)", 1).datum[1], 1)
            self.refused("timeout", other.event, "(note ?n ?)", 0.2)

    def test_wiring_says_who_plays_a_role(self):
        self.board.declare("(relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role))")
        self.refused("absent", self.board.holder, "coordinator", "eyes")
        self.board.tell("(holder coordinator eyes vision-2 stands-in)")
        self.assertEqual(self.board.holder("coordinator", "eyes"), ("vision-2", "stands-in"))

    def test_a_client_is_served_by_whom_it_is_wired_to_and_by_the_next_in_line(self):
        self.refused("absent", self.board.server, "eyes")
        self.refused("unknown-role", self.board.server, "ears")
        self.board.declare("(relation agent ((name symbol) (kind symbol) (host string)) (key name))",
                           "(relation bound ((parent list) (name symbol) (kind symbol) (agent symbol)) (key parent name))",
                           "(relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))")
        for eyes in ("vision", "vision-2", "vision-3"):
            self.board.tell(f'(agent {eyes} vision "here")')
            self.board.tell(f"(bound (cell eyes) {eyes} vision {eyes})")
        self.assertEqual(self.board.server("eyes"), "vision")
        self.board.tell(f"(wired {self.board.teller} eyes vision-2)")
        self.assertEqual(self.board.server("eyes"), "vision-2")
        self.board.retract("(agent vision-2 ? ?)")
        self.assertEqual(self.board.server("eyes"), "vision-3")
        self.board.retract("(agent vision-3 ? ?)")
        self.assertEqual(self.board.server("eyes"), "vision")


class Contracts(BoardTest):
    def setUp(self):
        pass  # without a board

    def test_one_that_is_none_says_why(self):
        for symbol, parts in (("bad-contract", {"offers": ["count"]}), ("bad-contract", {"offers": ["(count ...)"]}),
                              ("wrong-shape", {"offers": ["(count n)"]}), ("wrong-shape", {"offers": ["(count (n real))"]}),
                              ("wrong-shape", {"posts": ["(passed n)"]}), ("bad-datum", {"reads": [Symbol("a b")]})):
            with self.assertRaises(Failure) as caught:
                Contract("counter", **parts)
            self.assertEqual(caught.exception.symbol, symbol, parts)

    def test_operations_are_checked_as_an_agent_in_cpp_checks_them(self):
        contract = Contract("c", offers=["(none)", "(two (a symbol) (b number))", "(goal (fact list) ...)"])
        for text in ("(none)", "(two x 1)", "(two x 1.5)", "(goal)", "(goal (a))", "(goal (a) (b))"):
            contract.check(read(text))
        for text in ("(none 1)", '(two "x" 1)', "(two x y)", "(goal a)", "(two x 1 2)"):
            self.refused("wrong-shape", contract.check, read(text))
        for text in ("(what)", "()", "5"):
            self.refused("unknown-operation", contract.check, read(text))


class WhatThePagesShow(AgentTest):
    def text_of(self, file):
        with open(os.path.join(os.path.dirname(__file__), "../../..", file), encoding="utf-8") as opened:
            return opened.read()

    def code_of(self, page, with_line):
        """The one piece of Python on the page that has the line."""
        [code] = [code for code in re.findall("```python\n(.*?)```", self.text_of(page), re.DOTALL) if with_line in code]
        return code

    def block(self, state):
        self.board.tell(f"(barrier exit {state})")

    def test_the_example_counts(self):
        self.start_agent(program=self.text_of("examples/own-agent-python/counter.py"))
        self.assertEqual(self.values("(count)"), [0])
        for count in (1, 2):
            self.block("blocked")
            self.board.await_answer(f"(passed {count})", PATIENCE)
            self.block("free")
        self.assertEqual(self.values("(count)"), [2])

    def test_the_agent_of_the_page_counts(self):
        self.start_agent(program=self.code_of("docs/python.md", 'Agent("counter"'))
        self.assertEqual(self.values("(count)"), [0])
        self.block("blocked")
        self.board.await_answer("(passed 1)", PATIENCE)
        self.refused("too-low", self.values, "(reset -1)")
        self.assertEqual(self.values("(reset 5)"), [])
        self.assertEqual(self.values("(count)"), [5])

    def test_the_lamp_of_the_tutorial_is_red_while_an_arm_moves(self):
        self.start_agent(program=self.code_of("docs/tutorial.md", 'Agent("lamp"'))
        self.assertEqual(self.values("(colour)", "lamp"), [Symbol("green")])
        self.board.declare("(relation arm ((robot symbol) (state symbol) (action string)) (key robot))")
        for state, colour in (("moving", "red"), ("idle", "green")):
            self.board.tell(f'(arm robot {state} "")')
            self.board.await_answer(f"(lamp {colour})", PATIENCE)
            self.assertEqual(self.values("(colour)", "lamp"), [Symbol(colour)])

    def test_every_piece_of_python_on_the_pages_is_python(self):
        for page in ("docs/python.md", "docs/tutorial.md"):
            pieces = re.findall("```python\n(.*?)```", self.text_of(page), re.DOTALL)
            self.assertTrue(pieces)
            for piece in pieces:
                compile(textwrap.dedent(piece), page, "exec")


a_board.run(__name__)
