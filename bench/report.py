#!/usr/bin/env python3
"""Reproduces the tables and figures of Attene and Spagnuolo 2000 in one self-contained HTML file.

  bench/report.py --build build/release OUT.html [--data DATA] [--most POINTS]

Runs bench_table1 and bench_figures of the build, and the command on the paper's sets in DATA/train/paper
(gzipped PLY files), by both methods. Without DATA those are named as missing. Needs Python 3 only.

Exit status 0; 1 if a program failed.
"""
import argparse
import base64
import datetime
import glob
import gzip
import html
import json
import os
import platform
import subprocess
import sys
import tempfile

# The objects of the paper's figures 2, 7, 8 and 9, and what stands for them here.
SETS = [
    ("venus_1079", "Figure 2: Venus, 1,079 points"),
    ("venus_15000", "Figures 7 and 9: Venus, 15,000 points"),
    ("bunny_15000", "Figure 7: Stanford bunny, 15,000 points; an open scan, closed below"),
    ("balljoint_30000_sub", "Figure 8: the ball joint is not to be had; a skull of 30,000 points stands for it"),
]
FIGURES = ["1 and 2: graphs", "3: a hidden vertex", "4: a pseudo-prism", "5: a hole is made"]
CRITERIA = ["criterion", "area / true area", "mean distance", "largest", "angles under 10°", "EMST edges off",
            "genus (true: 0)", "points lacking"]
CYCLES = ["set", "points", "3-cycles of EGH edges", "of them no Delaunay triangle"]
STYLE = """body { font: 16px/1.5 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: 1em 0 } td, th { border: 1px solid #ccc; padding: .2em .6em; text-align: right }
td:first-child, th:first-child { text-align: left } pre { background: #f6f6f6; padding: 1em; overflow-x: auto; font-size: 13px }
figure { display: inline-block; width: 330px; margin: .5em; vertical-align: top } figure img { width: 100% }
figcaption { font-size: 13px; color: #555 }"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("out")
    parser.add_argument("--build", required=True)
    parser.add_argument("--data")
    parser.add_argument("--most", type=int, default=65536)
    return parser.parse_args()


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 4):  # 4: done, but points are hidden
        raise SystemExit(f"{command[0]}: exit status {done.returncode}\n{done.stderr}")
    return done.stdout


def row(cells, tag="td"):
    return "<tr>" + "".join(f"<{tag}>{html.escape(str(c))}</{tag}>" for c in cells) + "</tr>"


def table(header, rows):
    return "<table>" + row(header, "th") + "".join(row(r) for r in rows) + "</table>"


def figure(path, caption):
    with open(path, "rb") as file:
        data = base64.b64encode(file.read()).decode()
    return (f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def points_files(data, folder):
    """The paper's sets that are there, unzipped: name to path."""
    found = {}
    for path in glob.glob(os.path.join(data or "", "train", "paper", "*.ply.gz")):
        name = os.path.basename(path)[: -len(".ply.gz")]
        if name.endswith(".truthmesh"):
            continue
        found[name] = os.path.join(folder, name + ".ply")
        with gzip.open(path, "rb") as source, open(found[name], "wb") as copy:
            copy.write(source.read())
    return found


def table_1(args, folder):
    svg = os.path.join(folder, "table1.svg")
    text = run(os.path.join(args.build, "bench", "bench_table1"), "--most", str(args.most), "--svg", svg)
    with open(svg, encoding="utf-8") as file:
        plot = file.read()
    return ["<h2>Table 1 and section 3.3</h2>", plot[plot.index("<svg"):], f"<pre>{html.escape(text)}</pre>"]


def album(args, folder, files):
    """What bench_figures drew and noted: lists of (file, text) by figure."""
    pictures = os.path.join(folder, "album")
    run(os.path.join(args.build, "bench", "bench_figures"), pictures, *files.values())
    found = {}
    with open(os.path.join(pictures, "album.tsv"), encoding="utf-8") as lines:
        for line in lines:
            name, file, text = line.rstrip("\n").split("\t")
            found.setdefault(name, []).append((os.path.join(pictures, file) if file else "", text))
    return found


