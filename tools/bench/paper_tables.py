"""paper_tables.py FOLDER RUNS MODEL...: the tables of tools/bench/paper_tables.sh from what it left in FOLDER.
paper_tables.py --into DOC TABLES: puts a file between the markers of a document.

Times are medians over the runs; a ratio is the median of the ratios within each run, so that a slow minute of the
machine cancels. Results are the same in every run.
"""

import json
import os
import re
import statistics
import sys

WAYS = ["paper-safe", "paper-paper", "quality-safe", "quality-paper"]
HEADS = ["figure", "options", "vertices", "used", "edges", "faces", "boundary edges", "2E - 3F", "Euler", "ms", "ratio",
         "T(I,J), MB", "peak, MB"]
TITLES = {"bunny": "Table 1: the bunny", "dragon": "Table 2: the dragon"}
BEGIN, END = "<!-- tables: begin -->", "<!-- tables: end -->"


def grouped(number):
    return f"{number:,}"


def row(*cells):
    return "| " + " | ".join(list(cells) + [""] * (len(HEADS) - len(cells))) + " |"


def seconds(report):
    return report["seconds"]["adjacency"] + report["seconds"]["decimate"]


def paper_row(figure, words, original):
    """What the paper says, and what follows from it when it keeps the unused vertices and edges stay of two faces."""
    head = [f"**{figure}**", "the paper"]
    if not all(word.isdigit() for word in words):
        vertices, edges, faces = (word.replace("~", "about ") for word in words)
        return row(*head, vertices, "", edges, faces)
    v, e, f = map(int, words)
    used, balance = v - original["unused_vertices"], grouped(2 * e - 3 * f)
    boundary = "" if original["nonmanifold_edges"] else balance
    derived = [boundary, balance, grouped(used - e + f)] if e else []
    return row(*head, *map(grouped, (v, used, e, f)), *derived)


def counts(c):
    return [grouped(c["vertices"]), grouped(c["vertices"] - c["unused_vertices"]), grouped(c["edges"]),
            grouped(c["faces"]), grouped(c["boundary_edges"]), grouped(2 * c["edges"] - 3 * c["faces"]),
            grouped(c["euler"])]


def our_row(options, reports, reference):
    times = [seconds(r) for r in reports]
    ratio = statistics.median(t / seconds(r) for t, r in zip(times, reference))
    memory = reports[0]["memory_bytes"]
    return row("", f"`{options}`", *counts(reports[0]["output"]), f"{1e3 * statistics.median(times):.0f}",
               f"{ratio:.1f}", f"{memory['adjacency'] / 1e6:.1f}", f"{memory['peak'] / 1e6:.0f}")


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def figure_rows(folder, figure, runs, original):
    lines = [paper_row(figure, read(folder, "paper").split(), original)]
    if not os.path.exists(os.path.join(folder, f"{WAYS[0]}.options")):
        return lines + [row("", "as read", *counts(original))]
    reports = {way: [json.loads(read(folder, f"{way}-{run}.json")) for run in range(runs)] for way in WAYS}
    return lines + [our_row(read(folder, f"{way}.options").strip(), reports[way], reports[WAYS[0]]) for way in WAYS]


def table(folder, model, runs):
    figures = sorted(os.listdir(os.path.join(folder, model)), key=int)
    original = json.loads(read(folder, model, figures[-1], f"{WAYS[0]}-0.json"))["input"]
    lines = [f"### {TITLES[model]}", "", row(*HEADS), "|---|---" + "|---:" * (len(HEADS) - 2) + "|"]
    for figure in figures:
        lines += figure_rows(os.path.join(folder, model, figure), figure, runs, original)
    return "\n".join(lines)


def put_into(document, tables):
    text = read(document)
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit(f"paper_tables: {document} has no place for the tables: {BEGIN} ... {END}")
    block = re.compile(re.escape(BEGIN) + ".*" + re.escape(END), re.DOTALL)
    with open(document, "w", encoding="utf-8") as file:
        file.write(block.sub(lambda _: f"{BEGIN}\n{read(tables).strip()}\n{END}", text))


def main(words):
    if words[0] == "--into":
        put_into(words[1], words[2])
    else:
        print("\n\n".join(table(words[0], model, int(words[1])) for model in words[2:]))


if __name__ == "__main__":
    main(sys.argv[1:])
