#!/usr/bin/env python3
"""Reconstructs every set of a catalogue and prints a table of what came out.

  bench/quality.py --cli build/release/tetsculpt --data DATA --judge MESHCHECK [--method NAME]...
                   [--kind mesh|raw|contours|paper]... [--only NAME]... [--samples N] [--jobs N] [--volume] [--keep DIR]

DATA holds catalog.json and the gzipped PLY files it names. MESHCHECK is the program that judges each
mesh: called with MESH --points FILE [--truth MESH] --samples N, it prints one JSON object. A set whose
true surface is known counts as right if the output is closed, manifold and oriented, holds every
distinct point, and has the truth's number of components and genus. With --volume, what part of the
truth's volume is on the wrong side, too (bench/volume_difference.py). With --jobs, so many sets at a time, and
seconds that mean little. Needs Python 3 only.

Exit status 0; 1 if an output was not closed, manifold, oriented and facing outward, made of input points
without degenerate or duplicate triangles, or if one of guided sculpting lacked a point; 2 without data.
"""
import argparse
import concurrent.futures
import gzip
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

from volume_difference import volume_difference


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--cli", required=True)
    parser.add_argument("--data", required=True)
    parser.add_argument("--judge", required=True)
    parser.add_argument("--method", action="append", default=[])
    parser.add_argument("--kind", action="append", default=[])
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--samples", type=int, default=20000)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--volume", action="store_true", help="measure the volume labelled wrongly")
    parser.add_argument("--keep", help="directory to leave the surfaces in")
    return parser.parse_args()


def unzipped(path, folder):
    target = os.path.join(folder, os.path.basename(path)[: -len(".gz")])
    if not os.path.exists(target):
        with gzip.open(path, "rb") as source, open(target, "wb") as copy:
            copy.write(source.read())
    return target


def truth_of(entry):
    """The mesh that the points were taken from, if its topology was checked."""
    return entry["mesh"] if entry["kind"] == "mesh" else None


def reconstruct(args, method, points, surface):
    start = time.monotonic()
    run = subprocess.run(
        [args.cli, "--method", method, "--quiet", "--threads", "1", points, surface],
        stderr=subprocess.PIPE, text=True, check=False)
    return run.returncode, time.monotonic() - start, run.stderr.strip()


def judge(args, entry, points, surface, folder):
    command = [args.judge, surface, "--points", points, "--samples", str(args.samples)]
    truth = truth_of(entry)
    if truth:
        command += ["--truth", unzipped(os.path.join(args.data, truth), folder)]
    verdict = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
    if truth and args.volume:
        verdict["volume_wrong"] = volume_difference(surface, command[-1])
    return verdict


def is_manifold(verdict):
    return (verdict["closed"] and verdict["edge_manifold"] and verdict["vertex_manifold"]
            and verdict["oriented"] and verdict["invented"] == 0
            and verdict["degenerate"] == 0 and verdict["duplicate"] == 0 and verdict["volume"] > 0)


def is_sound(verdict):
    return is_manifold(verdict) and verdict["missing"] == 0


def is_right(entry, verdict):
    return (is_sound(verdict) and verdict["components"] == entry["components"]
            and verdict["genus"] == sum(entry["genus"]))


def row(entry, verdict, seconds):
    truth = truth_of(entry)
    expected = f"{entry['components']}/{sum(entry['genus'])}" if truth else "-"
    distance = f"{verdict['d_mean']:.1e} {verdict['d_max']:.1e}" if truth else "      -       -"
    wrong = f" {100 * verdict['volume_wrong']:6.2f}" if "volume_wrong" in verdict else ""
    mark = ("right" if is_right(entry, verdict) else "") if truth else ""
    return (f"{entry['name']:26} {entry['n']:7} {'yes' if is_sound(verdict) else 'NO':>5} "
            f"{verdict['components']}/{verdict['genus']:<5} {expected:>7} "
            f"{100 * verdict['interpolated']:6.2f} {distance}{wrong} {seconds:7.2f}  {mark}")


def measure(args, method, entry, folder):
    """What the judge says of one set's surface, or None, and the line to print."""
    points = unzipped(os.path.join(args.data, entry["file"]), folder)
    surface = os.path.join(args.keep or folder, f"{entry['name']}.{method}.ply")
    status, seconds, message = reconstruct(args, method, points, surface)
    if status not in (0, 4):
        return None, f"{entry['name']:26} exit status {status}: {message}"
    verdict = judge(args, entry, points, surface, folder)
    if not args.keep:
        os.remove(surface)
    return verdict, row(entry, verdict, seconds)


def run_method(args, method, entries, folder):
    print(f"\nmethod {method}\n{'set':26} {'points':>7} sound comp/genus truth  points%"
          f"  d_mean  d_max {'volume% ' if args.volume else ''} seconds")
    volumes = []
    manifold = sound = right = known = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for entry, result in zip(entries, pool.map(lambda e: measure(args, method, e, folder), entries)):
            verdict, text = result
            print(text, flush=True)
            if verdict is None:
                continue
            volumes += [verdict["volume_wrong"]] if "volume_wrong" in verdict else []
            manifold += is_manifold(verdict)
            sound += is_sound(verdict)
            known += truth_of(entry) is not None
            right += truth_of(entry) is not None and is_right(entry, verdict)
    print(f"{method}: of {len(entries)}, {manifold} closed, manifold and oriented, {sound} of them through "
          f"every point; {right} of {known} with the truth's components and genus")
    if volumes:
        print(f"{method}: on the wrong side, in % of the truth's volume: mean {100 * statistics.mean(volumes):.3f}, "
              f"median {100 * statistics.median(volumes):.4f}")
    return (sound if method == "guided" else manifold) == len(entries)


def main():
    args = arguments()
    catalog = os.path.join(args.data, "catalog.json")
    if not os.path.exists(catalog):
        print(f"quality: no {catalog}: nothing to reconstruct, skipped")
        return 2
    with open(catalog, encoding="utf-8") as file:
        entries = [e for e in json.load(file) if e["split"] == "train"]
    kinds = args.kind or ["mesh", "paper", "raw", "contours"]
    entries = [e for e in entries if e["kind"] in kinds and (not args.only or e["name"] in args.only)]
    if args.keep:
        os.makedirs(args.keep, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        results = [run_method(args, m, entries, folder) for m in args.method or ["guided", "paper"]]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
