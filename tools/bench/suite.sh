#!/usr/bin/env bash
# tools/bench/suite.sh [-n RUNS] [FOLDER]: a suite of 50 pictures, ten meshes of FOLDER (../shared/data) from five sides,
# against a script that opens each mesh once and draws the same pictures, in turn; then one case alone against
# f3d --output --ref (under Xvfb) on three of the meshes. Prints the least CPU time of each, whole processes. AOMD_VIEW
# names the program (build/bin/aomd-view). Needs python3; f3d and xvfb for the second part.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD_VIEW:-$root/build/bin/aomd-view}
runs=3
if [ "${1:-}" = -n ]; then
  runs=$2
  shift 2
fi
[ -x "$program" ] || { echo "bench: no $program; build first (tools/view.sh)" >&2; exit 2; }

PYTHONPATH=$root/tools/bench exec python3 -B - "$program" "$runs" "${1:-$root/../shared/data}" <<'PYTHON'
import os, shutil, sys, tempfile

from process import measure, screen

program, runs, folder = sys.argv[1], int(sys.argv[2]), os.path.abspath(sys.argv[3])
sides = ["iso", "front", "back", "left", "top"]
names = ["beetle.obj", "blobby_3cc.off", "bunny.ply", "cheese.off", "dtc_hull.stl", "fandisk.off", "rocker_arm.obj",
         "t5_spheres_v41.msh", "tray_bottom.stl", "turbine.off"]
meshes = [os.path.join(folder, name) for name in names]
missing = [mesh for mesh in meshes if not os.path.exists(mesh)]
if missing:
    sys.exit(f"bench: there is no {missing[0]}")
work = tempfile.mkdtemp()


def cpu(command, environment=None):
    return measure(command, work, environment)


def in_turn(*measures):
    """The least of each."""
    found = [[measure() for measure in measures] for _ in range(runs)]
    return [tuple(min(part) for part in zip(*each)) for each in zip(*found)]


def write_suite(name, chosen):
    with open(os.path.join(work, name), "w") as suite:
        suite.write("[cases]\n")
        for mesh in chosen:
            for side in sides:
                case = os.path.basename(mesh).replace(".", "-") + "-" + side
                suite.write(f'{case} = {{ mesh = "{mesh}", camera = "{side}" }}\n')


def compare_with_script():
    write_suite("suite.toml", meshes)
    with open(os.path.join(work, "all.aomd"), "w") as script:
        for mesh in meshes:
            script.write(f'open "{mesh}"\nwait-idle\n')
            for side in sides:
                script.write(f"camera {side}\nscreenshot picture-{side}.png 640x480 no-ui\n")
    test = [program, "test", "suite.toml"]
    cpu(test + ["--update"])
    suite, script = in_turn(lambda: cpu(test), lambda: cpu([program, "--headless", "--script", "all.aomd"]))
    print(f"50 cases, 10 meshes: suite {suite[0]:.2f} s ({suite[1]:.0f} MB), one script {script[0]:.2f} s "
          f"({script[1]:.0f} MB), ratio {suite[0] / script[0]:.2f}")


def compare_with_f3d():
    with screen("640x480") as with_display:
        for mesh in (os.path.join(folder, name) for name in ("bunny.ply", "dtc_hull.stl", "rocker_arm.obj")):
            with open(os.path.join(work, "one.toml"), "w") as suite:
                suite.write(f'[cases]\none = "{mesh}"\n')
            test = [program, "test", "one.toml"]
            draw = ["f3d", mesh, "--resolution", "640,480", "--output"]
            cpu(test + ["--update"])
            cpu(draw + ["reference.png"], with_display)
            ours, theirs = in_turn(
                lambda: cpu(test), lambda: cpu(draw + ["result.png", "--ref", "reference.png"], with_display))
            print(f"{os.path.basename(mesh)}: a case {ours[0]:.2f} s ({ours[1]:.0f} MB), f3d {theirs[0]:.2f} s "
                  f"({theirs[1]:.0f} MB), ratio {ours[0] / theirs[0]:.2f}")


try:
    compare_with_script()
    if shutil.which("f3d") and shutil.which("Xvfb"):
        compare_with_f3d()
finally:
    shutil.rmtree(work)
PYTHON
