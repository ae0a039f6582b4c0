"""summary.json obeys its schema, whatever the case is made of: summary_schema_test.py PROGRAM SOURCE_FOLDER"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SCHEMA = json.loads((TOP / "tests" / "data" / "summary.schema.json").read_text())

# Shipped cases that leave out or add parts, to a time at which all of them have reported.
CASES = {
    "quickstart": {},
    "bird-free": {},
    "blade-impulse": {},
    "rigid-plate": {"Bird/Particle spacing": "0.004"},
    "sheath": {"Bird/Particle spacing": "0.004"},
    "perforation": {"Bird/Particle spacing": "0.004"},
    "fan-blade-composite": {"Bird/Particle spacing": "0.008"},
}


class Schema(unittest.TestCase):
    def run_case(self, name, entries):
        with tempfile.TemporaryDirectory() as folder:
            overrides = [a for entry, value in {**entries, "Time/End time": "1e-4"}.items() for a in ("--set", f"{entry}={value}")]
            subprocess.run([PROGRAM, "run", TOP / "prm" / f"{name}.prm", "--output", f"{folder}/run", *overrides], check=True,
                           stdout=subprocess.DEVNULL)
            return json.loads((pathlib.Path(folder) / "run" / "summary.json").read_text())

    def test_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_summaries_obey(self):
        for name, entries in CASES.items():
            with self.subTest(name):
                jsonschema.validate(self.run_case(name, entries), SCHEMA, cls=jsonschema.Draft202012Validator)

    def test_units_are_of_numbers_that_are_there(self):
        summary = self.run_case("quickstart", {})
        for path in summary["units"]:
            value = summary
            for key in path.split("/"):
                value = value[key]
            self.assertNotIsInstance(value, (str, dict), path)

    def test_every_energy_has_its_unit(self):
        summary = self.run_case("quickstart", {})
        for part in ("parts", "error_origins"):
            for name in summary["energy"][part]:
                self.assertEqual(summary["units"].get(f"energy/{part}/{name}"), "J", name)

    def test_warnings_have_their_codes(self):
        codes = [warning["code"] for warning in self.run_case("quickstart", {})["warnings"]]
        self.assertIn("peak/not_reached", codes)
        self.assertIn("contact/unfinished", codes)

    def test_what_the_schema_does_not_know_fails(self):
        summary = self.run_case("quickstart", {})
        summary["tip"]["height"] = 1.0
        with self.assertRaises(jsonschema.ValidationError):
            jsonschema.validate(summary, SCHEMA, cls=jsonschema.Draft202012Validator)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
