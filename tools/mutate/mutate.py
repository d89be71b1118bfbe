#!/usr/bin/env python3
"""Breaks one line of the sources at a time and sees whether a test goes red.

tools/mutate/mutate.py [--build FOLDER] [--only TEXT] [--every N] [--list | --check]
                       [--seconds N]

Reads tools/mutate/mutations.txt. An entry is a paragraph of lines:

    name: what the mutation breaks, in words
    file: core/mesh/id_pool.cpp
    from: the line, or a part of one, that stands in the file exactly once
    to:   what takes its place
    tests: the test programs that should notice, in the order in which to try them
    survives: why no test can notice (only for those that are known to survive)

The sources are copied, so that the working tree stays as it is; the copy is built in FOLDER
(build/mutate by default), which is kept for the next time. Prints a line a mutation and a summary;
exit code 1 where a mutation survives that is not known to, where one is killed that is, where an
entry fits no line, or where a test fails without any mutation: that one is not asked then.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ["CMakeLists.txt", "LICENSE", "cmake", "core", "viewer", "tools", "tests", "shaders",
           "assets"]


class Mutation:
    """One entry of the list."""

    def __init__(self, paragraph):
        fields = {}
        for line in paragraph.splitlines():
            key, _, value = line.partition(":")
            fields[key.strip()] = value.removeprefix(" ").rstrip()
        self.name, self.file = fields["name"], fields["file"].strip()
        self.old, self.new = fields["from"], fields.get("to", "")
        self.tests = fields["tests"].split()
        self.survives = fields.get("survives", "")


def read_list(path):
    text = "\n".join(l for l in path.read_text().splitlines() if not l.startswith("#"))
    return [Mutation(p) for p in text.split("\n\n") if p.strip()]


def copy_sources(folder):
    """Brings the copy up to date; files that have not changed keep their times, so that little is
    built again."""
    for name in SOURCES:
        source = ROOT / name
        for file in [source] if source.is_file() else source.rglob("*"):
            if file.is_dir():
                continue
            target = folder / file.relative_to(ROOT)
            if not target.exists() or target.read_bytes() != file.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, target)


class Build:
    """The copy of the sources, and its tests."""

    def __init__(self, folder):
        self.sources, self.binaries = folder, folder / "build"
        self.not_asked = set()
        self.sources.mkdir(parents=True, exist_ok=True)
        copy_sources(self.sources)
        if not (self.binaries / "CMakeCache.txt").exists():
            self.call(["cmake", "-S", str(self.sources), "-B", str(self.binaries), "-G", "Ninja",
                       "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                       "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"], check=True)

    @staticmethod
    def call(command, **options):
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, text=True, **options)

    def make(self, targets):
        return self.call(["cmake", "--build", str(self.binaries), "--target", *targets])

    def first_failing(self, tests, seconds):
        """The first of the programs that fails, with the reason; None where all pass."""
        for test in (t for t in tests if t not in self.not_asked):
            try:
                run = self.call([str(self.binaries / "bin" / test), "--gtest_fail_fast",
                                 "--gtest_brief=1"], cwd=self.binaries, timeout=seconds)
            except subprocess.TimeoutExpired:
                return f"{test}: does not end"
            if run.returncode != 0:
                failed = [l for l in run.stdout.splitlines() if l.startswith("[  FAILED  ]")]
                case = failed[0].split("]")[1].split("(")[0].strip() if failed else "aborts"
                return f"{test}: {case}"
        return None


def misfits(mutations):
    """What is wrong with entries, without building anything: lines that stand elsewhere or not at
    all, test programs that are none."""
    programs = {f.stem for f in (ROOT / "tests").rglob("*_test.cpp")}
    for m in mutations:
        path = ROOT / m.file
        times = path.read_text().count(m.old) if path.exists() else 0
        if times != 1:
            yield f"{m.file}: {m.name}: stands {times} times"
        yield from (f"{m.name}: no test program {t}" for t in m.tests if t not in programs)


def try_out(mutation, build, seconds):
    """What became of a mutation: 'killed', 'survived' or 'unfit', and by what or why."""
    path = build.sources / mutation.file
    text = path.read_text()
    if text.count(mutation.old) != 1:
        return "unfit", f"stands {text.count(mutation.old)} times in {mutation.file}"
    path.write_text(text.replace(mutation.old, mutation.new))
    try:
        made = build.make(mutation.tests)
        if made.returncode != 0:
            return "unfit", "does not compile"
        killer = build.first_failing(mutation.tests, seconds)
        return ("killed", killer) if killer else ("survived", mutation.survives)
    finally:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "mutate")
    parser.add_argument("--only", default="", help="mutations whose name or file holds this text")
    parser.add_argument("--every", type=int, default=1,
                        help="each so many-th of these: a look at all areas in less time")
    parser.add_argument("--list", action="store_true", help="names them and ends")
    parser.add_argument("--check", action="store_true",
                        help="whether every entry fits a line, and ends; builds nothing")
    parser.add_argument("--seconds", type=int, default=120, help="for each test program")
    options = parser.parse_args()
    mutations = [m for m in read_list(ROOT / "tools" / "mutate" / "mutations.txt")
                 if options.only in m.name or options.only in m.file][::options.every]
    if options.list:
        print("\n".join(f"{m.file}: {m.name}" for m in mutations))
        return 0
    if options.check:
        found = list(misfits(mutations))
        print("\n".join([*found, f"{len(mutations)} mutations, {len(found)} misfits"]))
        return 1 if found else 0

    build = Build(options.build.resolve())
    tests = sorted({t for m in mutations for t in m.tests})
    made = build.make(tests)
    if made.returncode != 0:
        sys.exit(made.stdout[-2000:] + "\nmutate: the sources do not build as they are")
    unexpected = 0
    for test in tests:
        if failing := build.first_failing([test], options.seconds):
            print(f"not asked: it fails as it is: {failing}", flush=True)
            build.not_asked.add(test)
            unexpected += 1

    count = {"killed": 0, "survived": 0, "unfit": 0}
    for mutation in mutations:
        outcome, why = try_out(mutation, build, options.seconds)
        count[outcome] += 1
        expected = "survived" if mutation.survives else "killed"
        unexpected += outcome != expected
        print(f"{outcome:8} {mutation.file}: {mutation.name} ({why})", flush=True)
    print(f"{len(mutations)} mutations: {count['killed']} killed, {count['survived']} survived, "
          f"{count['unfit']} unfit; {unexpected} not as expected")
    return 1 if unexpected else 0


if __name__ == "__main__":
    sys.exit(main())
