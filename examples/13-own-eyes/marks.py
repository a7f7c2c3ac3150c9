"""The marks of the cell's cubes and gripper, found by their outlines in one grey image.

    for name, mark in find_marks(frame.pixels, frame.width, frame.height).items():
        print(name, mark.x, mark.y, mark.confidence)

Dark marks stand on a bright face, and the gripper's bright triangle on a dark plate. This stands where a trained
network would: whatever answers a name, a middle and a confidence will do.
"""

import re
from typing import NamedTuple

DARK = 85  # grey; brighter is bright
SMALLEST = 60  # pixels
FRAME = 3  # pixels from a mark to what must be of the other tone
# A shape: how much of its box it fills, and how far its middle lies below the box's, in heights.
SHAPES = {"square": (1.0, 0.0), "circle": (0.785, 0.0), "cross": (0.556, 0.0), "triangle": (0.5, 0.167)}
TONES = bytes(ord("d" if grey < DARK else "b") for grey in range(256))
NAMES = ("end-effector", *SHAPES)


class Mark(NamedTuple):
    x: float
    y: float
    area: int
    confidence: float


class Blob:
    """Runs of one tone that touch each other."""

    def __init__(self):
        self.area = self.sum_x = self.sum_y = 0
        self.left = self.top = 1 << 30
        self.right = self.bottom = -1

    def add(self, y, begin, end):
        count = end - begin
        self.area += count
        self.sum_x += count * (begin + end - 1) / 2
        self.sum_y += count * y
        self.left, self.right = min(self.left, begin), max(self.right, end - 1)
        self.top, self.bottom = min(self.top, y), max(self.bottom, y)

    def take(self, other):
        self.area, self.sum_x, self.sum_y = self.area + other.area, self.sum_x + other.sum_x, self.sum_y + other.sum_y
        self.left, self.right = min(self.left, other.left), max(self.right, other.right)
        self.top, self.bottom = min(self.top, other.top), max(self.bottom, other.bottom)


def blobs_of(tones, width, height, tone):
    """Of this tone, a byte in `tones`."""
    runs, found, above = re.compile(tone + b"+"), [], []
    for y in range(height):
        row = []
        for run in runs.finditer(tones, y * width, (y + 1) * width):
            begin, end = run.start() - y * width, run.end() - y * width
            touching = {id(each[2]): each[2] for each in above if each[0] < end and begin < each[1]}
            blob, *others = touching.values() or [Blob()]
            if not touching:
                found.append(blob)
            for other in others:
                blob.take(other)
                found.remove(other)
                above = [(b, e, blob if of is other else of) for b, e, of in above]
                row = [(b, e, blob if of is other else of) for b, e, of in row]
            blob.add(y, begin, end)
            row.append((begin, end, blob))
        above = row
    return found


def shape_of(blob):
    """The name of the shape, and how like it is, from 0 to 1; or None."""
    wide, high = blob.right - blob.left + 1, blob.bottom - blob.top + 1
    if blob.area < SMALLEST or not 0.75 < wide / high < 1.35:
        return None
    fills = blob.area / (wide * high)
    low = (blob.sum_y / blob.area - (blob.top + blob.bottom) / 2) / high
    unlike = {name: abs(fills - fill) + abs(low - below) for name, (fill, below) in SHAPES.items()}
    name = min(unlike, key=unlike.get)
    return (name, 1 - unlike[name]) if unlike[name] < 0.15 else None


def stands_out(blob, tones, width, height):
    """What is on both sides of it, at its foot, is of the other tone."""
    left, right = blob.left - FRAME, blob.right + FRAME
    if left < 0 or right >= width or blob.top < FRAME or blob.bottom + FRAME >= height:
        return False
    own = tones[blob.bottom * width + round(blob.sum_x / blob.area)]
    return all(tones[y * width + x] != own for y in (blob.bottom, blob.bottom + FRAME) for x in (left, right))


def find_marks(pixels, width, height):
    """By name; the largest of each."""
    found = {}
    tones = pixels.translate(TONES)
    for tone in (b"d", b"b"):
        for blob in blobs_of(tones, width, height, tone):
            shape = shape_of(blob)
            if shape is None or not stands_out(blob, tones, width, height):
                continue
            name, confidence = shape
            if tone == b"b":
                if name != "triangle":
                    continue
                name = "end-effector"
            if name not in found or found[name].area < blob.area:
                found[name] = Mark(blob.sum_x / blob.area, blob.sum_y / blob.area, blob.area, confidence)
    return found
