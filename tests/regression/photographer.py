"""Makes photographs of simulated grains: a ray caster with a lamp, shadows, a plate, texture, a lens and noise."""

import io
from dataclasses import dataclass

import h5py
import numpy as np
from PIL import Image

AT_REST = 0.02  # m/s
SHADOW = 0.45  # of the light that stays in a shadow


@dataclass
class Camera:
    """How a photograph is taken."""

    megapixels: float = 4.0
    pixels_per_mm: float = 0.0  # 0: so that the grains fill `filling` of the width
    filling: float = 0.6
    light_grains: bool = True  # before a dark background, or dark ones before a light one
    plate: float = 0.45  # brightness of the plate between background and grains; side views
    tilt: float = 0.0  # degrees
    blur: float = 0.7  # px, standard deviation
    noise: float = 0.01  # of black to white
    texture: float = 0.01
    slope: float = 0.08  # by how much the background's brightness changes over the picture
    lamp: tuple = (-0.5, -0.6, 0.8)  # direction towards it: x, y, z
    distance: float = np.inf  # m, from the axis; side views
    height: float = 0.0  # m, z of the camera
    seed: int = 1
    name: str = ""


def read_grains(path, below):
    """Centres (n x 3) and radii of a snapshot, m: of the grains below a height that are at rest. A laboratory waits with the
    photograph until nothing falls."""
    with h5py.File(path) as file:
        data = file["VTKHDF"]
        centres, radii = data["Points"][:], data["PointData/radius"][:]
        speed = np.linalg.norm(data["PointData/velocity"][:], axis=1)
    at_rest = (centres[:, 2] < below) & (speed < AT_REST)
    return centres[at_rest], radii[at_rest]


def side_view(centres, radii, plate, camera):
    """A photograph from the side along +y, as at azimuth 0, and its pixels per mm."""
    scale = 1.0 / (1.0 + centres[:, 1] / camera.distance)
    u, n = scale * centres[:, 0], -centres[:, 1]
    v = camera.height + scale * (centres[:, 2] - camera.height) - plate
    r = scale * radii
    seen = v > -r
    lamp = np.array([camera.lamp[0], -camera.lamp[1], camera.lamp[2]])  # to the right, near, up
    turn = np.radians(camera.tilt)
    c, s = np.cos(turn), np.sin(turn)
    u, v = c * u[seen] + s * v[seen], -s * u[seen] + c * v[seen]
    return _photograph(u, v, n[seen], r[seen], np.array([c * lamp[0] + s * lamp[2], lamp[1], c * lamp[2] - s * lamp[0]]),
                       camera, edge=turn)


def top_view(centres, radii, plate, camera):
    """A photograph from above, y upwards, and its pixels per mm."""
    turn = np.radians(camera.tilt)
    c, s = np.cos(turn), np.sin(turn)
    u, v = c * centres[:, 0] - s * centres[:, 1], s * centres[:, 0] + c * centres[:, 1]
    lamp = np.array([c * camera.lamp[0] - s * camera.lamp[1], s * camera.lamp[0] + c * camera.lamp[1], camera.lamp[2]])
    lamp = np.array([lamp[0], lamp[2], lamp[1]])  # to the right, near, up in the picture
    return _photograph(u, v, centres[:, 2] - plate, radii, lamp, camera, ground=True)


def _photograph(u, v, n, r, lamp, camera, edge=None, ground=False):
    """Grains at u to the right, v up and n towards the camera. `edge`: slope of the edge of a plate below them; `ground`:
    the plate is behind them, at n = 0."""
    width = int(round(np.sqrt(1.5e6 * camera.megapixels)))
    height = int(round(1e6 * camera.megapixels / width))
    if camera.pixels_per_mm:
        scale = 1e3 * camera.pixels_per_mm
    else:
        inner = np.hypot(u - u.mean(), v - v.mean()) if ground else np.abs(u - u.mean())
        reach = inner.max() if ground else np.quantile(inner, 0.97)
        scale = camera.filling * (height if ground else width) / (2.0 * reach)
    zero = (0.5 * width, 0.5 * height if ground else 0.8 * height)
    x, y = zero[0] + scale * u - 0.5, zero[1] - scale * v - 0.5
    n, r = scale * n, scale * r
    lamp = lamp / np.linalg.norm(lamp)
    depth, which = _nearest(x, y, n, r, width, height)
    rng = np.random.default_rng(camera.seed)
    rows, columns = np.nonzero(which >= 0)
    grain = which[rows, columns]
    normal = np.stack([(columns - x[grain]) / r[grain], (depth[rows, columns] - n[grain]) / r[grain],
                       -(rows - y[grain]) / r[grain]])
    light = 0.35 + 0.65 * np.clip(np.tensordot(lamp, normal, 1), 0.0, 1.0)
    light *= _lit(columns, rows, depth[rows, columns], x, y, n, r, lamp, width, height)
    light *= rng.normal(1.0, 0.05, len(r)).clip(0.85, 1.15)[grain]
    back, front = (0.12, 0.85) if camera.light_grains else (0.88, 0.12)
    picture = np.full((height, width), back)
    gradient = np.linspace(-0.5, 0.5, width)[None, :] + 0.4 * np.linspace(-0.5, 0.5, height)[:, None] ** 2
    picture += camera.slope * gradient + camera.texture * _texture(rng, width, height)
    if ground:
        gr, gc = np.nonzero(which < 0)
        lit = _lit(gc, gr, np.zeros(len(gr)), x, y, n, r, lamp, width, height)
        picture[gr, gc] *= np.where(lit < 1.0, 0.8, 1.0)
    elif camera.plate > 0.0:
        line = zero[1] - 0.5 - np.tan(-edge) * (np.arange(width) - zero[0])
        below = np.arange(height)[:, None] > line[None, :]
        plate = back + camera.plate * (front - back) + camera.texture * _texture(rng, width, height)
        picture = np.where(below, plate, picture)
    picture[rows, columns] = back + (front - back) * (light if camera.light_grains else 1.25 - 0.5 * light).clip(0.0, 1.2)
    picture = _blurred(picture, camera.blur) + rng.normal(0.0, camera.noise, picture.shape)
    return picture.clip(0.0, 1.0), 1e-3 * scale


