#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes a sheet of textons beside their spectra, one exemplar per row: the exemplar, its texton
# (enlarged; grey is zero), the texton noise, and the power spectra of exemplar and noise. Zero
# frequency is in the middle of a spectrum; the brightness is in decibels, on one scale per row.
#   samples/spectra_sheet.sh OUTPUT.jpg EXEMPLAR.png...
# Needs a release build, Python 3 and ImageMagick (Debian package imagemagick).
set -euo pipefail
source "$(dirname "$0")/begin_sheet.sh"
begin_sheet 'OUTPUT.jpg EXEMPLAR.png...' 2 99 "$@"
command -v python3 >/dev/null || { echo "spectra_sheet: install Python: apt-get install python3" >&2; exit 4; }

panel=192   # pixels a side
side=512    # of the compared images

output=$1
shift

# spectra.py A.pgm B.pgm OUT_A.pgm OUT_B.pgm: mean periodograms of Hann windows [Welch 1967].
cat >"$work/spectra.py" <<'PYTHON'
import cmath, math, re, sys

WINDOW, RANGE = 96, 32.0  # pixels; decibels from black to white
SIZE = 128                # of the transform


def fft(values):
    if len(values) == 1:
        return values
    even, odd = fft(values[::2]), fft(values[1::2])
    turned = [cmath.exp(-2j * math.pi * k / len(values)) * odd[k] for k in range(len(odd))]
    return [a + b for a, b in zip(even, turned)] + [a - b for a, b in zip(even, turned)]


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
    width, height = int(header[1]), int(header[2])
    light = [v / 255 for v in data[header.end():]]
    mean = sum(light) / len(light)
    return [[v - mean for v in light[y * width:(y + 1) * width]] for y in range(height)]


def spectrum(path):
    rows = read(path)
    hann = [math.sin(math.pi * (i + 0.5) / WINDOW) ** 2 for i in range(WINDOW)]
    power = [[0.0] * SIZE for _ in range(SIZE)]
    starts = range(0, len(rows) - WINDOW + 1, WINDOW)
    for top in starts:
        for left in starts:
            windowed = [[hann[y] * hann[x] * rows[top + y][left + x] for x in range(WINDOW)]
                        + [0.0] * (SIZE - WINDOW) for y in range(WINDOW)]
            lines = [fft(row) for row in windowed] + [[0.0] * SIZE] * (SIZE - WINDOW)
            for x, column in enumerate(zip(*lines)):
                for y, value in enumerate(fft(list(column))):
                    power[y][x] += abs(value) ** 2
    return power


spectra = [spectrum(path) for path in sys.argv[1:3]]
most = max(value for row in spectra[0] for value in row)
for power, path in zip(spectra, sys.argv[3:]):
    pixels = bytearray()
    for y in range(SIZE):
        for x in range(SIZE):
            value = max(power[(y + SIZE // 2) % SIZE][(x + SIZE // 2) % SIZE], 1e-12 * most)
            decibels = 10 * math.log10(value / most)
            pixels.append(round(255 * min(1.0, max(0.0, 1 + decibels / RANGE))))
    with open(path, "wb") as file:
        file.write(b"P5 %d %d 255\n" % (SIZE, SIZE) + pixels)
PYTHON

panels=()
for exemplar in "$@"; do
  bake_textons "$exemplar"
  "$bin/lichen" synth "$work/$name.glb" -o "$work/noise.png" --size "$side" --quiet
  report_picture Texton "$work/texton.png"
  convert "$exemplar" -colorspace Gray -depth 8 "$work/exemplar.pgm"
  convert "$work/noise.png" -colorspace Gray -depth 8 "$work/noise.pgm"
  python3 "$work/spectra.py" "$work/exemplar.pgm" "$work/noise.pgm" "$work/of-exemplar.pgm" \
    "$work/of-noise.pgm"
  convert "$exemplar" -crop "${panel}x${panel}+0+0" +repage "$work/$name-0.png"
  convert "$work/texton.png" -filter Box -resize "${panel}x${panel}" "$work/$name-1.png"
  convert "$work/noise.png" -crop "${panel}x${panel}+0+0" +repage "$work/$name-2.png"
  convert "$work/of-exemplar.pgm" -filter Triangle -resize "${panel}x${panel}" "$work/$name-3.png"
  convert "$work/of-noise.pgm" -filter Triangle -resize "${panel}x${panel}" "$work/$name-4.png"
  panels+=("$work/$name-"[0-4].png)
done
montage "${panels[@]}" -tile 5x -geometry +4+4 -background white -quality 70 "$output"
echo "$output"
