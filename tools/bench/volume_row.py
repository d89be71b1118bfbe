"""One row of the table of volumes.sh: decimates a mesh and measures the result."""
import json
import os
import resource
import subprocess
import sys

DEFECTS = ("inverted", "repeated_tets", "nonconforming_faces", "folded_faces", "surface_intersections", "regions_lost",
           "regions_with_other_euler", "regions_with_other_parts", "tags_lost", "surfaces_lost", "surfaces_added",
           "surfaces_with_other_euler")


def decimate(mesh, percent, regularity, result):
    command = [os.environ["AOMD_PROGRAM"], "decimate", mesh, result, "--strategy", "quality", "--target-tets",
               percent + "%", "--regularity", regularity, "--quiet", "--report", result + ".json"]
    # A shell starts it: the memory of a process counts that of the one that forked it.
    status = subprocess.run(["sh", "-c", '"$@"; exit $?', "sh"] + command, capture_output=True, text=True)
    if status.returncode not in (0, 1):
        sys.exit(status.stderr.strip())
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(result + ".json") as file:
        peak = json.load(file)["memory_bytes"]["peak"]
    return used.ru_utime + used.ru_stime, peak / 2**20


def measured(result, original):
    metric = os.environ["AOMD_METRIC"]
    if not metric:
        info = json.loads(subprocess.run([os.environ["AOMD_PROGRAM"], "info", result, "--json"], capture_output=True,
                                         text=True, check=True).stdout)
        return {"tets": str(info.get("regions", "-"))}
    lines = subprocess.run([metric, result, original, "--samples", os.environ["AOMD_SAMPLES"], "--list", "--match-regions"],
                           capture_output=True, text=True, check=True).stdout.splitlines()
    return dict(line.split(": ", 1) for line in lines if ": " in line)


def number(values, key, digits):
    return f"{float(values[key]):.{digits}f}" if key in values else "-"


def main():
    mesh, original, percent, regularity, result = sys.argv[1:]
    cpu, megabytes = decimate(mesh, percent, regularity, result)
    m = measured(result, original)
    curve = "curve" if "curve_rms" in m else "tagged_curve"
    pair = lambda key: number(m, key + "_rms", 4) + " / " + number(m, key + "_hausdorff", 2)
    angles = " / ".join(number(m, key, 1) for key in ("dihedral_min", "dihedral_p5", "dihedral_mean_smallest"))
    defects = ", ".join(f"{key} {m[key]}" for key in DEFECTS if float(m.get(key, "0").split()[0]) != 0)
    name = os.path.basename(mesh).split(".")[0]
    print(f"| {name}, {percent} % | {regularity} | {m.get('tets', '-')} | {angles} | "
          f"{number(m, 'dihedral_below_10_percent', 2)} | {number(m, 'region_volume_change_worst_percent', 4)} | "
          f"{pair('boundary')} | {pair('interface')} | {pair(curve)} | {cpu:.2f} | {megabytes:.0f} | {defects} |",
          flush=True)


main()
