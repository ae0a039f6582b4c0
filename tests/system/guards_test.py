"""Runs that are lost end with exit code 3 and say what, when, where and from which checkpoint to go on; nothing that they leave
holds what is no number.

guards_test.py PROGRAM SOURCE_FOLDER"""

import base64
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

import jsonschema

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SCHEMA = json.loads((TOP / "tests" / "data" / "failure.schema.json").read_text())

STRIKE = ["Bird/Particle spacing=7 mm", "Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=4"]
PLATE = ["Bird/Enabled=false", "Time/End time=3e-4", "Blade/Mesh/Length=0.1", "Blade/Mesh/Chord=0.02", "Blade/Mesh/Elements along span=20",
         "Blade/Mesh/Elements along chord=4", "Blade/Thickness/Value=0.005", "Blade/Material/Name=Al 6061-T6"]
UNGUARDED = ["Time/Energy error limit=1e9", "Time/Smallest step=0"]  # so that another guard comes first
CRUSH = "Blade/Loads/Initial velocity={}*x/0.1; 0; 0"

# What trips it, what it says, of which quantity, and what it names. Corners of bricks resist: only nodes that cross most of a brick within
# a step turn one inside out.
GUARDS = {
    "energy": ([*STRIKE, "Time/Energy error limit=1e-9"], "The energy balance", "energy error", ("particle", "node")),
    "step collapse": ([*PLATE, CRUSH.format(-1600), UNGUARDED[0]], "The stable step of the blade has collapsed",
                      "stable step over its first value", ("element",)),
    "runaway node": ([*PLATE, *UNGUARDED, "Blade/Mesh/Elements along span=50", "Blade/Mesh/Elements along chord=10",
                      "Blade/Loads/Pressure=if(x>0.098 && y>0.008, 1e11, 0)"], "A node has run away", "speed", ("node",)),
    "inverted brick": ([*PLATE, *UNGUARDED, CRUSH.format(-200000), "Blade/Kind=solid", "Blade/Element/Formulation=B-bar",
                        "Blade/Mesh/Layers=2"], "A brick is turned inside out", "volume by its worst point", ("element",)),
    "stuck particle": ([*STRIKE, "Contact/Stiffness scale=1e-6", "Contact/Damping scale=0"],
                       "A particle is stuck in the blade, or has come through it", "penetration over particle spacing", ("particle",)),
}


def numbers_of(array):
    """Of a DataArray of a VTU file: header of four 32-bit numbers, one zlib stream, each in base64."""
    text = array.text.strip()
    body = zlib.decompress(base64.b64decode(text[24:])) if len(text) > 24 else b""
    return struct.unpack(f"<{len(body) // 4}f", body)


class Guards(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def program(self, *words, expect):
        done = subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, expect, f"{words}\n{done.stdout[-500:]}")
        return done.stdout

    def lose(self, entries, *more):
        entries = [*entries, *more, "Output/Field interval=2e-6", "Output/History interval=1e-6"]
        sets = [word for entry in entries for word in ("--set", entry)]
        (self.folder / "defaults.prm").touch()
        prm = TOP / "prm" / "quickstart.prm" if entries[0] == STRIKE[0] else "defaults.prm"
        text = self.program("run", prm, "--output", "run", "--force", *sets, expect=3)
        return text, self.record()

    def record(self):
        record = json.loads((self.folder / "run" / "failure.json").read_text())
        jsonschema.validate(record, SCHEMA, cls=jsonschema.Draft202012Validator)
        return record

    def test_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_each_names_what_when_and_where(self):
        for name, (entries, what, quantity, kinds) in GUARDS.items():
            with self.subTest(name):
                text, record = self.lose(entries)
                self.assertTrue(record["what"].startswith(what), record["what"])
                self.assertEqual(record["quantity"], quantity)
                self.assertGreater(record["time"], 0.)
                self.assertGreater(record["step"], 0)
                self.assertIn(record["entity"]["kind"], kinds)
                self.assertTrue(all(math.isfinite(x) for x in record["entity"]["position"]))
                self.assertNotEqual(record["value"], record["limit"])
                message = record["message"]
                self.assertIn(message, text)
                self.assertLessEqual(message.count("\n"), 5, "six lines")
                for part in (what, f"step {record['step']}", f"{record['entity']['kind']} {record['entity']['id']} at ("):
                    self.assertIn(part, message)
                self.assertFalse((self.folder / "run" / "summary.json").exists())
                self.assertTrue((self.folder / "run" / ".birdstrike").read_text().startswith("failed: " + what))
                self.assert_results_are_numbers()

    def assert_results_are_numbers(self):
        run, n = self.folder / "run", 0
        for series in run.glob("*.pvd"):
            for entry in xml.etree.ElementTree.parse(series).iter("DataSet"):
                for array in xml.etree.ElementTree.parse(run / entry.get("file")).iter("DataArray"):
                    if array.get("type") == "Float32":
                        values = numbers_of(array)
                        n += len(values)
                        self.assertTrue(all(map(math.isfinite, values)), f"{entry.get('file')}: {array.get('Name')}")
        self.assertGreater(n, 0, "no field was written")
        rows = [line for line in (run / "history.csv").read_text().splitlines() if not line.startswith("#")][1:]
        self.assertTrue(rows)
        self.assertTrue(all(math.isfinite(float(value)) for row in rows for value in row.split(",")))

    def test_without_a_checkpoint_it_says_what_writes_them(self):
        text, record = self.lose(GUARDS["stuck particle"][0])
        self.assertIsNone(record["checkpoint"])
        self.assertIn("No checkpoint was written (Output/Checkpoint/Time interval writes them).", text)

    def test_names_the_newest_checkpoint_from_which_a_run_goes_on(self):
        text, record = self.lose(GUARDS["stuck particle"][0], "Output/Checkpoint/Step interval=10")
        newest = max((self.folder / "run" / "checkpoints").glob("*.h5"))
        self.assertEqual(self.folder / record["checkpoint"], newest)
        self.assertLessEqual(int(newest.stem.split("_")[1]), record["step"])
        self.assertIn("birdstrike resume run", text)
        # smaller steps change nothing here: the same guard, a little sooner or later; and the checkpoint is named again
        self.program("resume", "run", "--set", "Time/Step scale=0.45", "--set", "Time/Bird step scale=0.5", expect=3)
        again = self.record()
        self.assertEqual(again["quantity"], record["quantity"])
        self.assertAlmostEqual(again["time"] / record["time"], 1., delta=0.2)
        self.assertIsNotNone(again["checkpoint"])

    def test_a_run_that_is_lost_before_its_first_step(self):
        # 5000 for 5000 rpm; no instant is known, for the clock has not begun
        text, record = self.lose([*STRIKE, "Blade/Spin/Speed=5000"])
        self.assertEqual((record["quantity"], record["value"], record["unit"]), ("Blade/Spin/Speed", 5000., "rad/s"))
        self.assertIsNone(record["time"])
        self.assertIn("'5000 rpm' would be 523.6 rad/s", text)
        self.assertTrue((self.folder / "run" / "parameters.prm").exists())

    def test_a_run_that_goes_on_to_its_end_is_no_longer_lost(self):
        entries = [*STRIKE, "Time/End time=1e-4"]
        self.lose(entries, "Time/Energy error limit=1e-3", "Output/Checkpoint/Step interval=1")
        self.program("resume", "run", "--set", "Time/Energy error limit=0.05", expect=0)
        self.assertFalse((self.folder / "run" / "failure.json").exists())
        self.assertTrue((self.folder / "run" / "summary.json").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
