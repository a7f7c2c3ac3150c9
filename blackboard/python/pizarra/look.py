"""Looks as the cell's eyes tell them (docs/facts/vision.md, One look), for a detector of one's own. It writes the texts
of the thesis' Table C.2 too.

    model = CameraModel(*fact.datum[2:])                 # of (camera-model EYES WIDTH HEIGHT FOCAL CX CY BASE-LINE)
    seen = {"circle": model.sighting((12.0, -4.0, 812.0), confidence=0.98)}   # mm, from the middle of the base line
    await agent.tell(look("detector", frame.number, ["circle", "cross"], seen))

A name that is tracked and not seen is `lost` in the look, and says FAIL in its text.
"""

import math
from dataclasses import dataclass
from typing import Dict, Iterable, List, Optional, Sequence, Tuple

from pizarra.datum import Datum, Symbol

RELATION = "(relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))"

Place = Tuple[float, float]


@dataclass(frozen=True)
class Sighting:
    """Where an object is seen. Places are pixels of the left and the right image."""
    left: Place
    range_mm: float
    confidence: float  # 0 to 1
    right: Optional[Place] = None
    spread_mm: float = 0.0  # the range's standard deviation
    pose: Optional[Sequence[float]] = None  # X Y Z RX RY RZ, mm and degrees
    covariance: Sequence[float] = ()  # its upper triangle, row by row: 21 numbers


@dataclass(frozen=True)
class CameraModel:
    """Of a rectified pair: sizes, focal length and middle in pixels, the base line in mm."""
    width: int
    height: int
    focal: float
    cx: float
    cy: float
    base_line: float

    def sighting(self, pose: Sequence[float], confidence: float, spread_mm: float = 0.0,
                 covariance: Sequence[float] = ()) -> Sighting:
        """Of an object at X Y Z, mm from the middle of the base line: x right, y down, z ahead. With RX RY RZ behind
        them it is told as a pose, too. The range is the straight way there. ValueError: it is not ahead."""
        x, y, z = pose[:3]
        if z <= 0:
            raise ValueError("an object that is seen is ahead of the camera")
        row = self.cy + self.focal * y / z
        half = self.base_line / 2
        left, right = ((self.cx + self.focal * (x + side) / z, row) for side in (half, -half))
        told = tuple(pose) if len(pose) == 6 else None
        return Sighting(left, math.hypot(x, y, z), confidence, right, spread_mm, told, covariance)


def look(eyes: str, frame: int, tracked: Iterable[str], seen: Dict[str, Sighting]) -> List[Datum]:
    """The fact of one look at what is tracked."""
    names = list(tracked)
    text = "".join(f' ("{name}" {_said(seen.get(name))})' for name in names)
    parts: List[Datum] = [[name, *_parts(seen.get(name))] for name in names]
    return [Symbol("look"), Symbol(eyes), frame, f"(TRACK {len(names)}{text})", parts]


def found(name: str, sighting: Optional[Sighting]) -> str:
    """What FIND answers."""
    return f'(FIND "{name}" FAIL)' if sighting is None else f'(FIND "{name}" OK ({_numbers(sighting.left)}))'


def known(names: Sequence[str]) -> str:
    """What GET answers."""
    quoted = ", ".join(f'"{name}"' for name in names)
    return f"(GET {len(names)} ({quoted}))"


def _numbers(values: Iterable[float]) -> str:
    return ", ".join(f"{value:.2f}" for value in values)


def _said(sighting: Optional[Sighting]) -> str:
    return "FAIL" if sighting is None else f"OK ({_numbers((*sighting.left, sighting.range_mm))})"


def _rounded(values: Iterable[float], digits: int = 2) -> List[Datum]:
    return [round(float(value), digits) for value in values]


def _parts(sighting: Optional[Sighting]) -> List[Datum]:
    if sighting is None:
        return [Symbol("lost")]
    out: List[Datum] = [Symbol("seen"), round(float(sighting.confidence), 3), [Symbol("left"), *_rounded(sighting.left)]]
    if sighting.right is not None:
        out.append([Symbol("right"), *_rounded(sighting.right)])
    out.append([Symbol("range"), *_rounded((sighting.range_mm, sighting.spread_mm))])
    if sighting.pose is not None:
        out.append([Symbol("pose"), *_rounded(sighting.pose), _rounded(sighting.covariance, 4)])
    return out
