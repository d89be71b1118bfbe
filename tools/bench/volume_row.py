"""One row of the table of volumes.sh: decimates a mesh, or lets another library do it, and measures the result."""
import json
import os
import subprocess
import sys

DEFECTS = ("inverted", "repeated_tets", "nonconforming_faces", "folded_faces", "surface_intersections", "regions_lost",
           "regions_with_other_euler", "regions_with_other_parts", "tags_lost", "surfaces_lost", "surfaces_added",
           "surfaces_with_other_euler")


def run(command):
    """CPU seconds and peak memory in MB of a command."""
    # A shell starts it: the memory of a process counts that of the one that forked it.
    process = subprocess.Popen(["sh", "-c", '"$@"; exit $?', "sh"] + command, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    errors = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        raise RuntimeError(errors.strip() or f"ended with {os.waitstatus_to_exitcode(status)}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def decimate(mesh, percent, regularity, result):
    cpu, _ = run([os.environ["AOMD_PROGRAM"], "decimate", mesh, result, "--strategy", "quality", "--target-tets",
                  percent + "%", "--regularity", regularity, "--quiet", "--report", result + ".json"])
    with open(result + ".json") as file:
        peak = json.load(file)["memory_bytes"]["peak"]
    return cpu, peak / 2**20


def tets_of(mesh):
    return json.loads(subprocess.run([os.environ["AOMD_PROGRAM"], "info", mesh, "--json"], capture_output=True, text=True,
                                     check=True).stdout)["input"]["regions"]


def remesh(peer, original, percent, result):
    """What is timed is the last run: a factor that leads to the target is looked for before."""
    _, wants = subprocess.run([peer], capture_output=True, text=True, check=True).stdout.splitlines()
    target = tets_of(original) * float(percent) / 100
    if wants == "tets":
        return run([peer, original, result, str(round(target))])
    factor = (100 / float(percent)) ** (1 / 3)
    for _ in range(8):
        used = run([peer, original, result, str(factor)])
        tets = tets_of(result)
        if abs(tets / target - 1) < 0.025:
            break
        factor *= (tets / target) ** (1 / 3)
    return used


def measured(result, original):
    metric = os.environ["AOMD_METRIC"]
    if not metric:
        info = json.loads(subprocess.run([os.environ["AOMD_PROGRAM"], "info", result, "--json"], capture_output=True,
                                         text=True, check=True).stdout)
        return {"tets": str(info["input"]["regions"])}
    lines = subprocess.run([metric, result, original, "--samples", os.environ["AOMD_SAMPLES"], "--list", "--match-regions"],
                           capture_output=True, text=True, check=True).stdout.splitlines()
    return dict(line.split(": ", 1) for line in lines if ": " in line)


def number(values, key, digits):
    return f"{float(values[key]):.{digits}f}" if key in values else "-"


def main():
    mesh, original, percent, how, result = sys.argv[1:]
    name = os.path.basename(mesh).split(".")[0]
    peer = os.path.isfile(how)
    if peer:
        mesh, how = how, subprocess.run([how], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    try:
        cpu, megabytes = remesh(mesh, original, percent, result) if peer else decimate(mesh, percent, how, result)
    except RuntimeError as error:
        words = str(error).splitlines()[-1].split(": ")[-1][:60]
        print(f"| {name}, {percent} % | {how} | - | - | - | - | - | - | - | - | - | {words} |", flush=True)
        return
    m = measured(result, original)
    curve = "curve" if "curve_rms" in m else "tagged_curve"
    pair = lambda key: number(m, key + "_rms", 4) + " / " + number(m, key + "_hausdorff", 2)
    angles = " / ".join(number(m, key, 1) for key in ("dihedral_min", "dihedral_p5", "dihedral_mean_smallest"))
    defects = ", ".join(f"{key} {m[key]}" for key in DEFECTS if float(m.get(key, "0").split()[0]) != 0)
    print(f"| {name}, {percent} % | {how} | {m.get('tets', '-')} | {angles} | "
          f"{number(m, 'dihedral_below_10_percent', 2)} | {number(m, 'region_volume_change_worst_percent', 4)} | "
          f"{pair('boundary')} | {pair('interface')} | {pair(curve)} | {cpu:.2f} | {megabytes:.0f} | {defects} |",
          flush=True)


main()
