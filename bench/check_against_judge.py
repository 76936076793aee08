#!/usr/bin/env python3
"""Compares `tetsculpt check` with a judge that shares no code with it, on sound and on broken meshes.

  bench/check_against_judge.py --cli build/release/tetsculpt --judge MESHCHECK [--data DATA] [--most TRIANGLES]

MESHCHECK prints one JSON object about a mesh whose vertices of one position it has joined: so does check --weld.
Meshes are small ones made here, and the true surfaces in DATA (see bench/quality.py) of at most so many triangles,
each sound and broken. Exit status 1 if the two differ on anything. Needs Python 3 only.
"""
import argparse
import gzip
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile


def grid(n, m, point, seam=lambda i, j: (i, j)):
    """n by m quadrangles, closed in both directions; `seam` says which vertex one beyond the border is."""
    at = lambda i, j: (lambda p: p[0] % n * m + p[1] % m)(seam(i, j))
    faces = [(at(i, j), at(i + 1, j + k), at(i + 1 - k, j + 1)) for i in range(n) for j in range(m) for k in (0, 1)]
    return [point(2 * math.pi * i / n, 2 * math.pi * j / m) for i in range(n) for j in range(m)], faces


def torus(u, v):
    return ((3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u), math.sin(v))


def klein(u, v):
    x, z = math.sin(v), math.sin(2 * v)
    r = 3 + math.cos(u / 2) * x - math.sin(u / 2) * z
    return (r * math.cos(u), r * math.sin(u), math.sin(u / 2) * x + math.cos(u / 2) * z)


def made():
    """Name, points and triangles of the meshes made here."""
    tetrahedron = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    yield "tetrahedron", tetrahedron, faces
    yield "torus", *grid(12, 9, torus)
    yield "klein", *grid(12, 8, klein, lambda i, j: (i, j) if i < 12 else (0, -j))
    yield "open tube", *(part[:126 - 14] for part in grid(9, 7, torus))
    band = [(math.cos(a) * (3 + s * math.cos(a / 2)), math.sin(a) * (3 + s * math.cos(a / 2)), s * math.sin(a / 2))
            for a in (2 * math.pi * i / 9 for i in range(9)) for s in (-1, 1)]
    strip = [tuple(k % 18 if k < 18 else 1 - k % 18 for k in t) for i in range(9)
             for t in ((2 * i, 2 * i + 1, 2 * i + 2), (2 * i + 1, 2 * i + 3, 2 * i + 2))]
    yield "moebius", band, strip
    for name, joined in (("apart", 0), ("sharing a vertex", 1), ("sharing an edge", 2), ("sharing a triangle", 3)):
        shift = [k if k < joined else k + 4 for k in range(4)]
        mirrored = tetrahedron[:joined] + [(-1 - x - 5 * (not joined), -1 - y, -1 - z) for x, y, z in tetrahedron[joined:]]
        yield "two " + name, tetrahedron + mirrored, faces + [tuple(shift[k] for k in f) for f in faces]
    yield "a cavity", tetrahedron + [(0.1 + p[0] / 9, 0.1 + p[1] / 9, 0.1 + p[2] / 9) for p in tetrahedron], faces + [
        (4 + a, 4 + c, 4 + b) for a, b, c in faces]
    yield "a soup", [tetrahedron[k] for f in faces for k in f], [(i, i + 1, i + 2) for i in range(0, 12, 3)]


def breakages(points, faces):
    first, middle = faces[0], faces[len(faces) // 2]
    a, b, c = middle
    yield "sound", points, faces
    yield "removed", points, faces[1:]
    yield "two removed", points, faces[1:-1]
    yield "flipped", points, [(a, c, b) if f == middle else f for f in faces]
    yield "all flipped", points, [(x, z, y) for x, y, z in faces]
    yield "duplicated", points, faces + [middle]
    yield "duplicated and turned", points, faces + [(c, b, a)]
    yield "degenerate", points, faces + [(a, a, b)]
    yield "degenerate by position", points + [points[a]], faces + [(a, len(points), b)]
    yield "a fin", points + [(9, 9, 9)], faces + [(a, b, len(points))]
    yield "a vertex more", points + [(9, 9, 9)], faces
    yield "pinched", points, [tuple(first[0] if k == c else k for k in f) for f in faces]


def read_ply(data):
    head, body = data.split(b"end_header\n", 1)
    words = [line.split() for line in head.decode().split("\n")]
    counts = [int(w[2]) for w in words if w[:1] == ["element"]]
    real = "d" if ["property", "double", "x"] in words else "f"
    size = struct.calcsize("<3" + real)
    points = list(struct.iter_unpack("<3" + real, body[: size * counts[0]]))
    return points, [row[1:] for row in struct.iter_unpack("<B3i", body[size * counts[0]:])]


def verdicts(cli, judge, file):
    ours = json.loads(subprocess.run([cli, "check", "--weld", "--json", file], capture_output=True, text=True).stdout)
    theirs = json.loads(subprocess.run([judge, file], capture_output=True, text=True, check=True).stdout)
    faults = ours["faults"]
    pairs = {key: (ours[key], theirs[key])
             for key in ("vertices", "edge_manifold", "vertex_manifold", "oriented", "components")}
    pairs |= {key: (faults[own], theirs[key]) for key, own in (
        ("border_edges", "open_edges"), ("bad_edges", "crowded_edges"), ("bad_vertices", "torn_vertices"),
        ("duplicate", "duplicate"))}
    sound = faults["degenerate"] == 0  # the judge calls nothing closed that has a degenerate triangle
    if sound: pairs["closed"] = (ours["closed"], theirs["closed"])
    if sound and ours["closed"] and ours["genus"] is not None:  # of other meshes the judge has numbers, check none
        pairs |= {"genus": (ours["genus"], theirs["genus"]), "volume": ("%.6g" % ours["volume"], "%.6g" % theirs["volume"])}
    return {key: pair for key, pair in pairs.items() if pair[0] != pair[1]}


def write_off(file, points, faces):
    rows = ["OFF", "%d %d 0" % (len(points), len(faces))] + ["%r %r %r" % tuple(p) for p in points]
    file.write_text("\n".join(rows + ["3 %d %d %d" % tuple(f) for f in faces]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("--cli", "--judge"): parser.add_argument(name, required=True)
    parser.add_argument("--data", default="/nowhere")
    parser.add_argument("--most", type=int, default=12000)
    options = parser.parse_args()
    meshes = list(made())
    for path in sorted(pathlib.Path(options.data).glob("train/mesh/*.mesh.ply.gz")):
        points, faces = read_ply(gzip.decompress(path.read_bytes()))
        if len(faces) <= options.most: meshes.append((path.name.split(".")[0], points, faces))
    compared = differing = 0
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "mesh.off")
        for name, points, faces in meshes:
            for how, *broken in breakages(points, faces):
                write_off(file, *broken)
                differences = verdicts(options.cli, options.judge, file)
                compared += 1
                differing += bool(differences)
                if differences: print("%s, %s: (ours, the judge's) %s" % (name, how, differences))
    print("check agrees with the judge on %d of %d meshes (%d models)" % (compared - differing, compared, len(meshes)))
    return differing > 0


if __name__ == "__main__":
    sys.exit(main())
