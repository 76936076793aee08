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
    at = lambda i, j: (lambda k, l: k % n * m + l % m)(*seam(i, j))
    faces = [(at(i, j), at(i + 1, j + k), at(i + 1 - k, j + 1)) for i in range(n) for j in range(m) for k in (0, 1)]
    return [point(2 * math.pi * i / n, 2 * math.pi * j / m) for i in range(n) for j in range(m)], faces


def klein(u, v):
    x, z = math.sin(v), math.sin(2 * v)
    r = 3 + math.cos(u / 2) * x - math.sin(u / 2) * z
    return (r * math.cos(u), r * math.sin(u), math.sin(u / 2) * x + math.cos(u / 2) * z)


def made():
    tetrahedron = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
    yield "tetrahedron", tetrahedron, faces
    torus = lambda u, v: ((3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u), math.sin(v))
    yield "torus", *grid(12, 9, torus)
    yield "klein", *grid(12, 8, klein, lambda i, j: (i, j) if i < 12 else (0, -j))
    yield "open tube", *(part[:126 - 14] for part in grid(9, 7, torus))
    strip = [tuple(k if k < 18 else 19 - k for k in t) for i in range(0, 18, 2)
             for t in ((i, i + 1, i + 2), (i + 1, i + 3, i + 2))]
    yield "moebius", [klein(math.pi * (i // 2) / 4.5, i % 2 + 0.5) for i in range(18)], strip
    for shared in range(4):  # nothing, a vertex, an edge, a triangle
        shift = [k if k < shared else k + 4 for k in range(4)]
        yield "two sharing %d" % shared, tetrahedron + [(-7 - x, -y, -z) for x, y, z in tetrahedron], faces + [
            tuple(shift[k] for k in f) for f in faces]
    yield "a cavity", tetrahedron + [tuple(0.1 + x / 9 for x in p) for p in tetrahedron], faces + [
        (4 + a, 4 + c, 4 + b) for a, b, c in faces]
    yield "a soup", [tetrahedron[k] for f in faces for k in f], [(i, i + 1, i + 2) for i in range(0, 12, 3)]


def breakages(points, faces):
    first, (a, b, c) = faces[0], faces[len(faces) // 2]
    yield "sound", points, faces
    yield "removed", points, faces[1:]
    yield "two removed", points, faces[1:-1]
    yield "flipped", points, [(a, c, b) if f == (a, b, c) else f for f in faces]
    yield "all flipped", points, [(x, z, y) for x, y, z in faces]
    yield "duplicated", points, faces + [(a, b, c)]
    yield "duplicated and turned", points, faces + [(c, b, a)]
    yield "degenerate", points, faces + [(a, a, b)]
    yield "degenerate by position", points + [points[a]], faces + [(a, len(points), b)]
    yield "a fin", points + [(9, 9, 9)], faces + [(a, b, len(points))]
    yield "a vertex more", points + [(9, 9, 9)], faces
    yield "pinched", points, [tuple(first[0] if k == c else k for k in f) for f in faces]


def read_ply(data):
    head, body = data.split(b"end_header\n", 1)
    words = [line.split() for line in head.decode().split("\n")]
    point = struct.Struct("<3d" if ["property", "double", "x"] in words else "<3f")
    end = point.size * next(int(w[2]) for w in words if w[:2] == ["element", "vertex"])
    return list(point.iter_unpack(body[:end])), [row[1:] for row in struct.iter_unpack("<B3i", body[end:])]


def verdicts(cli, judge, file):
    ours = json.loads(subprocess.run([cli, "check", "--weld", "--json", file], capture_output=True, text=True).stdout)
    theirs = json.loads(subprocess.run([judge, file], capture_output=True, text=True, check=True).stdout)
    faults = ours["faults"]
    pairs = {key: (ours[key], theirs[key])
             for key in ("vertices", "edge_manifold", "vertex_manifold", "oriented", "components")}
    names = {"open_edges": "border_edges", "crowded_edges": "bad_edges", "torn_vertices": "bad_vertices"}
    pairs |= {key: (faults[key], theirs[name]) for key, name in (names | {"duplicate": "duplicate"}).items()}
    sound = faults["degenerate"] == 0  # the judge calls nothing closed that has a degenerate triangle
    if sound: pairs["closed"] = (ours["closed"], theirs["closed"])
    if sound and ours["closed"] and ours["genus"] is not None:  # of other meshes the judge has numbers, check none
        pairs |= {"genus": (ours["genus"], theirs["genus"]), "volume": ("%.6g" % ours["volume"], "%.6g" % theirs["volume"])}
    return {key: pair for key, pair in pairs.items() if pair[0] != pair[1]}


def write_off(file, points, faces):
    file.write_text("OFF %d %d 0\n" % (len(points), len(faces)) + "".join("%r %r %r\n" % tuple(p) for p in points)
                    + "".join("3 %d %d %d\n" % tuple(f) for f in faces))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("--cli", "--judge"): parser.add_argument(name, required=True)
    parser.add_argument("--data", default="/nowhere")
    parser.add_argument("--most", type=int, default=6000)
    options = parser.parse_args()
    meshes = list(made())
    for path in sorted(pathlib.Path(options.data).glob("train/mesh/*.mesh.ply.gz")):
        points, faces = read_ply(gzip.decompress(path.read_bytes()))
        if len(faces) <= options.most: meshes.append((path.name.split(".")[0], points, faces))
    with tempfile.TemporaryDirectory() as folder:
        file, results = pathlib.Path(folder, "mesh.off"), []
        for name, points, faces in meshes:
            for how, *broken in breakages(points, faces):
                write_off(file, *broken)
                results.append(verdicts(options.cli, options.judge, file))
                if results[-1]: print("%s, %s: (ours, the judge's) %s" % (name, how, results[-1]))
    print("check agrees with the judge on %d of %d meshes (%d models)" % (results.count({}), len(results), len(meshes)))
    return any(results)


if __name__ == "__main__":
    sys.exit(main())
