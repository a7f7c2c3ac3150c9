"""A detector of one's own in the eyes' role: it takes the camera's images, finds marks in them by itself (marks.py),
and tells looks as the cell's eyes do (docs/facts/vision.md, One look).

    ./pizarra up examples/01-blocks/cell.scm                                  prints the board's address
    PYTHONPATH=blackboard/python python3 examples/13-own-eyes/detector.py BOARD-ADDRESS
    ./pizarra tell '(wired coordinator eyes detector)'                        the next look comes from here
"""

import time

from marks import NAMES, find_marks
from pizarra import Agent, Failure, Symbol
from pizarra.look import RELATION, CameraModel, found, known, look

CAMERA = "vision"  # whose images are looked at
SIDES = ("left", "right")
LATE_S = 0.5  # without images this long, nothing is seen any more
OFF_PX = 0.2  # by how much a disparity may be off

agent = Agent("detector", kind="vision", context="eyes",
              posts=[RELATION,
                     "(relation camera-model ((eyes symbol) (width integer) (height integer) (focal number) (cx number)"
                     " (cy number) (base-line number)) (key eyes))"],
              reads=["stream"])
camera = []   # its model: width, height, focal length, middle, base line
tracked = []  # names
streams = {}  # by side, while somebody is connected
frames = {}   # the newest of each side
looked = 0.0  # when, last


@agent.watches(f"(camera-model {CAMERA} ? ? ? ? ? ?)")
async def model(change):
    for answer in change.added:
        camera[:] = answer.facts[0].datum[2:]
        await agent.tell([Symbol("camera-model"), Symbol(agent.name), *camera])


@agent.operation("(connect)")
async def connect():
    await agent.board.request(CAMERA, "(connect)", timeout=2)
    for side in SIDES:
        if side not in streams:
            streams[side] = agent.board.stream(f"{CAMERA}-{side}")


@agent.operation("(get-objects)")
def get_objects():
    return known(NAMES)


@agent.operation("(track (name string))")
def track(name):
    if name not in NAMES:
        raise Failure("not-learned", f"the detector knows no {name}", name)
    if name not in tracked:
        tracked.append(name)


@agent.operation("(find (name string))")
def find(name):
    return found(name, sightings().get(name))


@agent.operation("(end-track)")
async def end_track():
    tracked.clear()
    await agent.board.retract([*map(Symbol, ("look", agent.name, "?", "?", "?"))])


@agent.every(0.02)
async def look_on():
    """Where there is a new pair, or has been none for too long."""
    global looked
    new = False
    for side, stream in streams.items():
        frame = stream.poll()
        if frame:
            frames[side], new = frame, True
    if not tracked or not camera:
        return
    pair = len(frames) == 2 and frames["left"].number == frames["right"].number
    if new and pair:
        await tell_look(sightings())
    elif frames and time.monotonic() - looked > LATE_S:
        await tell_look({})
        await connect_again()
    else:
        return
    looked = time.monotonic()


async def connect_again():
    """To a camera whose agent was started again."""
    try:
        await connect()
    except Failure as failure:
        if failure.symbol not in ("timeout", "absent", "unreachable"):
            raise


def sightings():
    if len(frames) < 2 or not camera:
        return {}
    left, right = (find_marks(frames[side].pixels, frames[side].width, frames[side].height) for side in SIDES)
    model = CameraModel(*camera)
    seen = {}
    for name in left.keys() & right.keys():
        one, other = left[name], right[name]
        disparity = one.x - other.x
        if disparity > 1 and abs(one.y - other.y) < 2:
            z = model.focal * model.base_line / disparity
            x = (one.x - model.cx) * z / model.focal - model.base_line / 2
            y = (one.y - model.cy) * z / model.focal
            seen[name] = model.sighting((x, y, z), min(one.confidence, other.confidence), z * OFF_PX / disparity)
    return seen


async def tell_look(seen):
    await agent.tell(look(agent.name, frames["left"].number, tracked, seen))


if __name__ == "__main__":
    agent.main()
