"""What `pip install .` makes of a build that is there, installed into a folder of its own."""

import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

pytest.importorskip("pip")
ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture(scope="module")
def backend():
    sys.path.insert(0, str(ROOT / "tools/package"))
    import aomd_wheel
    sys.path.pop(0)
    return aomd_wheel


@pytest.fixture(scope="module")
def wheel(backend, tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    building = backend.built
    backend.built = lambda folder: None
    try:
        return folder / backend.build_wheel(folder, {"build-dir": os.environ["AOMD_BUILD"]})
    finally:
        backend.built = building


def test_it_holds_the_package_and_says_for_whom(backend, wheel):
    version = "{}.{}".format(*sys.version_info[:2]).replace(".", "")
    assert wheel.name.startswith(f"aomd-{backend.version()}-cp{version}-cp{version}-linux_")
    names = zipfile.ZipFile(wheel).namelist()
    info = f"aomd-{backend.version()}.dist-info/"
    assert {"aomd/__init__.py", "aomd/__init__.pyi", "aomd/py.typed", "aomd/pytest_plugin.py",
            info + "METADATA", info + "WHEEL", info + "entry_points.txt"} <= set(names)
    assert names[-1] == info + "RECORD"
    assert sum(name.startswith("aomd/_aomd.") for name in names) == 1
    record = zipfile.ZipFile(wheel).read(info + "RECORD").decode().splitlines()
    assert [line.split(",")[0] for line in record] == names


def test_pip_installs_it_and_pytest_finds_the_plugin(wheel, tmp_path):
    subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps",
                    "--target", tmp_path, wheel], check=True)
    place = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}
    told = subprocess.run(
        [sys.executable, "-c", "import aomd; print(aomd.__file__, aomd.sample('box').count('faces'))"],
        check=True, capture_output=True, text=True, env=place, cwd=tmp_path).stdout
    assert told == f"{tmp_path}/aomd/__init__.py 1200\n"
    for by_name in ([], ["-p", "aomd.pytest_plugin"]):
        text = subprocess.run([sys.executable, "-m", "pytest", "--help", *by_name], check=True,
                              capture_output=True, text=True, env=place, cwd=tmp_path).stdout
        assert "--aomd-update" in text


def test_an_archive_of_the_sources_has_what_building_needs(backend, tmp_path):
    if not (ROOT / ".git").exists():
        pytest.skip("no git")
    import tarfile
    name = backend.build_sdist(tmp_path)
    names = tarfile.open(tmp_path / name).getnames()
    top = f"aomd-{backend.version()}/"
    assert {top + "pyproject.toml", top + "CMakeLists.txt", top + "tools/package/aomd_wheel.py",
            top + "PKG-INFO"} <= set(names)
