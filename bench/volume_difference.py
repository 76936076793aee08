#!/usr/bin/env python3
"""Volume that lies inside one of two closed meshes but not inside the other.

  bench/volume_difference.py A.ply B.ply

Prints it as a share of B's volume: how much of space a reconstruction A of B labels wrongly. Measured
along random lines parallel to the x axis, with a fixed seed. Reads binary little-endian PLY. Needs
Python 3 only.
"""
import array
import math
import random
import struct
import sys

LINES = 4000
SEED = 2000
SIZES = {"char": "b", "uchar": "B", "int8": "b", "uint8": "B", "short": "h", "ushort": "H", "int16": "h",
         "uint16": "H", "int": "i", "uint": "I", "int32": "i", "uint32": "I", "float": "f", "float32": "f",
         "double": "d", "float64": "d"}


def read_ply(path):
    """Points and triangles; polygons are cut into fans."""
    with open(path, "rb") as file:
        elements = []
        for line in iter(file.readline, b""):
            words = line.decode("ascii").split()
            if words[:1] == ["element"]:
                elements.append((words[1], int(words[2]), []))
            elif words[:1] == ["property"]:
                elements[-1][2].append(words[1:])
            elif words[:1] == ["format"] and words[1] != "binary_little_endian":
                raise ValueError(f"{path}: not binary little-endian")
            elif words == ["end_header"]:
                break
        data = file.read()
    at, points, triangles = 0, [], []
    for name, count, properties in elements:
        if any(p[0] == "list" for p in properties):
            (_, size_type, index_type, _), = properties
            for _ in range(count):
                size, = struct.unpack_from("<" + SIZES[size_type], data, at)
                at += struct.calcsize(SIZES[size_type])
                corners = struct.unpack_from(f"<{size}{SIZES[index_type]}", data, at)
                at += struct.calcsize(f"<{size}{SIZES[index_type]}")
                if name == "face":
                    triangles += [(corners[0], corners[k], corners[k + 1]) for k in range(1, size - 1)]
        else:
            row = struct.Struct("<" + "".join(SIZES[p[0]] for p in properties))
            rows = row.iter_unpack(data[at:at + count * row.size])
            if name == "vertex":
                x, y, z = ([p[1] for p in properties].index(axis) for axis in "xyz")
                points = [(r[x], r[y], r[z]) for r in rows]
            at += count * row.size
    return points, triangles


class Lines:
    """Lines parallel to the x axis, at random places of a rectangle of y and z, in a grid of cells."""

    def __init__(self, points):
        self.low = [min(p[i] for p in points) for i in (1, 2)]
        self.side = [max(max(p[i] for p in points) - low, 1e-300) for i, low in zip((1, 2), self.low)]
        chance = random.Random(SEED)
        self.at = [[low + side * chance.random() for low, side in zip(self.low, self.side)]
                   for _ in range(LINES)]
        self.cells = int(math.sqrt(LINES))
        self.in_cell = {}
        for k, place in enumerate(self.at):
            self.in_cell.setdefault(self.cell(place), []).append(k)

    def cell(self, place):
        return tuple(min(max(int((p - low) / side * self.cells), 0), self.cells - 1)
                     for p, low, side in zip(place, self.low, self.side))

    def crossings(self, points, triangles):
        """Per line, where it meets the mesh, in order."""
        found = [array.array("d") for _ in self.at]
        for triangle in triangles:
            a, b, c = (points[v] for v in triangle)
            lowest = self.cell((min(a[1], b[1], c[1]), min(a[2], b[2], c[2])))
            highest = self.cell((max(a[1], b[1], c[1]), max(a[2], b[2], c[2])))
            twice_area = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
            if twice_area == 0:
                continue
            for i in range(lowest[0], highest[0] + 1):
                for j in range(lowest[1], highest[1] + 1):
                    for k in self.in_cell.get((i, j), ()):
                        y, z = self.at[k]
                        of_b = ((y - a[1]) * (c[2] - a[2]) - (z - a[2]) * (c[1] - a[1])) / twice_area
                        of_c = ((b[1] - a[1]) * (z - a[2]) - (b[2] - a[2]) * (y - a[1])) / twice_area
                        if of_b >= 0 and of_c >= 0 and of_b + of_c <= 1:
                            found[k].append(a[0] + of_b * (b[0] - a[0]) + of_c * (c[0] - a[0]))
        return [sorted(line) for line in found]


def length_of_one(crossings):
    """Length of the line on which an odd number of the sorted crossings has been passed."""
    return sum(b - a for a, b in zip(crossings[::2], crossings[1::2]))


def volume_difference(path_a, path_b):
    a, b = read_ply(path_a), read_ply(path_b)
    lines = Lines(b[0])
    of_a, of_b = lines.crossings(*a), lines.crossings(*b)
    volume = sum(map(length_of_one, of_b))
    return sum(length_of_one(sorted(p + q)) for p, q in zip(of_a, of_b)) / volume


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    print(f"{volume_difference(sys.argv[1], sys.argv[2]):.6f}")
