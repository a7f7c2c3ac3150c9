#!/usr/bin/python3
"""Photographs with known truth, to judge the eyes by: sheets with shapes, and the same places with tags, before
photographs of the real world. Nothing here is shared with the renderers of the tests and the simulated cell.

    make_photographs.py FOLDER --seed 1 --scenes 125

FOLDER/truth.txt has a line for every mark:
    CONDITION PHOTO KIND NAME X Y HIDDEN  PLACE-X PLACE-Y PLACE-Z  R11 R12 ... R33
X and Y are where the mark's centroid is seen, px, pixel (0, 0) being around 0 0; HIDDEN is the part of its area that
something covers; PLACE is that centroid in the camera's frame, mm, and R its axes: right, down and away from the camera
when it is seen from the front. KIND is `shapes`, `4x4` or `36h11`. Of `learning` and `pair` the right image is PHOTO
with -right before its ending; its camera is 80 mm beside. A photo without marks has the NAME `-`.
"""

import argparse
import glob
import os
import sys

import cv2
import numpy as np

import camera
import sheets

LEARNED = ("circle", "square", "cross", "triangle")
UNLEARNED = ("heptagon", "octagon", "rounded-square", "ellipse", "trapezoid", "parallelogram")
BASE_LINE_MM = 80.0
SAMPLES_OF_DEBIAN = "/usr/share/doc/opencv-doc/examples/data/"
# Photographs of the world, not drawings; boards and logos are none.
NO_BACKGROUNDS = ("left0", "left1", "right0", "right1", "pic", "chessboard", "logo", "Logo", "mask", "gradient", "digits",
                  "imageText", "notes", "ml.png", "tmpl", "templ", "aloeGT", "detect_blob", "text_", "Suzanne")


def around(axis, angle):
    turn, _ = cv2.Rodrigues(np.asarray(axis, float) / np.linalg.norm(axis) * angle)
    return turn


class Ranges:
    """What a condition draws its scenes from."""

    def __init__(self, tilt=(0, 15), depth=(400, 600), **others):
        self.tilt = tilt
        self.depth = depth
        self.others = others

    def draw(self, name, random, usual):
        low, high = self.others.get(name, usual)
        return random.uniform(low, high)


MIXED = dict(gain=(0.5, 1.2), slope=(0, 0.5), motion=(0, 3), defocus=(0, 1.2), shadow=(0.4, 0.7), shadow_share=0.3,
             quality=(30, 95), read_noise=(1, 4), k1=(-0.2, 0.05), clutter=(0, 6))
CONDITIONS = {
    "frontal": Ranges(),
    "light": Ranges(gain=(0.4, 1.5)),
    "gradient": Ranges(slope=(0.6, 1.4)),
    "low-light": Ranges(gain=(0.2, 0.35), read_noise=(1.5, 3)),
    "noise": Ranges(read_noise=(5, 12)),
    "jpeg": Ranges(quality=(10, 30)),
    "distorted": Ranges(k1=(-0.3, -0.3)),
    "motion": Ranges(motion=(3, 10)),
    "defocus": Ranges(defocus=(1.5, 3)),
    "tilted": Ranges(tilt=(30, 55)),
    "shadow": Ranges(shadow=(0.4, 0.7), shadow_share=1),
    "bars": Ranges(bars=(0.3, 0.6)),
    "glare": Ranges(glare=(0.1, 0.5)),
    "far": Ranges(depth=(800, 1200)),
    "near": Ranges(depth=(260, 400), places=1),
    "clutter": Ranges(clutter=(6, 14)),
    "mixed": Ranges(tilt=(0, 45), depth=(400, 800), **MIXED),
    "pair": Ranges(tilt=(0, 45), depth=(400, 900)),
    "quarter-covered": Ranges(covered=(0.15, 0.3)),
    "half-covered": Ranges(covered=(0.4, 0.55)),
    "unlearned": Ranges(tilt=(0, 30)),
    "bare": Ranges(),
}
SHAPES_ALONE = ("quarter-covered", "half-covered", "unlearned", "bare")