def graph_figures(found):
    parts = []
    for name in FIGURES:
        parts.append(f"<h2>Figure {name}</h2>")
        parts += [figure(file, text) if file else f"<p>{html.escape(text)}</p>" for file, text in found.get(name, [])]
    rows = [text.split(" | ") for _, text in found["cycles"]]
    parts += ["<h2>3-cycles of the EGH</h2>", "<p>The paper says that each is a triangle of the Delaunay complex. That does not hold: three edges of the "
              "complex may bound none. Such cycles are left out of the EGH's triangles here.</p>",
              table(CYCLES, rows)]
    return parts


def criteria(found):
    rows = [text.split(" | ") for _, text in found["6: criteria"]]
    return ["<h2>Figure 6: criteria</h2>",
            "<p>Two unit balls, 1.4 apart, sampled 0.12 apart. Distances in ball radii, over the area of the result. "
            "Boissonnat's and Veltkamp's criteria as the paper describes them (see sculpt/priority.cpp): their "
            "original texts could not be compared.</p>",
            table(CRITERIA, rows)] + [figure(file, text.split(" | ")[0]) for file, text in found["6: criteria"]]


def paper_sets(args, folder, files):
    parts = ["<h2>Figures 2, 7, 8 and 9: the paper's sets</h2>"]
    rows, pictures = [], []
    for name, title in SETS:
        if name not in files:
            parts.append(f"<p>{html.escape(title)}: the set is not here.</p>")
            continue
        for method in ("paper", "guided"):
            picture = os.path.join(folder, f"{name}_{method}.png")
            stats = json.loads(run(os.path.join(args.build, "tetsculpt"), "--quiet", "--threads", "1", "--stats",
                                   "--method", method, "--picture", picture, files[name],
                                   os.path.join(folder, "surface.ply")))
            seconds = stats["seconds"]
            rows.append([title, method, stats["genus"], stats["components"], stats["hidden"],
                         f"{seconds['delaunay'] + seconds['graphs'] + seconds['sculpt']:.2f}"])
            pictures.append(figure(picture, f"{title}; by the {method} method: genus {stats['genus']}"))
    parts.append(table(["object", "method", "genus", "components", "points lacking", "seconds"], rows))
    return parts + pictures


def heading():
    commit = subprocess.run(["git", "-C", os.path.dirname(os.path.abspath(__file__)), "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True, check=False).stdout.strip() or "unknown"
    return ["<h1>Automatic surface reconstruction from point sets in space, again</h1>",
            f"<p>Tables and figures of M. Attene and M. Spagnuolo (2000) as this program gives them. Commit {commit}, "
            f"{datetime.date.today()}, {os.cpu_count()} cores, {platform.machine()}, {platform.system()}.</p>",
            "<p>Read as the sources say, the paper's method makes more holes on real scans than the paper's figures "
            "show: its longest-edge order enters the object through sparsely sampled spots, and where fronts meet on "
            "the surface instead of in a hole it opens another one. The pictures below show what comes out. Not "
            "built: O'Rourke's order by the Voronoi skeleton, which the paper cites; guided sculpting, which reads "
            "Voronoi poles, is its nearest kin.</p>"]


def main():
    args = arguments()
    with tempfile.TemporaryDirectory() as folder:
        files = points_files(args.data, folder)
        found = album(args, folder, files)
        parts = heading() + table_1(args, folder) + graph_figures(found) + criteria(found) + paper_sets(args, folder, files)
    with open(args.out, "w", encoding="utf-8") as out:
        out.write('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>tetsculpt: report</title>'
                  f"<style>{STYLE}</style></head><body>" + "\n".join(parts) + "</body></html>\n")
    print(f"{args.out}: {os.path.getsize(args.out) / 1e6:.1f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
