"""What is printed on a sheet, in millimetres, and how a sheet at some place looks to a camera.

    sheet = Sheet(shape_texture("square"), pose)
    colour, cover = sheet.seen(camera)            # of every pixel: the sheet's light, and how much of it the sheet fills
"""

import functools

import cv2
import numpy as np

MARK_MM = 40.0
SHEET_MM = 64.0
PAPER = 0.88
INK = 0.06
FINEST_PX_A_MM = 8
# A pixel's light is the mean of so many samples along and across.
SAMPLES = 4


def regular(corners, radius, turn=0.0):
    angles = turn + 2 * np.pi * np.arange(corners) / corners
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def rounded_square(half, corner):
    arc = np.linspace(0, np.pi / 2, 16)
    quarter = (half - corner) + corner * np.stack([np.cos(arc), np.sin(arc)], axis=1)
    out = []
    for turn in range(4):
        c, s = np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)
        out.append(quarter @ np.array([[c, s], [-s, c]]))
    return np.concatenate(out)


def outline(name):
    """The outline as a polygon, its centroid at 0, y down as in images."""
    half = MARK_MM / 2
    arm = MARK_MM / 6
    shapes = {
        "circle": lambda: regular(180, half),
        "square": lambda: regular(4, half * np.sqrt(2), np.pi / 4),
        "triangle": lambda: regular(3, half * 1.15, -np.pi / 2),
        "cross": lambda: np.array([(-arm, -half), (arm, -half), (arm, -arm), (half, -arm), (half, arm), (arm, arm),
                                   (arm, half), (-arm, half), (-arm, arm), (-half, arm), (-half, -arm), (-arm, -arm)]),
        "heptagon": lambda: regular(7, half),
        "octagon": lambda: regular(8, half),
        "rounded-square": lambda: rounded_square(half, half * 0.4),
        "ellipse": lambda: regular(180, half) * (1, 0.6),
        "trapezoid": lambda: np.array([(-half, half), (half, half), (0.6 * half, -half), (-0.6 * half, -half)]),
        "parallelogram": lambda: np.array([(-half, half), (0.5 * half, half), (half, -half), (-0.5 * half, -half)]),
    }
    points = shapes[name]()
    return points - centroid(points)


def centroid(points):
    following = np.roll(points, -1, axis=0)
    cross = points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]
    return ((points + following) * cross[:, None]).sum(axis=0) / (3 * cross.sum())


def reduced(texture):
    """The same at several scales, the finest first, as px a mm and levels."""
    out = [(FINEST_PX_A_MM, texture)]
    while out[-1][0] > 1:
        scale, finer = out[-1]
        out.append((scale // 2, cv2.resize(finer, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)))
    return out


def filled(points, side):
    """How much of each pixel the polygon fills: exactly along rows, by four lines a pixel across them. cv2.fillPoly
    fills half a pixel more along one side, which moves every mark."""
    lines = 4
    ends = np.arange(side) + 1.0
    out = np.zeros((side, side), np.float32)
    following = np.roll(points, -1, axis=0)
    for row in range(side * lines):
        y = (row + 0.5) / lines
        crosses = (points[:, 1] <= y) != (following[:, 1] <= y)
        start, end = points[crosses], following[crosses]
        along = np.sort(start[:, 0] + (y - start[:, 1]) / (end[:, 1] - start[:, 1]) * (end[:, 0] - start[:, 0]))
        for begin, stop in along.reshape(-1, 2):
            out[row // lines] += np.clip(ends - begin, 0, 1) - np.clip(ends - stop, 0, 1)
    return out / lines


@functools.lru_cache(maxsize=None)
def shape_texture(name):
    side = int(SHEET_MM * FINEST_PX_A_MM)
    inked = filled((outline(name) + SHEET_MM / 2) * FINEST_PX_A_MM, side)
    return reduced(PAPER + (INK - PAPER) * inked)


@functools.lru_cache(maxsize=None)
def tag_texture(family, number):
    known = {"4x4": (cv2.aruco.DICT_4X4_50, 6), "36h11": (cv2.aruco.DICT_APRILTAG_36h11, 8)}
    dictionary, cells = known[family]
    drawn = cv2.aruco.drawMarker(cv2.aruco.getPredefinedDictionary(dictionary), number, cells)
    side = int(SHEET_MM * FINEST_PX_A_MM)
    at = (np.arange(side) + 0.5) / FINEST_PX_A_MM - SHEET_MM / 2
    cell = np.floor((at + MARK_MM / 2) * cells / MARK_MM).astype(int)
    inside = (cell >= 0) & (cell < cells)
    cell = np.clip(cell, 0, cells - 1)
    dark = (drawn[np.ix_(cell, cell)] == 0) & inside[:, None] & inside[None, :]
    return reduced(np.where(dark, np.float32(INK), np.float32(PAPER)))


class Sheet:
    """Its middle is at `place` (mm, camera frame), its axes are the columns of `turn`."""

    def __init__(self, texture, turn, place, colour=(1.0, 1.0, 1.0)):
        self.texture = texture
        self.turn = turn
        self.place = place
        self.colour = np.array(colour, np.float32)

    def points(self, plane_mm):
        plane = np.atleast_2d(np.asarray(plane_mm, float))
        return self.place + plane @ self.turn[:, :2].T

    def paint(self, image, camera):
        """Draws the sheet into the image, 3 channels of light."""
        half = SHEET_MM / 2
        edge = np.linspace(-half, half, 9)
        border = np.concatenate([np.stack([edge, np.full(9, s)], 1) for s in (-half, half)] +
                                [np.stack([np.full(9, s), edge], 1) for s in (-half, half)])
        seen = camera.project(self.points(border))
        height, width = image.shape[:2]
        first = np.clip(np.floor(seen.min(axis=0)).astype(int) - 1, 0, (width, height))
        end = np.clip(np.ceil(seen.max(axis=0)).astype(int) + 2, 0, (width, height))
        if (end <= first).any():
            return
        across = (np.arange((end[0] - first[0]) * SAMPLES) + 0.5) / SAMPLES - 0.5 + first[0]
        down = (np.arange((end[1] - first[1]) * SAMPLES) + 0.5) / SAMPLES - 0.5 + first[1]
        # From a pixel to the plane: its sight meets the sheet.
        to_plane = np.linalg.inv(np.column_stack([self.turn[:, :2], self.place - camera.place]))
        plane = camera.sights(across, down) @ to_plane.T
        plane = plane[..., :2] / plane[..., 2:]
        scale_here = np.ptp(seen[:, 0]) * SAMPLES / SHEET_MM
        px_a_mm, texture = min(self.texture, key=lambda level: abs(np.log(level[0] / max(scale_here, 0.1))))
        at = ((plane + half) * px_a_mm - 0.5).astype(np.float32)
        level = cv2.remap(texture, at[..., 0], at[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        cover = (np.abs(plane) <= half).all(axis=-1).astype(np.float32)
        size = (int(end[0] - first[0]), int(end[1] - first[1]))
        share = cv2.resize(cover, size, interpolation=cv2.INTER_AREA)[..., None]
        light = cv2.resize(level * cover, size, interpolation=cv2.INTER_AREA)[..., None] * self.colour
        part = image[first[1]:end[1], first[0]:end[0]]
        part *= 1 - share
        part += light
