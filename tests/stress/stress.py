#!/usr/bin/env python3
"""Draws strikes at random and judges each by what can be said from outside of the program's own ledger.

    python3 tests/stress/stress.py build/bin/birdstrike --seed 1 --count 200 --jobs 2
    python3 tests/stress/stress.py build/bin/birdstrike --seed 7 --only fold --keep failures     # one scene again, its files kept

Three of four scenes are of the kind 'strike': any bird on any blade (strikes.py); the others take a corner of the range each (draws.py).
Each runs with one thread and two (every number the same), and once more elsewhere: turned, mirrored, 1000 m away, seen by somebody who
moves (placing.py), or scaled, or with another order of its mesh (twins.py). Some run with another interval of output (the same
summary). A row a scene, then the worst figures; exit code 1 if one fails that open.txt does not name. A stop (exit 3) or refusal (2) in
words is no failure, but counted and listed.
"""

import argparse
import concurrent.futures
import os
import random
import shutil
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes"))

import crossings  # noqa: E402
import draws  # noqa: E402
import gathered  # noqa: E402
import loaded  # noqa: E402
import strike  # noqa: E402
import strikes  # noqa: E402
import turning  # noqa: E402
import twins  # noqa: E402
from judge import judge  # noqa: E402
from scene import Scene  # noqa: E402

NEWER = {**turning.KINDS, **gathered.KINDS}
KINDS = {"strike": strikes.strike, **draws.KINDS, **NEWER}
ORDER = [kind for special in draws.KINDS for kind in ("strike", "strike", "strike", special)]
ORDER_WITH_NEWER = [kind for k, special in enumerate(draws.KINDS) for kind in ("strike", "strike", list(NEWER)[k % len(NEWER)], special)]
WITH_NEWER = 100000  # the first seed that may draw a newer kind; those below draw what they always have
FIELDS = 40
OPEN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "open.txt")


def known_to_fail():
    """'kind seed' of the scenes that are known to fail and still do: named in every table, and no news."""
    with open(OPEN) as file:
        return {" ".join(line.split()[:2]) for line in file if line.strip() and not line.startswith("#")}


def kind_of(seed, only):
    if not isinstance(seed, int):
        return "frozen"
    order = only or (ORDER_WITH_NEWER if seed >= WITH_NEWER else ORDER)
    return order[seed % len(order)]


def draw_scene(kind, seed):
    scene = Scene(kind, seed)
    KINDS[kind](scene, random.Random(f"{kind} {seed}"))
    scene.set("Time/Smallest step", 5e-3)  # what is crushed to a two hundredth of its first step ends there, not after minutes
    return scene


class Runs:
    def __init__(self, program, folder, limit):
        self.program, self.folder, self.limit = program, folder, limit
        self.start = loaded.starter(program)

    def run(self, scene, name, *settings):
        path = scene.write(self.folder, name)
        result = strike.run(self.program, path, os.path.join(self.folder, name + ".run"), settings, self.limit, self.start)
        with open(os.path.join(self.folder, name + ".txt"), "w") as file:
            file.write(result.text)
        return result

    def first(self, scene):
        if not scene.blade:  # without it nothing is known of the mid-surface
            return self.run(scene, "scene")
        return self.run(scene, "scene", "Output/Bird fields=true", "Output/Blade fields=true",
                        f"Output/Field interval={scene.info['end'] / FIELDS!r}")

    def compare(self, scene, first):
        """Threads, output interval, twin: faults and the twin's words."""
        faults, draw = [], random.Random(f"twin {scene.kind} {scene.seed}")
        half = int(first.columns["step"][-1]) // 2 + 1
        checkpoint = (f"Output/Checkpoint/Step interval={half}", "Output/Checkpoint/At the end=false") if scene.kind in NEWER else ()
        threads = self.run(scene, "threads", "Time/Threads=2", *checkpoint)
        if threads.code != first.code or threads.history_bytes != first.history_bytes:
            faults.append(f"two threads: exit {threads.code}, another history.csv")
        if checkpoint:
            resumed = strike.resume(self.program, threads.folder, self.limit, self.start)
            if resumed.code != first.code or resumed.history_bytes != first.history_bytes:
                faults.append(f"resumed at step {half}: exit {resumed.code}: {resumed.stop()[:100]}, another history.csv")
        if scene.seed % 4 == 0:
            rows = self.run(scene, "interval", f"Output/History interval={scene.info['end'] / 7.3!r}")
            other = twins.summary_difference(first, rows) if rows.summary else [f"exit {rows.code}"]
            if other:
                faults.append("output interval: " + ", ".join(other))
        if scene.can_be_placed or scene.kind in NEWER:
            elsewhere = twins.Elsewhere(scene, first, draw, self.run)
            compared = [twins.compare_places(elsewhere)] if scene.can_be_placed else []
            compared.append(twins.compare_likes(elsewhere))
            more, names, largest = zip(*compared)
            return sum(more, faults), " ".join(n for n in names if n), max(largest)
        name, (twin, factor) = twins.choose(scene, draw)
        more, largest = twins.compare_twin(name, twin, factor, scene, first, draw, self.run)
        return faults + more, name, largest