def backgrounds():
    out = []
    for path in sorted(glob.glob(SAMPLES_OF_DEBIAN + "*.jpg") + glob.glob(SAMPLES_OF_DEBIAN + "*.png")):
        if any(os.path.basename(path).startswith(no) or no in os.path.basename(path) for no in NO_BACKGROUNDS):
            continue
        image = cv2.imread(path)
        if image is not None and min(image.shape[:2]) >= 250:
            out.append(image.astype(np.float32) / 255)
    return out


def background(photos, random):
    photo = photos[random.integers(len(photos))]
    height, width = photo.shape[:2]
    part = random.uniform(0.6, 1.0)
    fit = min(width / camera.WIDTH, height / camera.HEIGHT) * part
    w, h = int(camera.WIDTH * fit), int(camera.HEIGHT * fit)
    x, y = random.integers(width - w + 1), random.integers(height - h + 1)
    out = cv2.resize(photo[y:y + h, x:x + w], (camera.WIDTH, camera.HEIGHT), interpolation=cv2.INTER_LINEAR)
    if random.random() < 0.5:
        out = out[:, ::-1]
    return np.ascontiguousarray(out * random.uniform(0.6, 1.0))


def pose(ranges, middle_px, lens, random, tilt=None):
    depth = random.uniform(*ranges.depth)
    tilt = np.radians(random.uniform(*ranges.tilt))
    lies = random.uniform(0, 2 * np.pi)
    turn = around((np.cos(lies), np.sin(lies), 0), tilt) @ around((0, 0, 1), random.uniform(0, 2 * np.pi))
    sight = lens.sights(np.array([middle_px[0]]), np.array([middle_px[1]]))[0, 0]
    return turn, sight * depth + lens.place


def places(ranges, count, right_too, random):
    """Middles of sheets that neither meet nor reach the image's border."""
    if ranges.others.get("places") == 1:
        order = [(camera.WIDTH / 2, camera.HEIGHT / 2)]
        room = [(140, 70)]
    else:
        order = [(x, y) for y in (120, 360) for x in (160, 480)]
        room = [(70, 40)] * 4
    if right_too:
        order = [(x + 40 if x < 320 else x, y) for x, y in order]
    out = []
    for middle, free in zip(order[:count], room):
        out.append((middle[0] + random.uniform(-1, 1) * free[0], middle[1] + random.uniform(-1, 1) * free[1]))
    return out


def in_pixels(shape):
    return np.meshgrid(np.arange(shape[1]), np.arange(shape[0]))


def illuminate(light, ranges, marks, random):
    """A slope of light, the hard edge of a shadow across a mark, and a lamp's reflection on the sheets."""
    x, y = in_pixels(light.shape)
    slope = ranges.draw("slope", random, (0, 0.1))
    angle = random.uniform(0, 2 * np.pi)
    along = (x - light.shape[1] / 2) * np.cos(angle) + (y - light.shape[0] / 2) * np.sin(angle)
    light *= (1 + slope * along / light.shape[1])[..., None].astype(np.float32)
    if random.random() < ranges.others.get("shadow_share", 0):
        # Over a part of the image, its edge near one of the sheets.
        near = np.array(marks[random.integers(len(marks))]) + random.uniform(-30, 30, 2)
        taken = random.uniform(*ranges.others["shadow"])
        angle = random.uniform(0, 2 * np.pi)
        beyond = (x - near[0]) * np.cos(angle) + (y - near[1]) * np.sin(angle)
        shade = taken * np.clip(beyond / random.uniform(0.5, 2.5) + 0.5, 0, 1)
        light *= (1 - shade)[..., None].astype(np.float32)
    for middle in marks:
        if "bars" in ranges.others:
            # What throws it is slim: both of its edges cross the sheet.
            taken = random.uniform(*ranges.others["bars"])
            angle = random.uniform(0, 2 * np.pi)
            beyond = (x - middle[0]) * np.cos(angle) + (y - middle[1]) * np.sin(angle) - random.uniform(-30, 30)
            wide = random.uniform(15, 60)
            shade = taken * np.clip((wide / 2 - np.abs(beyond)) / random.uniform(0.5, 2.5) + 0.5, 0, 1)
            shade *= np.hypot(x - middle[0], y - middle[1]) < 120
            light *= (1 - shade)[..., None].astype(np.float32)
        if "glare" in ranges.others:
            bright = random.uniform(*ranges.others["glare"])
            at = np.array(middle) + random.uniform(-35, 35, 2)
            wide, high = random.uniform(10, 40, 2)
            light += (bright * np.exp(-((x - at[0]) / wide)**2 - ((y - at[1]) / high)**2))[..., None].astype(np.float32)


