"""Breaks a copy of the source in one place at a time and tells which tests notice.

    cmake --build build/release --target fault_injection       # all of them: about an hour on two cores
    python3 tests/faults/run_faults.py --only fresnel_inverted --work build/release/faults
    python3 tests/faults/run_faults.py --check                 # only whether every fault still fits the source

The copy and its build stay in the work folder, so that a second run compiles only what a fault changes. Without any
fault the tests have to be green. Exit code: 0 every fault was noticed, 1 one was not, 2 one does not fit any more or
something could not be built. The report is WORK/report.md and WORK/report.json; what --only leaves out stays in it as it was.
"""
import argparse
import filecmp
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import fault_files

COPIED = ["CMakeLists.txt", "raycore", "game", "tests", "tools"]
SLOWER = 10  # a test program that takes so many times its usual time, and a minute more, is stuck


def run(command, **more):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **more)


def mirror(source, target):
    """Copies what has changed only: times of files are what the build goes by."""
    wanted = set()
    for name in COPIED:
        top = source / name
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            if path.is_dir() or "__pycache__" in path.parts:
                continue
            to = target / path.relative_to(source)
            wanted.add(to)
            if to.is_file() and filecmp.cmp(path, to, shallow=False):
                continue
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, to)
            shutil.copymode(path, to)
    for name in COPIED:
        for path in (target / name).rglob("*"):
            if path.is_file() and path not in wanted:
                path.unlink()
    assets = target / "assets"
    if not assets.is_symlink():
        assets.symlink_to(source / "assets")


class Bench:
    """The copy, its build, and how long its tests take when nothing is wrong."""

    def __init__(self, options, source):
        self.work = options.work.resolve()
        self.source, self.build = self.work / "source", self.work / "build"
        self.jobs, self.usual = options.jobs, {}
        mirror(source, self.source)
        command = ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        command += [f"-D{setting}" for setting in options.define]
        configured = run(command)
        if configured.returncode != 0:
            sys.exit(f"{configured.stdout}\nfault_injection: the copy cannot be configured")

    def compile(self, rooms):
        targets = [f"{room}_tests" for room in rooms]
        return run(["ninja", "-C", self.build, f"-j{self.jobs}", *targets])

    def failures(self, room):
        """Names of tests that fail; a program that dies or hangs is one more. Shards run side by side."""
        limit = None if room not in self.usual else SLOWER * self.usual[room] + 60
        begun, shards, red = time.monotonic(), [], []
        for shard in range(self.jobs):
            out = self.work / f"{room}.{shard}.json"
            out.unlink(missing_ok=True)
            environment = dict(os.environ, GTEST_TOTAL_SHARDS=str(self.jobs), GTEST_SHARD_INDEX=str(shard))
            program = [self.build / "bin" / f"{room}_tests", f"--gtest_output=json:{out}", "--gtest_brief=1"]
            shards.append((out, subprocess.Popen(program, env=environment, cwd=self.work, stdout=subprocess.DEVNULL,
                                                 stderr=subprocess.DEVNULL)))
        for out, process in shards:
            try:
                left = None if limit is None else max(1.0, limit - (time.monotonic() - begun))
                code = process.wait(timeout=left)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                red.append(f"{room}_tests is stuck")
                continue
            if not out.is_file():
                red.append(f"{room}_tests dies ({code})")
                continue
            for suite in json.loads(out.read_text())["testsuites"]:
                red += [f"{suite['name']}.{test['name']}" for test in suite["testsuite"] if test.get("failures")]
        self.usual.setdefault(room, time.monotonic() - begun)
        return red

    def try_out(self, fault):
        """Names of the tests that notice."""
        originals = {}
        try:
            for path, text in fault_files.with_fault(fault, self.source).items():
                originals[path] = path.read_text()
                path.write_text(text)
            built = self.compile(fault.rooms)
            if built.returncode != 0:
                raise fault_files.Stale(f"{fault.name} does not compile:\n{built.stdout[-3000:]}")
            red = []
            for room in fault.rooms:
                red += self.failures(room)
            return red
        finally:
            for path, text in originals.items():
                path.write_text(text)


def table(results):
    lines = ["| fault | rooms asked | tests that go red |", "|---|---|---|"]
    for _, result in sorted(results.items()):
        red = result["red"]
        shown = "**nobody**" if not red else ", ".join(red[:3]) + (f" and {len(red) - 3} more" if len(red) > 3 else "")
        lines.append(f"| {result['sentence']} | {' '.join(result['rooms'])} | {shown} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    here = pathlib.Path(__file__).resolve().parent
    parser.add_argument("--work", type=pathlib.Path, default=here.parents[1] / "build" / "release" / "faults")
    parser.add_argument("--only", nargs="*", help="names of faults")
    parser.add_argument("--check", action="store_true", help="only whether the faults fit the source")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--define", nargs="*", default=[], help="CMake settings of the copy, NAME=VALUE")
    options = parser.parse_args()
    source = here.parents[1]
    faults = fault_files.read_faults(here)
    for fault in faults:
        fault_files.with_fault(fault, source)
    if options.check:
        print(f"{len(faults)} faults, all of which fit")
        return 0
    if options.only:
        if strangers := set(options.only) - {fault.name for fault in faults}:
            raise fault_files.Stale(f"there is no fault called {', '.join(sorted(strangers))}")
        faults = [fault for fault in faults if fault.name in options.only]

    bench = Bench(options, source)
    rooms = sorted({room for fault in faults for room in fault.rooms})
    print(f"without a fault: {', '.join(rooms)}", flush=True)
    built = bench.compile(rooms)
    if built.returncode != 0:
        sys.exit(f"{built.stdout[-3000:]}\nfault_injection: the copy cannot be built")
    for room in rooms:
        if red := bench.failures(room):
            sys.exit(f"fault_injection: red without any fault: {', '.join(red)}")
        print(f"{room}: green in {bench.usual[room]:.0f} s", flush=True)

    report = bench.work / "report.json"
    results = json.loads(report.read_text()) if report.is_file() else {}
    unnoticed = []
    for number, fault in enumerate(faults, 1):
        begun = time.monotonic()
        red = bench.try_out(fault)
        results[fault.name] = {"sentence": fault.sentence, "rooms": fault.rooms, "red": red}
        unnoticed += [] if red else [fault.name]
        told = f"{len(red)} tests" if red else "NOBODY NOTICES"
        print(f"[{number}/{len(faults)}] {fault.name}: {told} ({time.monotonic() - begun:.0f} s)", flush=True)
        report.write_text(json.dumps(results, indent=1))
        (bench.work / "report.md").write_text(table(results))
    print(f"{len(faults) - len(unnoticed)} of {len(faults)} faults are noticed; {bench.work / 'report.md'}")
    return 1 if unnoticed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except fault_files.Stale as stale:
        print(f"fault_injection: {stale}", file=sys.stderr)
        sys.exit(2)
