"""The package as others have it: installed by pip into an environment of its own, and its types as mypy sees them.

package_test.py PIZARRA-BOARD. What is not there on this machine is skipped, with the reason.
"""

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import a_board
from a_board import NOTE, BoardTest

PACKAGE = os.path.abspath(os.path.join(os.path.dirname(__file__), "../../../blackboard/python"))

USER = '''
import asyncio
from typing import List
from pizarra import Agent, Answer, AsyncBoard, Board, Change, Failure, Frame, Symbol

def names(board: Board) -> List[str]:
    answers: List[Answer] = board.ask("(seen ?name ?x)")
    return [str(answer.bindings["?name"]) for answer in answers]

async def follow(board: AsyncBoard) -> None:
    async for change in board.watch("(seen ?name ?x)"):
        reveal_type(change)

agent = Agent("lamp")

@agent.operation("(blink (times integer))")
async def blink(times: int) -> int:
    reveal_type(await agent.board.tell([Symbol("lamp"), "red"]))
    return times

reveal_type(blink)
'''


class Package(BoardTest):
    def run_in(self, folder, *words):
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_pip_installs_it_without_network_and_it_speaks_with_a_board(self):
        for module, package in (("ensurepip", "python3-venv"), ("setuptools", "python3-setuptools"), ("wheel", "python3-wheel")):
            if importlib.util.find_spec(module) is None:
                self.skipTest(f"{package} is not installed")
        # pip builds where the sources are.
        sources = shutil.copytree(PACKAGE, os.path.join(self.folder, "python"))
        self.run_in(self.folder, sys.executable, "-m", "venv", "--system-site-packages", "venv")
        self.run_in(self.folder, "venv/bin/pip", "install", "--no-build-isolation", "--no-index", "--quiet", sources)
        shutil.rmtree(sources)
        script = ("import sys, pizarra\n"
                  "with pizarra.Board(sys.argv[1], 'installed') as board:\n"
                  f"    board.declare('{NOTE}')\n"
                  "    board.tell('(note 1 a)')\n"
                  "    print(pizarra.__file__, len(board.ask('(note ?n ?)')))\n")
        said = self.run_in(self.folder, "venv/bin/python", "-c", script, self.address)
        self.assertIn("/venv/lib/", said)
        self.assertTrue(said.endswith(" 1\n"), said)
        listed = self.run_in(self.folder, "venv/bin/pip", "show", "--files", "pizarra")
        self.assertIn("pizarra/py.typed", listed)
        self.assertIn("Version: 0.1.0", listed)


class Types(unittest.TestCase):
    def mypy(self, *words):
        if shutil.which("mypy") is None or importlib.util.find_spec("numpy") is None:
            self.skipTest("mypy or python3-numpy is not installed")
        with tempfile.TemporaryDirectory() as folder:
            environment = dict(os.environ, MYPYPATH=PACKAGE)
            return subprocess.run(["mypy", "--strict", "--cache-dir", folder, *words], env=environment, text=True,
                                  capture_output=True, check=False)

    def test_the_package_is_strictly_typed(self):
        checked = self.mypy(os.path.join(PACKAGE, "pizarra"))
        self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_its_user_has_types(self):
        checked = self.mypy("-c", USER)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        for type in ("pizarra.answers.Change", "builtins.int", "def (times: builtins.int) -> typing.Coroutine"):
            self.assertIn(type, checked.stdout)


class Text(unittest.TestCase):
    def test_every_module_opens_with_what_it_is_for(self):
        modules = [name for name in sorted(os.listdir(os.path.join(PACKAGE, "pizarra"))) if name.endswith(".py")]
        self.assertGreater(len(modules), 15)
        for name in modules:
            with open(os.path.join(PACKAGE, "pizarra", name), encoding="utf-8") as file:
                self.assertTrue(file.read().startswith('"""'), name)

    def test_the_version_is_that_of_the_package(self):
        import pizarra
        with open(os.path.join(PACKAGE, "pyproject.toml"), encoding="utf-8") as file:
            self.assertIn(f'version = "{pizarra.__version__}"', file.read())


a_board.run(__name__)
