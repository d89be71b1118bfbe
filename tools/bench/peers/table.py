"""table.py FOLDER CONTENDERS RUNS: the table of tools/bench/peers.sh from what the contenders left in FOLDER.

Times are medians over the runs; the ratio to meshoptimizer is the median of the ratios within each run, so that a slow
minute of the machine cancels. Results are the same in every run and measured once.
"""

import json
import os
import statistics
import sys

COLUMNS = ["faces", "ms", "min-max", "ratio", "peak MB", "Hausdorff %", "RMS %", "min angle", "% < 10 deg", "% n > 60",
           "flips", "self-int.", "Euler"]
WIDTH = {c: max(len(c), {"faces": 7, "ms": 6, "min-max": 11, "ratio": 6}.get(c, 5)) for c in COLUMNS}


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.load(file)


def seconds(run):
    """aomd's report has its stages, a peer one number."""
    stages = run["seconds"]
    return stages["adjacency"] + stages["decimate"] if isinstance(stages, dict) else stages


def peak(run):
    return run["memory_bytes"]["peak"] if "memory_bytes" in run else run["peak"]


def milliseconds(time):
    return f"{1e3 * time:.1f}" if time < 0.1 else f"{1e3 * time:.0f}"


def cells(times, reference, runs, result):
    ratio = statistics.median(t / r for t, r in zip(times, reference)) if reference else float("nan")
    return [str(result["result"]["faces"]),
            milliseconds(statistics.median(times)),
            f"{milliseconds(min(times))}-{milliseconds(max(times))}",
            f"{ratio:.2f}",
            f"{max(map(peak, runs)) / 1e6:.0f}",
            f"{result['hausdorff_pct']:.3f}",
            f"{result['rms_pct']:.4f}",
            f"{result['min_angle_mean_deg']:.1f}",
            f"{result['faces_below_10deg_pct']:.2f}",
            f"{result['normal_dev_gt60_pct']:.2f}",
            str(result["flips"]),
            str(result["self_intersections"]),
            str(result["euler"])]


def main(folder, contenders, count):
    labels, runs, errors = [], [], []
    for i in map(str, range(contenders)):
        with open(os.path.join(folder, i, "label"), encoding="utf-8") as file:
            labels.append(file.read().strip())
        error = os.path.join(folder, i, "error")
        errors.append(open(error, encoding="utf-8").read().strip() if os.path.exists(error) else "")
        runs.append([] if errors[-1] else [read(folder, i, f"{run}.json") for run in range(count)])
    reference = next(([seconds(r) for r in own] for label, own in zip(labels, runs) if label.startswith("meshopt")), [])
    width = max(map(len, labels))
    print("  ".join([" " * width] + [f"{c:>{WIDTH[c]}}" for c in COLUMNS]))
    for i, (label, own) in enumerate(zip(labels, runs)):
        if own:
            row = cells([seconds(r) for r in own], reference, own, read(folder, str(i), "compare.txt"))
            print("  ".join([f"{label:<{width}}"] + [f"{cell:>{WIDTH[c]}}" for c, cell in zip(COLUMNS, row)]))
        else:
            print(f"{label:<{width}}  {errors[i]}")
    for label, own in zip(labels, runs):
        if own and own[0].get("note"):
            print(f"{label}: {own[0]['note']}")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