def scatter(image, middles, count, random):
    """Printed and cut things between the sheets: no shape that is learned, or too small for one."""
    for _ in range(count):
        middle = np.array([random.uniform(0, camera.WIDTH), random.uniform(0, camera.HEIGHT)])
        if any(np.hypot(*(middle - m)) < 85 for m in middles):
            continue
        corners = random.integers(4, 10)
        angles = np.sort(random.uniform(0, 2 * np.pi, corners))
        reach = random.uniform(6, 26) * random.uniform(0.4, 1.0, corners)
        points = middle + np.stack([reach * np.cos(angles), reach * np.sin(angles)], 1)
        if random.random() < 0.5:
            half = int(random.uniform(20, 40))
            low, high = (middle - half).astype(int), (middle + half).astype(int)
            cv2.rectangle(image, tuple(map(int, low)), tuple(map(int, high)), (sheets.PAPER, ) * 3, -1)
        colour = tuple(float(c) for c in random.uniform(0.03, 0.5, 3))
        cv2.fillPoly(image, [np.round(points * 16).astype(np.int32)], colour, cv2.LINE_AA, 4)


def cover(image, sheet, outline_mm, lens, share, photo, random):
    """Lays a piece of a photograph over so much of the mark's area, from one side; tells how much it was."""
    angle = random.uniform(0, 2 * np.pi)
    seen = lens.project(sheet.points(outline_mm))
    finer = 4
    x, y = np.meshgrid((np.arange(camera.WIDTH * finer) + 0.5) / finer - 0.5,
                       (np.arange(camera.HEIGHT * finer) + 0.5) / finer - 0.5)
    inside = np.zeros(x.shape, np.uint8)
    cv2.fillPoly(inside, [np.round(((seen + 0.5) * finer - 0.5) * 16).astype(np.int32)], 1, cv2.LINE_8, 4)
    along = x * np.cos(angle) + y * np.sin(angle)
    within = np.sort(along[inside > 0])
    edge = within[int((1 - share) * len(within))]
    middle = seen.mean(axis=0)
    hides = (along > edge) & (np.hypot(x - middle[0], y - middle[1]) < 75)
    part = cv2.resize(hides.astype(np.float32), (camera.WIDTH, camera.HEIGHT), interpolation=cv2.INTER_AREA)[..., None]
    image *= 1 - part
    image += part * photo
    return float((hides & (inside > 0)).sum()) / max(1, len(within))


