"""A camera: where its pixels look, its lens, its sensor with a Bayer pattern, and the JPEG that it sends."""

import cv2
import numpy as np

WIDTH, HEIGHT = 640, 480
FOCAL_PX = 600.0
CENTRE = np.array([319.5, 239.5])


class Camera:
    def __init__(self, k1=0.0, place=(0.0, 0.0, 0.0)):
        self.k1 = k1
        self.place = np.array(place)

    def project(self, points_mm):
        seen = np.atleast_2d(points_mm) - self.place
        flat = seen[:, :2] / seen[:, 2:]
        radius2 = (flat**2).sum(axis=1, keepdims=True)
        return CENTRE + FOCAL_PX * flat * (1 + self.k1 * radius2)

    def sights(self, across, down):
        """The directions (x, y, 1) in which the pixels of these columns and rows look."""
        x, y = np.meshgrid((across - CENTRE[0]) / FOCAL_PX, (down - CENTRE[1]) / FOCAL_PX)
        scale = np.ones_like(x)
        if self.k1:
            # Of the radius before the lens, by what is seen after it: a few Newton steps.
            seen = np.hypot(x, y)
            radius = seen.copy()
            for _ in range(6):
                radius -= (radius * (1 + self.k1 * radius**2) - seen) / (1 + 3 * self.k1 * radius**2)
            scale = np.where(seen > 0, radius / np.maximum(seen, 1e-12), 1)
        return np.stack([x * scale, y * scale, np.ones_like(x)], axis=-1)


def line_kernel(length, angle):
    """Of a motion while the shutter is open."""
    side = int(np.ceil(length)) // 2 * 2 + 3
    finer = 8
    kernel = np.zeros((side * finer, side * finer), np.float32)
    middle = side * finer / 2
    along = np.array([np.cos(angle), np.sin(angle)]) * length / 2 * finer
    ends = [tuple(int(round((middle + sign * a - 0.5) * 16)) for a in along) for sign in (-1, 1)]
    cv2.line(kernel, ends[0], ends[1], 1.0, finer, cv2.LINE_8, 4)
    kernel = cv2.resize(kernel, (side, side), interpolation=cv2.INTER_AREA)
    return kernel / kernel.sum()


def disc_kernel(radius):
    """Of a lens that is out of focus."""
    side = 2 * int(np.ceil(radius)) + 1
    finer = 8
    at = (np.arange(side * finer) + 0.5) / finer - side / 2
    disc = (np.hypot(at[:, None], at[None, :]) <= radius).astype(np.float32)
    kernel = cv2.resize(disc, (side, side), interpolation=cv2.INTER_AREA)
    return kernel / kernel.sum()


def photograph(light, look, random):
    """Grey levels of what a sensor sends: `light` has three channels, 1 is the sensor's white."""
    light = cv2.GaussianBlur(light, (0, 0), look["lens_px"])
    if look["motion_px"] > 0.5:
        light = cv2.filter2D(light, -1, line_kernel(look["motion_px"], look["motion_rad"]))
    if look["defocus_px"] > 0.3:
        light = cv2.filter2D(light, -1, disc_kernel(look["defocus_px"]))
    # Blue and green, green and red: one colour a pixel.
    mosaic = light[..., 1].copy()
    mosaic[0::2, 0::2] = light[0::2, 0::2, 0]
    mosaic[1::2, 1::2] = light[1::2, 1::2, 2]
    mosaic = 255 * look["gain"] * mosaic
    spread = np.sqrt(look["read_noise"]**2 + look["shot_noise"] * np.maximum(mosaic, 0))
    mosaic += spread * random.standard_normal(mosaic.shape).astype(np.float32)
    raw = np.clip(np.round(mosaic), 0, 255).astype(np.uint8)
    grey = cv2.cvtColor(cv2.demosaicing(raw, cv2.COLOR_BayerRG2BGR), cv2.COLOR_BGR2GRAY)
    return grey