def _nearest(x, y, n, r, width, height):
    """Distance towards the camera of what each pixel sees, and which grain it is (-1: none)."""
    depth = np.full((height, width), -np.inf)
    which = np.full((height, width), -1, dtype=np.int32)
    for i in range(len(x)):
        left, right = max(0, int(np.ceil(x[i] - r[i]))), min(width, int(x[i] + r[i]) + 1)
        top, bottom = max(0, int(np.ceil(y[i] - r[i]))), min(height, int(y[i] + r[i]) + 1)
        if left >= right or top >= bottom:
            continue
        square = r[i] ** 2 - (np.arange(left, right)[None, :] - x[i]) ** 2 - (np.arange(top, bottom)[:, None] - y[i]) ** 2
        at = np.where(square >= 0.0, n[i] + np.sqrt(square.clip(0.0)), -np.inf)
        near = at > depth[top:bottom, left:right]
        depth[top:bottom, left:right][near] = at[near]
        which[top:bottom, left:right][near] = i
    return depth, which


def _lit(columns, rows, depth, x, y, n, r, lamp, width, height):
    """1 where the lamp shines, SHADOW where a grain stands before it: the same picture taken from the lamp."""
    a = np.cross(lamp, [0.0, 1.0, 0.0] if abs(lamp[1]) < 0.9 else [1.0, 0.0, 0.0])
    a /= np.linalg.norm(a)
    b = np.cross(lamp, a)
    centres = np.stack([x, n, -y])
    places = np.stack([columns, depth, -rows])
    coarse = 2.0  # pixels of the photograph in one of the lamp's
    ga, gb, gl = a @ centres / coarse, b @ centres / coarse, lamp @ centres / coarse
    low = np.array([(ga - r / coarse).min(), (gb - r / coarse).min()]) - 2.0
    size = np.array([(ga + r / coarse).max(), (gb + r / coarse).max()]) + 2.0 - low
    near, _ = _nearest(ga - low[0], gb - low[1], gl, r / coarse, int(size[0]) + 1, int(size[1]) + 1)
    pa = np.rint(a @ places / coarse - low[0]).astype(int)
    pb = np.rint(b @ places / coarse - low[1]).astype(int)
    inside = (pa >= 0) & (pb >= 0) & (pa < near.shape[1]) & (pb < near.shape[0])
    before = np.full(len(pa), -np.inf)
    before[inside] = near[pb[inside], pa[inside]]
    return np.where(before > lamp @ places / coarse + 0.2 * np.median(r) / coarse, SHADOW, 1.0)


def _texture(rng, width, height):
    """Noise of unit deviation that is smooth over a few pixels."""
    coarse = rng.normal(size=(height // 3 + 2, width // 3 + 2))
    fine = np.repeat(np.repeat(coarse, 3, 0), 3, 1)[:height, :width]
    return _blurred(fine, 1.0) * 1.5


def _blurred(picture, sigma):
    if sigma <= 0.0:
        return picture
    reach = int(np.ceil(3.0 * sigma))
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        padded = np.pad(picture, [(reach, reach) if k == axis else (0, 0) for k in (0, 1)], mode="edge")
        length = picture.shape[axis]
        picture = sum(weight * np.take(padded, range(k, k + length), axis) for k, weight in enumerate(kernel))
    return picture


def encoded(picture, kind, orientation=1, **options):
    """The bytes of a photograph: "jpeg", "png" or "tiff", for the last two with options of Pillow; `orientation` as in EXIF,
    by which it is turned beforehand."""
    grey = np.rint(255.0 * picture).astype(np.uint8)
    turned = {1: grey, 3: grey[::-1, ::-1], 6: np.rot90(grey, 1), 8: np.rot90(grey, -1)}[orientation]
    image = Image.fromarray(np.ascontiguousarray(turned))
    out = io.BytesIO()
    if kind == "jpeg":
        exif = Image.Exif()
        exif[0x0112] = orientation
        image.convert("RGB").save(out, "JPEG", quality=92, exif=exif)
    else:
        image.save(out, kind.upper(), **options)
    return out.getvalue()