class Maker:
    def __init__(self, folder, seed):
        self.folder = folder
        self.seed = seed
        self.photos = backgrounds()
        if not self.photos:
            sys.exit("make_photographs.py: there are no photographs in " + SAMPLES_OF_DEBIAN + ": install opencv-doc")
        self.truth = open(os.path.join(folder, "truth.txt"), "w", encoding="ascii")

    def note(self, condition, photo, kind, name, sheet, lens, hidden=0.0):
        centre = lens.project(sheet.points((0, 0)))[0]
        numbers = [*centre, hidden, *sheet.place, *sheet.turn.ravel()]
        print(condition, photo, kind, name, *(f"{n:.6f}" for n in numbers), file=self.truth)

    def write(self, name, grey, quality=95):
        cv2.imwrite(os.path.join(self.folder, name), grey, [cv2.IMWRITE_JPEG_QUALITY, int(quality)])

    def look(self, ranges, random):
        motion = ranges.draw("motion", random, (0, 0))
        return dict(lens_px=random.uniform(0.45, 0.8), motion_px=motion, motion_rad=random.uniform(0, np.pi),
                    defocus_px=ranges.draw("defocus", random, (0, 0)), gain=ranges.draw("gain", random, (0.8, 1.05)),
                    read_noise=ranges.draw("read_noise", random, (0.8, 2)), shot_noise=0.02)

    def learning(self):
        """A photograph of the four from the front, half a metre away, by either camera of a pair."""
        random = np.random.default_rng([self.seed, 0])
        lens = camera.Camera()
        beside = camera.Camera(0, (BASE_LINE_MM, 0, 0))
        left = np.full((camera.HEIGHT, camera.WIDTH, 3), 0.45, np.float32)
        right = left.copy()
        for middle, name in zip([(160, 120), (480, 120), (160, 360), (480, 360)], LEARNED):
            place = lens.sights(np.array([middle[0] + 0.3]), np.array([middle[1] + 0.4]))[0, 0] * 500
            sheet = sheets.Sheet(sheets.shape_texture(name), np.eye(3), place)
            sheet.paint(left, lens)
            sheet.paint(right, beside)
            self.note("learning", "learning.jpg", "shapes", name, sheet, lens)
        look = self.look(Ranges(), random)
        self.write("learning.jpg", camera.photograph(left, look, random))
        self.write("learning-right.jpg", camera.photograph(right, look, random))

    def scene(self, condition, number):
        ranges = CONDITIONS[condition]
        index = list(CONDITIONS).index(condition)
        seed = [self.seed, index + 1, number]
        kinds = ("shapes", ) if condition in SHAPES_ALONE else ("shapes", "4x4", "36h11")
        for kind in kinds:
            # The same draws for every kind.
            self.scene_of(condition, number, kind, ranges, np.random.default_rng(seed))

    def scene_of(self, condition, number, kind, ranges, random):
        photo = f"{condition}-{number:04d}-{kind}"
        lens = camera.Camera(ranges.draw("k1", random, (0, 0)))
        image = background(self.photos, random)
        other = background(self.photos, random)
        middles = [] if condition == "bare" else places(ranges, 4, condition == "pair", random)
        names = UNLEARNED if condition == "unlearned" else LEARNED
        chosen = random.permutation(len(names))[:len(middles)]
        set_down = []
        scatter(image, middles, int(ranges.draw("clutter", random, (0, 0.9))), random)
        for middle, index in zip(middles, chosen):
            turn, place = pose(ranges, middle, lens, random)
            tint = 1 + random.uniform(-0.08, 0.04, 3)
            texture = sheets.shape_texture(names[index]) if kind == "shapes" else sheets.tag_texture(kind, int(index))
            set_down.append((names[index], sheets.Sheet(texture, turn, place, tint)))
        hidden = {}
        for name, sheet in set_down:
            sheet.paint(image, lens)
            if "covered" in ranges.others:
                share = random.uniform(*ranges.others["covered"])
                hidden[name] = cover(image, sheet, sheets.outline(name), lens, share, other, random)
        lit = image.copy()
        state = random.bit_generator.state
        illuminate(lit, ranges, [lens.project(sheet.place)[0] for _, sheet in set_down], random)
        look = self.look(ranges, random)
        quality = ranges.draw("quality", random, (95, 95))
        self.write(photo + ".jpg", camera.photograph(lit, look, random), quality)
        if condition == "pair":
            beside = camera.Camera(0, (BASE_LINE_MM, 0, 0))
            right = np.roll(background(self.photos, np.random.default_rng([self.seed, 99, number])), -30, axis=1)
            for _, sheet in set_down:
                sheet.paint(right, beside)
            random.bit_generator.state = state
            illuminate(right, ranges, [beside.project(sheet.place)[0] for _, sheet in set_down], random)
            self.write(photo + "-right.jpg", camera.photograph(right, look, random))
        for name, sheet in set_down:
            self.note(condition, photo + ".jpg", kind, name, sheet, lens, hidden.get(name, 0.0))
        if not set_down:
            print(condition, photo + ".jpg", kind, "-", *["0"] * 15, file=self.truth)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scenes", type=int, default=125, help="of each condition (default 125)")
    parser.add_argument("--only", action="append", choices=list(CONDITIONS), help="these conditions alone")
    arguments = parser.parse_args()
    cv2.setNumThreads(1)
    os.makedirs(arguments.folder, exist_ok=True)
    maker = Maker(arguments.folder, arguments.seed)
    maker.learning()
    for condition in arguments.only or CONDITIONS:
        for number in range(arguments.scenes):
            maker.scene(condition, number)
    maker.truth.close()


if __name__ == "__main__":
    main()
