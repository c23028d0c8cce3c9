#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes test_vectors.json: lattice, impacts, planes and quilting of README.md, implemented a second time, in Python
with integers and decimals of any length, so that an implementation in another language can be compared
with something that shares no code with it. Run: python3 make_test_vectors.py > test_vectors.json"""
import json
import math
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
WORD = 2**32


def pcg(value):
    state = (value * 747796405 + 2891336453) % WORD
    word = (((state >> ((state >> 28) + 4)) ^ state) * 277803737) % WORD
    return (word >> 22) ^ word


def pcg3d(x, y, z):
    x, y, z = ((word * 1664525 + 1013904223) % WORD for word in (x, y, z))
    x = (x + y * z) % WORD
    y = (y + z * x) % WORD
    z = (z + x * y) % WORD
    x, y, z = (word ^ (word >> 16) for word in (x, y, z))
    x = (x + y * z) % WORD
    y = (y + z * x) % WORD
    z = (z + x * y) % WORD
    return [x, y, z]


def lattice_seed(seed, plane):
    return pcg((pcg(seed) + plane) % WORD)


def vertex_hash(i, j, seed_word):
    h = i % WORD * 0x9E3779B1 % WORD
    h = ((h ^ (h >> 15)) + j) % WORD ^ seed_word
    h = h * 0x85EBCA6B % WORD
    h = (h ^ (h >> 15)) * 0xC2B2AE35 % WORD
    return h ^ (h >> 16)


def tile_offset(i, j, seed_word, width, height):
    def offset(steps, size):
        step = 1
        while size // (2 * step) >= 64:
            step *= 2
        return steps * step % size

    h = vertex_hash(i, j, seed_word)
    return [offset(h % 2048, width), offset(h // 2**21, height)]


def quarter_turns(i, j, seed_word, tile_rotation):
    share = pcg(vertex_hash(i, j, seed_word)) / WORD
    return int(share * tile_rotation) * 4 // tile_rotation


def signed(word):
    return word - WORD if word >= WORD // 2 else word


def cells_per_tile(grain):
    stretch_x, stretch_y = {None: (1, 1), "x": (2, 1), "y": (1, 2)}[grain]
    return Fraction(7, 2 * stretch_x), Fraction(4, stretch_y)


def with_grain(vector, grain):
    return vector if grain is None else vector | {"grain": grain}


def lattice_cell(tile_x, tile_y, grain=None):
    columns, rows = cells_per_tile(grain)
    cell = [columns * tile_x - rows * tile_y / 2, rows * tile_y]
    assert all(c.denominator == 1 for c in cell)
    return with_grain({"tile": [tile_x, tile_y], "cell": [signed(int(c) % WORD) for c in cell]}, grain)


def periodic_lattice(width, height, grain=None):
    def half_up(value):
        return int((value + Decimal("0.5")).to_integral_value(rounding="ROUND_FLOOR"))

    per_tile = [Decimal(c.numerator) / c.denominator for c in cells_per_tile(grain)]
    columns = max(3, half_up(per_tile[0] * Decimal(width)))
    rows = max(4, 2 * half_up(per_tile[1] * Decimal(height) / 2))
    return with_grain({"tiles": [width, height], "columns": columns, "rows": rows}, grain)


def impact_grid(coefficients, order, impacts, tile):
    # columns = round(tile / side) with side^2 = (N + k) (N' + k) / impacts, in exact arithmetic.
    area = Decimal((coefficients[0] + order) * (coefficients[1] + order))
    side = (area / Decimal(impacts)).sqrt()

    def cells(texels):
        return max(1, int((texels / side + Decimal("0.5")).to_integral_value(rounding="ROUND_FLOOR")))

    return {"coefficients": coefficients, "order": order, "impacts": impacts,
            "texelsPerTile": tile, "cells": [cells(tile[0]), cells(tile[1])]}


def poisson_count(word):
    # The thresholds, from the distribution function itself: 2^32 sum_k e^-1 / k!, rounded.
    below, term, count = Decimal(0), Decimal(-1).exp(), 0
    while True:
        below += term
        threshold = int((below * WORD).to_integral_value(rounding="ROUND_HALF_EVEN"))
        if word < threshold or threshold >= WORD:
            return count
        count += 1
        term /= count


def impacts_of(i, j, seed, plane, process):
    first, second, _ = pcg3d(i % WORD, j % WORD, lattice_seed(seed, plane))
    words = [first]
    if process == "poisson":
        words = [pcg((first + k) % WORD) for k in range(poisson_count(second))]
    return {"cell": [i, j], "seed": seed, "plane": plane, "process": process,
            "impacts": [{"place": [((w >> shift) % 32768 + 0.5) / 32768 for shift in (16, 1)],
                         "sign": -1 if w >> 31 else 1} for w in words]}


def surface_grid(coefficients, order, impacts, tile):
    # columns = round(tile / side) with side^3 = r^3 / (2 impacts), r^2 = (N + k) (N' + k).
    thickness = Decimal((coefficients[0] + order) * (coefficients[1] + order)).sqrt()
    side = thickness / (2 * Decimal(impacts)) ** (Decimal(1) / 3)
    cells = max(1, int((tile[0] / side + Decimal("0.5")).to_integral_value(rounding="ROUND_FLOOR")))
    cube = Decimal(tile[0]) / cells
    return {"coefficients": coefficients, "order": order, "impacts": impacts,
            "texelsPerTile": tile, "cells": cells,
            "amplitude": float((3 * cube**3 / thickness).sqrt())}


def surface_impacts_of(i, j, k, seed, process):
    first, second, _ = pcg3d(i % WORD, j % WORD, lattice_seed(seed, 3))
    words = [pcg((first + k) % WORD)]
    if process == "poisson":
        count = poisson_count(pcg((second + k) % WORD))
        words = [pcg((words[0] + m) % WORD) for m in range(count)]
    return {"cell": [i, j, k], "seed": seed, "process": process,
            "impacts": [{"place": [((w >> shift) % 1024 + 0.5) / 1024 for shift in (21, 11, 1)],
                         "sign": -1 if w >> 31 else 1} for w in words]}


def cosine_and_sine(angle):
    cosine, sine, term, k = Decimal(0), Decimal(0), Decimal(1), 0
    while abs(term) > Decimal(10) ** -55:
        if k % 2 == 0:
            cosine += term if k % 4 == 0 else -term
        else:
            sine += term if k % 4 == 1 else -term
        k += 1
        term *= angle / k
    return cosine, sine


def onto_planes(x, y, z):
    return [(-z, -y), (x, z), (x, -y)]


def tile_of_plane(u, v, rotation, texels):
    cosine, sine = cosine_and_sine(Decimal(rotation))
    return [cosine * u + sine * v, (cosine * v - sine * u) * texels[0] / texels[1]]


def plane_origin(origin, rotation, offset, texels):
    planes = []
    for u, v in onto_planes(*origin):
        place = [Decimal(o) + p for o, p in
                 zip(offset, tile_of_plane(Decimal(u), Decimal(v), rotation, texels))]
        whole = [int(p.to_integral_value(rounding="ROUND_FLOOR")) for p in place]
        planes.append({"tile": whole, "rest": [float(p - w) for p, w in zip(place, whole)]})
    return {"tileOrigin": origin, "rotation": rotation, "offset": offset, "texelsPerTile": texels,
            "planes": planes}


def plane_weights(normal, sharpness):
    most = max(abs(Decimal(n)) for n in normal)
    weights = [max(Decimal(0), (abs(Decimal(n)) / most) ** Decimal(sharpness) - Decimal(1) / 64)
               for n in normal]
    norm = sum(w * w for w in weights).sqrt()
    return {"normal": normal, "planeSharpness": sharpness,
            "weights": [float(w / norm) for w in weights]}


def plane_places(position, rotation, scale, tile_size, texels):
    per_tile = Decimal(scale) * Decimal(tile_size)
    return {"position": position, "rotation": rotation, "scale": scale, "tileSize": tile_size,
            "texelsPerTile": texels,
            "tiles": [[float(p / per_tile) for p in tile_of_plane(u, v, rotation, texels)]
                      for u, v in onto_planes(*(Decimal(x) for x in position))]}


def plane_gradients(slopes, rotation):
    cosine, sine = cosine_and_sine(Decimal(rotation))
    x, y = (Decimal(s) for s in slopes)
    right, up = float(cosine * x + sine * y), float(cosine * y - sine * x)
    return {"slopes": slopes, "rotation": rotation,
            "gradients": [[0.0, up, -right], [right, 0.0, -up], [right, up, 0.0]]}


# Quilting, whole: a noise of 4 x 4 texels whose cells have 2 x 2, and its values at points.
QUILT_SIDE = 4
QUILT_REACH = 0.125
QUILT_CORRELATION = 0.5
QUILT_OFFSETS = [[0, 0], [0.5, 0], [0, 0.5], [0.5, 0.5]]


def averages(image):
    """All mip levels of a square image of tuples."""
    levels = [image]
    while len(levels[-1]) > 1:
        rows = levels[-1]
        levels.append([[tuple(sum(four) / 4 for four in zip(rows[y][x], rows[y][x + 1], rows[y + 1][x],
                                                            rows[y + 1][x + 1]))
                        for x in range(0, len(rows), 2)] for y in range(0, len(rows), 2)])
    return levels


def in_bytes(levels):
    return [[[tuple(math.floor(value * 255 + 0.5) / 255 for value in texel) for texel in row]
             for row in level] for level in levels]


def quilt_images():
    texels = [[(x, y) for x in range(QUILT_SIDE)] for y in range(QUILT_SIDE)]
    vectors = averages([[((x + 1) % 2, (y + 1) % 2) for x, y in row] for row in texels])
    for level, rows in enumerate(vectors):  # with the sharpness
        vectors[level] = [[vector + (1 if level == 0 else 0,) for vector in row] for row in rows]
    heights = averages([[((x + QUILT_SIDE * y) * 5 % 16 * 16 / 255,) for x, y in row] for row in texels])
    slopes = [[(x / 4 - 1 / 2, 1 / 2 - y / 8) for x, y in row] for row in texels]
    squares = averages([[(a, b, (a * a + b * b) / 2) for a, b in row] for row in slopes])
    return in_bytes(vectors), in_bytes(heights), squares


def trilinear(levels, u, v, level):
    def bilinear(rows):
        side = len(rows)
        x, y = u * side - 0.5, v * side - 0.5
        i, j = math.floor(x), math.floor(y)
        value = [0.0] * len(rows[0][0])
        for di, dj in ((0, 0), (1, 0), (0, 1), (1, 1)):
            weight = (x - i if di else 1 - x + i) * (y - j if dj else 1 - y + j)
            texel = rows[(j + dj) % side][(i + di) % side]
            value = [a + weight * b for a, b in zip(value, texel)]
        return value

    level = min(max(level, 0), len(levels) - 1)
    low = math.floor(level)
    high = min(low + 1, len(levels) - 1)
    return [a + (level - low) * (b - a) for a, b in zip(bilinear(levels[low]), bilinear(levels[high]))]


def sharp_level(dpdx, dpdy, side):
    (a, b), (c, d) = ([side * t for t in dpdx], [side * t for t in dpdy])
    squared = max(1, a * a + b * b, c * c + d * d)
    level = math.log2(squared * max(abs(a * d - b * c), math.sqrt(squared), squared / 16)) / 4
    return max(level / 2, level - 0.5)


def quilt_value(slopes, texel):
    return [*texel[:2], max(0, texel[2] - (texel[0] ** 2 + texel[1] ** 2) / 2)] if slopes else texel


def quilting(position, dpdx, dpdy, contrast, has_list, seed, period):
    vectors, heights, squares = quilt_images()
    columns, rows = 3.5, 4
    if period:
        lattice = periodic_lattice(*period)
        columns, rows = lattice["columns"] / period[0], lattice["rows"] / period[1]
    a, b = position[0] * columns - position[1] * rows / 2, position[1] * rows
    i, j = math.floor(a), math.floor(b)
    corner = 0 if a - i + b - j < 1 else 1
    level = sharp_level(dpdx, dpdy, QUILT_SIDE)
    taps, hats = [], []
    for column, row in ((i + corner, j + corner), (i + 1, j), (i, j + 1)):
        vertex, shift = [column, row], [0, 0]
        if period:
            k = vertex[1] // lattice["rows"]
            vertex = [vertex[0] + k * lattice["rows"] // 2, vertex[1] - k * lattice["rows"]]
            q = vertex[0] // lattice["columns"]
            vertex[0] -= q * lattice["columns"]
            shift = [q * period[0], k * period[1]]
        word = vertex_hash(*vertex, lattice_seed(seed, 0))
        offset = [step / QUILT_SIDE for step in tile_offset(*vertex, lattice_seed(seed, 0), QUILT_SIDE, QUILT_SIDE)]
        if has_list:
            offset = QUILT_OFFSETS[word // 65536 * len(QUILT_OFFSETS) // 65536]
        tap = [p - s + o for p, s, o in zip(position, shift, offset)]
        red, green, sharpness = trilinear(vectors, *tap, math.floor(level + 0.5))
        x, y = (QUILT_REACH * (2 * c - 1) for c in (red, green))
        u, v = a - column + x * columns - y * rows / 2, b - row + y * rows
        taps.append(tap)
        hats.append(max(1 - max(abs(u), abs(v), abs(u + v)), 0.001))
    weights = [max(max(hats) - 2 ** (4 * sharpness) * (max(hats) - hat), 0) for hat in hats]
    least = weights.index(min(weights))
    weights = [0 if k == least else max(weight - weights[least], 1e-6) for k, weight in enumerate(weights)]
    weights = [weight / sum(weights) for weight in weights]
    correlation, total = QUILT_CORRELATION * sharpness, sum(w * w for w in weights)
    gain = contrast / math.sqrt(total + correlation * (1 - total))
    values = []
    for slopes, image in ((False, heights), (True, squares)):
        mean = quilt_value(slopes, image[-1][0][0])
        tiles = [quilt_value(slopes, trilinear(image, *tap, level)) for tap in taps]
        value = [m + gain * sum(w * (tile[c] - m) for w, tile in zip(weights, tiles)) for c, m in enumerate(mean)]
        if slopes:
            value[2] = max(value[2], 0)
        else:
            value = [min(max(v, 0), 1) for v in value]
        values.append([round(v, 7) for v in value])
    return {"position": position, "dpdx": dpdx, "dpdy": dpdy, "contrast": contrast, "hasOffsets": has_list,
            "seed": seed, "periodTiles": period or [0, 0], "height": values[0], "normal": values[1]}


WORDS = [0, 1, 2, 3, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x12345678]
VERTICES = [(0, 0), (1, 0), (0, 1), (-1, -1), (-2147483648, 2147483647), (34641016, -40000000)]
SEEDS = [(0, 0), (1, 0), (1, 1), (1, 2), (4294967295, 0)]
SIZES = [(1, 1), (256, 256), (1000, 17), (16384, 16384)]
TILES = [(0, 0), (2, 0), (0, 1), (-2, -1), (10000000, -3), (-(2**40), 2**40 - 1)]
GRAIN_TILES = [(0, 0), (4, 0), (0, 1), (-4, -1), (10000000, -3), (-(2**40), 2**40 - 1)]
PERIODS = [(0.5, 0.5), (1.0, 1.0), (1.37, 2.0), (4.0, 4.0), (16.0, 3.0)]
GRIDS = [([63, 63], 1, 30, [1024, 1024]), ([64, 64], 0, 30, [1024, 512]),
         ([61, 21], 3, 12.5, [1000, 17]), ([8, 8], 1, 1000, [32, 32]), ([31, 31], 1, 1, [31, 40])]
NORMALS = [([0, 0, 1], 8), ([0, -2, 0.5], 8), ([1, 1, -1], 8), ([0.9, -1, 0.75], 8),
           ([0.125, 0.25, -0.5], 1), ([0.875, 1, 0.9375], 64)]
ORIGINS = [([0, 0, 0], 0, [0.25, -3.5], [64, 64]), ([3, -2, 7], 0, [0, 0], [64, 48]),
           ([2**40, 1 - 2**40, -77], 0, [0.5, 0], [64, 64]),
           ([10000000, -9999999, 123456789], 0.5, [0, 0], [64, 48])]
QUILT_PLACES = [(0, 0, 1), (3, 1, 1), (-21, 4, 2), (10, 13, 1), (29, -6, 7), (47, 37, 1)]
QUILT_WIDTHS = [(0, 1), (0.25, 1), (0.5, 1.5), (2, 1)]
QUILT_KINDS = [(True, None), (False, None), (True, (1.5, 1.25))]
QUILT_POINTS = [([x / 16 + 0.01, y / 8 - 0.53], [t, t / 4], [0, t / 2], contrast,
                 QUILT_KINDS[(place + width) % 3][0], seed, QUILT_KINDS[(place + width) % 3][1])
                for place, (x, y, seed) in enumerate(QUILT_PLACES)
                for width, (t, contrast) in enumerate(QUILT_WIDTHS)]
COUNTS = [0, 1580030168, 1580030169, 3160060337, 3950075422, 4213413783, 4279248374, 4292415292,
          4294609778, 4294923276, 4294962463, 4294966817, 4294967253, 4294967291, 4294967292]

print(json.dumps({
    "pcg": [{"value": w, "hash": pcg(w)} for w in WORDS],
    "pcg3d": [{"value": [w, (w * 5 + 1) % WORD, (w * 9 + 2) % WORD],
               "hash": pcg3d(w, (w * 5 + 1) % WORD, (w * 9 + 2) % WORD)} for w in WORDS],
    "latticeSeed": [{"seed": s, "plane": p, "word": lattice_seed(s, p)} for s, p in SEEDS],
    "vertexHash": [{"vertex": list(v), "seed": s, "plane": p,
                    "hash": vertex_hash(*v, lattice_seed(s, p))} for v in VERTICES for s, p in SEEDS],
    "tileOffset": [{"vertex": list(v), "seed": s, "plane": p, "size": list(size),
                    "texels": tile_offset(*v, lattice_seed(s, p), *size)}
                   for v in VERTICES for s, p in SEEDS[1:3] for size in SIZES],
    "tileRotation": [{"vertex": list(v), "seed": s, "plane": p, "tileRotation": n,
                      "quarterTurns": quarter_turns(*v, lattice_seed(s, p), n)}
                     for v in VERTICES for s, p in SEEDS[1:3] for n in (2, 4)],
    "latticeCell": [lattice_cell(*tile) for tile in TILES] +
                   [lattice_cell(*tile, grain) for grain in "xy" for tile in GRAIN_TILES],
    "periodicLattice": [periodic_lattice(*period) for period in PERIODS] +
                       [periodic_lattice(*period, grain) for grain in "xy" for period in PERIODS],
    "impactGrid": [impact_grid(*grid) for grid in GRIDS],
    "poissonCount": [{"word": w, "count": poisson_count(w)} for w in COUNTS],
    "impacts": [impacts_of(*v, s, p, process)
                for v in VERTICES for s, p in SEEDS[1:3] for process in ("stratified", "poisson")],
    "surfaceGrid": [surface_grid(*grid) for grid in GRIDS],
    "surfaceImpacts": [surface_impacts_of(*v, k, s, process)
                       for v, k in zip(VERTICES, (0, 1, -1, 7, 2147483647, -5)) for s in (1, 2)
                       for process in ("stratified", "poisson")],
    "planeWeights": [plane_weights(*case) for case in NORMALS],
    "planeOrigins": [plane_origin(*case) for case in ORIGINS],
    "planePlaces": [plane_places([0.5, -1.25, 3], rotation, scale, 0.5, texels)
                    for rotation, scale, texels in ((0, 1, [64, 64]), (0.5, 0.75, [64, 48]))],
    "planeGradients": [plane_gradients([0.5, -0.25], rotation) for rotation in (0, 0.5, -2)],
    "quilting": [quilting(*point) for point in QUILT_POINTS],
}, indent=1))
