"""modbus_clients.py PIZARRA-EMULATE: Debian's pymodbus and mbpoll judge the emulated gripper.

Both are written by others. Each activates it, moves its fingers, and reads where they are. A client that is not
installed is told, and the test is skipped (status 77).
"""

import json
import shutil
import subprocess
import sys
import time

UNIT = 9
ORDERS, STATE = 1000, 2000  # the first registers of a Robotiq's orders and of its state
ACTIVATE, GO = 0x0100, 0x0900
READY, ARRIVED = 0x3100, 0xF900
LONGEST = 60  # s, for a machine that is busy


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(77)


def wait_for(state, read):
    end = time.monotonic() + LONGEST
    while (told := read()[0]) != state:
        if time.monotonic() > end:
            raise TimeoutError(f"the gripper tells {told:04x}, and never {state:04x}")
        time.sleep(0.02)


def check_moves(name, read, write):
    """The manual's example: activate, wait until ready, close, wait until there, open again."""
    write([0, 0, 0])
    write([ACTIVATE, 0, 0])
    wait_for(READY, read)
    for wanted in (0xFF, 0x00):
        write([GO, wanted, 0xFFFF])
        # The request is echoed at once; the fingers arrive later.
        assert read()[1] & 0xFF == wanted, f"{name}: the gripper echoes {read()[1]:04x}"
        wait_for(ARRIVED, read)
        position = read()[2] >> 8
        assert abs(position - wanted) <= 3, f"{name}: the fingers stand at {position}, asked for {wanted}"
    print(f"ok: {name} activates the gripper, closes and opens it")


def pymodbus_moves(port):
    try:
        from pymodbus.client import ModbusTcpClient
    except ImportError:
        skip("python3-pymodbus is not installed")
    client = ModbusTcpClient("127.0.0.1", port=port)
    assert client.connect()

    def read():
        answer = client.read_input_registers(STATE, 3, slave=UNIT)
        assert not answer.isError(), answer
        return answer.registers

    def write(registers):
        answer = client.write_registers(ORDERS, registers, slave=UNIT)
        assert not answer.isError(), answer

    check_moves("pymodbus", read, write)
    client.close()


def mbpoll_moves(port):
    program = shutil.which("mbpoll") or skip("mbpoll is not installed")

    def poll(kind, first, *more):
        words = [program, "-m", "tcp", "-p", str(port), "-a", str(UNIT), "-0", "-t", kind, "-r", str(first), "-1", "-q"]
        done = subprocess.run([*words, *more], capture_output=True, text=True, timeout=LONGEST)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def read():
        lines = poll("3:hex", STATE, "-c", "3", "127.0.0.1").splitlines()
        return [int(line.split()[-1], 16) for line in lines if line.startswith("[")]

    def write(registers):
        poll("4", ORDERS, "127.0.0.1", *map(str, registers))

    check_moves("mbpoll", read, write)


def main():
    emulator = subprocess.Popen(
        [sys.argv[1], "emulate", "gripper", "--tcp", "0", "--json"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    )
    try:
        port = int(json.loads(emulator.stdout.readline())["at"].rsplit(":", 1)[1])
        pymodbus_moves(port)
        mbpoll_moves(port)
    finally:
        emulator.terminate()
        emulator.wait()


main()