def row(scene, first, figures, verdict, twin):
    info = scene.info
    words = [f"{scene.kind:6s} {scene.seed:<6d} {info['speed']:7.4g} m/s {info.get('angle', 90.):3.0f} deg {info.get('place', '')[:7]:7s}"]
    element = f"h/dx {info['element'] / info['spacing']:.2g} " if "element" in info else ""
    words.append(f"t/dx {info['thickness'] / info['spacing']:.2g} {element}{info['law'][:5]} {scene.settings['Bird/Formulation'][:4]} "
                 f"{scene.settings['Bird/Shape'][:4]} | {info['formulation'][:9]} {' '.join(info.get('metals', []))}")
    words.append(" ".join(f"{name} {value:.2g}" for name, value in figures.items()))
    if first.summary:
        words.append(f"steps {first['steps/bird']}/{first['steps/blade']} twin {twin}")
    return " | ".join(words) + " | " + verdict


def judge_scene(program, kind, seed, limit, keep):
    """The row of a scene that is drawn, or where `seed` is the path of a file thawed; its verdict ('passed', 'FAILED', 'stopped' or
    'refused') and figures."""
    scene = Scene.thaw(seed) if isinstance(seed, str) else draw_scene(kind, seed)
    folder = tempfile.mkdtemp()
    runs = Runs(program, folder, limit)
    first, figures, twin = runs.first(scene), {}, ""
    if first.code == 0:
        figures, faults = judge(scene, first)
        if scene.blade and not scene.info["can_fail"]:
            figures["crossed"] = crossings.count(os.path.join(folder, "scene.run"), scene.blade, scene.info["spacing"])
            if figures["crossed"] > 0:
                faults.append(f"{figures['crossed']} particles have gone through the blade")
        more, name, largest = runs.compare(scene, first)
        figures[name.split("+")[0]], twin = largest, f"{name} {largest:.1g}"
        faults += more
        verdict = "FAILED" if faults else "passed"
    else:
        faults = [f"exit {first.code}: {first.stop()}"]
        verdict = {2: "refused", 3: "stopped"}[first.code] if strike.has_words(first) else "FAILED"
    if keep and verdict != "passed":
        kept = os.path.join(keep, f"{scene.kind}-{scene.seed}")
        shutil.copytree(folder, kept, dirs_exist_ok=True)
        scene.freeze(os.path.join(kept, "scene.json"))
    shutil.rmtree(folder)
    return row(scene, first, figures, verdict + (": " + "; ".join(faults) if faults else ""), twin), verdict, figures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; the next ones count on")
    parser.add_argument("--count", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--frozen", nargs="*", help="scenes once found wrong (scene.json of --keep), instead of drawn ones")
    parser.add_argument("--only", choices=KINDS, nargs="+", help="kinds of scenes that take turns, instead of all")
    parser.add_argument("--keep", help="folder for the files of scenes that fail, stop or are refused")
    parser.add_argument("--limit", type=float, default=300., help="seconds a run may take")
    options = parser.parse_args()
    program, verdicts, worst = os.path.abspath(options.program), [], {}
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        known = known_to_fail()
        seeds = options.frozen or range(options.seed, options.seed + options.count)
        jobs = [(program, kind_of(seed, options.only), seed, options.limit, options.keep) for seed in seeds]
        for (_, kind, seed, *_), (text, verdict, figures) in zip(jobs, pool.map(judge_scene, *zip(*jobs))):
            print(text, flush=True)
            verdicts.append("open" if verdict == "FAILED" and f"{kind} {seed}" in known else verdict)
            for name, value in figures.items():
                if value > worst.get(name, (-1.,))[0]:
                    worst[name] = (value, kind, seed)
    print(f"{len(verdicts)} scenes: " + ", ".join(f"{verdicts.count(v)} {v}" for v in ("passed", "FAILED", "open", "stopped", "refused")))
    print("worst: " + ", ".join(f"{name} {value:.2g} ({kind} {seed})" for name, (value, kind, seed) in worst.items()))
    return 1 if "FAILED" in verdicts else 0


if __name__ == "__main__":
    sys.exit(main())
