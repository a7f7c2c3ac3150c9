#!/usr/bin/python3
"""Films with known truth, to judge by how the eyes follow marks: four sheets that move before a photograph of the real
world, while the light changes, a shadow's edge passes, and now and then something covers one of them.

    make_films.py FOLDER --seed 1 --films 20 --frames 300

FOLDER/truth.txt begins with the lines of the photograph to learn from, as make_photographs.py writes them. Then it has
a line for every sheet in every frame; its condition is FILM, film-000 and so on. FRAME-right.jpg is beside every second
film's FRAME.jpg: a pair took it.
"""

import argparse
import os

import cv2
import numpy as np

import camera
import make_photographs as still
import sheets

FRAMES_A_SECOND = 30
MOST_TILT = np.radians(50)


class Wander:
    """A smooth way through a range: three slow waves."""

    def __init__(self, low, high, random, slowest=8.0, fastest=20.0):
        self.middle, self.half = (low + high) / 2, (high - low) / 2
        self.periods = random.uniform(slowest, fastest, 3)
        self.phases = random.uniform(0, 2 * np.pi, 3)

    def at(self, seconds):
        return self.middle + self.half * np.sin(2 * np.pi * seconds / self.periods + self.phases).mean()


class MovingSheet:
    def __init__(self, name, corner, random):
        self.name = name
        self.texture = sheets.shape_texture(name)
        self.tint = 1 + random.uniform(-0.08, 0.04, 3)
        self.x = Wander(corner[0] - 60, corner[0] + 60, random)
        self.y = Wander(corner[1] - 35, corner[1] + 35, random)
        self.depth = Wander(420, 700, random)
        self.lean = [Wander(-MOST_TILT, MOST_TILT, random) for _ in range(2)]
        self.roll = Wander(-np.pi, np.pi, random)

    def at(self, seconds, lens):
        sight = lens.sights(np.array([self.x.at(seconds)]), np.array([self.y.at(seconds)]))[0, 0]
        lean = np.array([lean.at(seconds) for lean in self.lean] + [0.0])
        tilt = np.linalg.norm(lean)
        tilted = still.around(lean, min(tilt, MOST_TILT)) if tilt > 1e-6 else np.eye(3)
        turn = tilted @ still.around((0, 0, 1), self.roll.at(seconds))
        return sheets.Sheet(self.texture, turn, sight * self.depth.at(seconds), self.tint)


class Cover:
    """A piece of another photograph passes over a sheet, as far away as that."""

    def __init__(self, sheet, seconds, random):
        self.sheet = sheet
        self.middle = random.uniform(0.2, 0.8) * seconds
        self.angle = random.uniform(0, 2 * np.pi)
        self.px_a_second = random.uniform(40, 120)

    def hides(self, seconds, around):
        x, y = still.in_pixels((camera.HEIGHT, camera.WIDTH))
        along = (x - around[0]) * np.cos(self.angle) + (y - around[1]) * np.sin(self.angle)
        far = np.hypot(x - around[0], y - around[1])
        edge = self.px_a_second * (seconds - self.middle)
        within = np.clip(50 - np.abs(along - edge) + 0.5, 0, 1) * np.clip(90 - far + 0.5, 0, 1)
        return within[..., None].astype(np.float32)


class Film:
    def __init__(self, maker, number, frames):
        self.maker = maker
        self.random = np.random.default_rng([maker.seed, 1000, number])
        self.name = f"film-{number:03d}"
        self.frames = frames
        seconds = frames / FRAMES_A_SECOND
        self.is_pair = number % 2 == 0
        self.cameras = [camera.Camera(), camera.Camera(0, (still.BASE_LINE_MM, 0, 0))][:2 if self.is_pair else 1]
        self.backgrounds = [still.background(maker.photos, self.random) for _ in self.cameras]
        self.other = still.background(maker.photos, self.random)
        corners = [(x, y) for y in (125, 355) for x in (200, 480)]
        self.sheets = [MovingSheet(name, corner, self.random) for name, corner in zip(still.LEARNED, corners)]
        self.covers = [Cover(self.random.integers(4), seconds, self.random) for _ in range(2)]
        self.gain = Wander(0.55, 1.05, self.random)
        self.shade = self.random.uniform(0.3, 0.6)
        self.shade_angle = self.random.uniform(0, 2 * np.pi)
        self.shade_at = Wander(-250, 250, self.random)
        self.motion_px = self.random.uniform(0, 2)
        self.look = maker.look(still.Ranges(read_noise=(1, 4)), self.random)

    def shadow(self, seconds):
        x, y = still.in_pixels((camera.HEIGHT, camera.WIDTH))
        beyond = (x - camera.WIDTH / 2) * np.cos(self.shade_angle) + (y - camera.HEIGHT / 2) * np.sin(self.shade_angle)
        return 1 - self.shade * np.clip((beyond - self.shade_at.at(seconds)) / 1.5 + 0.5, 0, 1)[..., None]

    def make(self):
        for frame in range(self.frames):
            seconds = frame / FRAMES_A_SECOND
            look = {**self.look, "gain": self.gain.at(seconds), "motion_px": self.motion_px}
            photo = f"{self.name}-{frame:04d}"
            for lens, behind, suffix in zip(self.cameras, self.backgrounds, (".jpg", "-right.jpg")):
                self.picture(lens, behind, seconds, look, photo + suffix, suffix == ".jpg")

    def picture(self, lens, behind, seconds, look, photo, tells):
        image = behind.copy()
        for place, moving in enumerate(self.sheets):
            sheet = moving.at(seconds, self.cameras[0])
            sheet.paint(image, lens)
            hidden = 0.0
            for cover in self.covers:
                if cover.sheet != place:
                    continue
                part = cover.hides(seconds, lens.project(sheet.place)[0])
                image *= 1 - part
                image += part * self.other
                hidden = max(hidden, self.hidden(part, sheet, moving.name, lens))
            if tells:
                self.maker.note(self.name, photo, "shapes", moving.name, sheet, lens, hidden)
        image *= self.shadow(seconds).astype(np.float32)
        self.maker.write(photo, camera.photograph(image, look, self.random), 90)

    @staticmethod
    def hidden(part, sheet, name, lens):
        inside = np.zeros(part.shape[:2], np.uint8)
        seen = lens.project(sheet.points(sheets.outline(name)))
        cv2.fillPoly(inside, [np.round(seen * 16).astype(np.int32)], 1, cv2.LINE_8, 4)
        # The sheet's paper counts as well: what lies beside the mark may be taken for its border.
        near = cv2.dilate(inside, np.ones((7, 7), np.uint8))
        if part[near > 0].max(initial=0) == 0:
            return 0.0
        return max(0.001, float(part[inside > 0].mean()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--films", type=int, default=20)
    parser.add_argument("--frames", type=int, default=300)
    arguments = parser.parse_args()
    cv2.setNumThreads(1)
    os.makedirs(arguments.folder, exist_ok=True)
    maker = still.Maker(arguments.folder, arguments.seed)
    maker.learning()
    for number in range(arguments.films):
        Film(maker, number, arguments.frames).make()
    maker.truth.close()


if __name__ == "__main__":
    main()
