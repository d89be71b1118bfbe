"""The backend of `pip install .` (PEP 517): CMake builds and installs, this packs what lies there.

As a program, aomd_wheel.py FOLDER writes what Python knows of an installed package into FOLDER:
aomd-VERSION.dist-info, which `cmake --install` does.
"""

import base64
import hashlib
import io
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile


ROOT = pathlib.Path(__file__).resolve().parents[2]


def project():
    """The table of pyproject.toml."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def version():
    """As core/base/version.h has it."""
    text = (ROOT / "core/base/version.h").read_text()
    return ".".join(re.findall(r"#define AOMD_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))


def tag():
    """Which interpreter and which system the module is for: "cp311-cp311-linux_x86_64"."""
    system = re.sub(r"[-.]", "_", sysconfig.get_platform())
    abi = "cp{}{}".format(*sys.version_info[:2]) + getattr(sys, "abiflags", "")
    return "cp{}{}-{}-{}".format(*sys.version_info[:2], abi, system)


def metadata():
    """METADATA of a wheel, PKG-INFO of a source archive."""
    table = project()
    lines = ["Metadata-Version: 2.1", f"Name: {table['name']}", f"Version: {version()}",
             f"Summary: {table['description']}", f"Requires-Python: {table['requires-python']}",
             *(f"Requires-Dist: {name}" for name in table["dependencies"])]
    return "\n".join(lines) + "\n"


def entry_points():
    """entry_points.txt: where pytest finds the plugin."""
    return "\n".join(f"[{group}]\n" + "".join(f"{name} = {place}\n" for name, place in all.items())
                     for group, all in project()["entry-points"].items())


def write_info(folder):
    """Writes aomd-VERSION.dist-info below a folder, and returns it."""
    info = pathlib.Path(folder) / f"{project()['name']}-{version()}.dist-info"
    info.mkdir(parents=True, exist_ok=True)
    (info / "METADATA").write_text(metadata())
    (info / "entry_points.txt").write_text(entry_points())
    return info


def built(folder):
    """Builds the module where that has not been done, in a folder of CMake."""
    if not (folder / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                        "-DAOMD_BUILD_TESTS=OFF", "-DAOMD_PYTHON=ON",
                        f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
    subprocess.run(["cmake", "--build", folder, "--target", "aomd_python", "--parallel", jobs],
                   check=True)


def installed(build, stage):
    """The folder that holds the package, installed below `stage`."""
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", stage,
                    "--strip"], check=True, stdout=subprocess.DEVNULL)
    return next(pathlib.Path(stage).rglob("aomd/__init__.py")).parents[1]


def record_of(name, data):
    """The line of RECORD for one file."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def pack(root, wheel):
    """Packs all files below a folder, and the list of them that a wheel has."""
    record = next(root.glob("*.dist-info")).name + "/RECORD"
    files = sorted(path for path in root.rglob("*") if path.is_file())
    lines = ""
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in files:
            name = path.relative_to(root).as_posix()
            archive.write(path, name)
            lines += record_of(name, path.read_bytes())
        archive.writestr(record, f"{lines}{record},,\n")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517. `--config-settings build-dir=DIR` takes a folder that CMake has configured."""
    build = pathlib.Path((config_settings or {}).get("build-dir", ROOT / "build" / "wheel"))
    built(build)
    name = f"{project()['name']}-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as stage:
        root = installed(build.resolve(), stage)
        info = write_info(root)
        (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: aomd_wheel\n"
                                    f"Root-Is-Purelib: false\nTag: {tag()}\n")
        pack(root, pathlib.Path(wheel_directory) / name)
    return name


def build_sdist(sdist_directory, config_settings=None):
    """PEP 517: what git knows of."""
    name = f"{project()['name']}-{version()}"
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, text=True,
                            capture_output=True).stdout
    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as archive:
        for file in filter(None, listed.split("\0")):
            archive.add(ROOT / file, f"{name}/{file}")
        text = metadata().encode()
        entry = tarfile.TarInfo(f"{name}/PKG-INFO")
        entry.size = len(text)
        archive.addfile(entry, io.BytesIO(text))
    return f"{name}.tar.gz"


if __name__ == "__main__":
    write_info(sys.argv[1])
