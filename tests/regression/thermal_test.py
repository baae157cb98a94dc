"""repose thermal and repose compare from outside: decks of input/ in, JSON, tables and pictures out; mistakes are one line.

Usage: thermal_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import glob
import json
import os
import re
import subprocess
import sys
import tomllib
import unittest

from repose_runs import FolderTest, Program

BEFORE = "discharged_mass_g,angle_of_repose_deg,area_1\n21.90,32.0,640\n21.91,32.5,660\n21.89,31.6,655\n"
AFTER = "discharged_mass_g,angle_of_repose_deg,area_1\n21.91,32.2,650\n21.90,31.9,645\n21.90,32.3,660\n"


class Thermal(FolderTest):
    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def run_tool(self, *arguments, ranks=0):
        """What was printed, and the result; its picture is drawn, too."""
        tool = arguments[0] if arguments[0] == "compare" else arguments[1]
        done = self.program.call(*arguments, "--output", self.path(tool), ranks=ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        result = self.path(f"{tool}/{tool}.json")
        plot = os.path.join(self.program.source, "tools", "plot_thermal.py")
        drawn = subprocess.run(["/usr/bin/python3", plot, result], capture_output=True, text=True)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        with open(drawn.stdout.strip(), "rb") as picture:
            self.assertEqual(picture.read(8), b"\x89PNG\r\n\x1a\n")
        self.assertEqual(glob.glob(self.path(tool) + "/*partial*"), [])
        with open(result) as file:
            return done.stdout, json.load(file)

    def fails(self, code, message, *arguments, ranks=0):
        """The message is to be found as it stands."""
        super().fails(code, re.escape(message), *arguments, ranks=ranks)

    def test_tools_with_a_deck(self):
        for tool, name in (("bed", "bed_carbohsp"), ("bed", "bed_sand"), ("sensor", "sensor"), ("mixture", "mixture")):
            text, result = self.run_tool("thermal", tool, self.program.deck(f"thermal_{name}.toml"))
            self.assertIn("|", text)
            self.assertEqual(result["tool"], tool)
            self.assertIn("commit", result["build"])

    def test_keys_has_every_key_of_the_decks(self):
        for tool, name in (("compare", "compare"), ("thermal bed", "bed_carbohsp"), ("thermal mixture", "mixture"),
                           ("thermal network", "network"), ("thermal sensor", "sensor"), ("thermal synthesise", "tps_mica"),
                           ("thermal tps", "tps_grains")):
            done = self.program.call("keys", *tool.split())
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"repose {tool}", done.stdout)
            with open(self.program.deck(f"thermal_{name}.toml"), "rb") as file:
                self.has_keys(done.stdout, tomllib.load(file), "")
        self.fails(2, "there are no keys of \"thermal bad\"; did you mean thermal bed?", "keys", "thermal", "bad")
        self.assertEqual(self.program.call("keys", "photo", "pile").stdout, self.program.call("keys", "photo").stdout)
        self.fails(2, "there are no keys of \"thermal\"; did you mean thermal", "keys", "thermal")

    def has_keys(self, text, section, name):
        for key, value in section.items():
            if isinstance(value, dict):
                self.assertIn(f"\n[{name}{key}]", text)
                self.has_keys(text, value, f"{name}{key}.")
            elif isinstance(value, list) and isinstance(value[0], dict):
                self.assertIn(f"\n[[{name}{key}]]", text)
                for one in value:
                    self.has_keys(text, one, f"{name}{key}.")
            else:
                self.assertIn(f"\n  {key} ", text)

    def test_on_two_ranks_the_same(self):
        deck = self.program.deck("thermal_bed_sand.toml")
        self.assertEqual(self.run_tool("thermal", "bed", deck), self.run_tool("thermal", "bed", deck, ranks=2))

    def test_a_made_up_transient_is_evaluated(self):
        for name, conductivity in (("steel", 13.55), ("grains", 0.21)):
            deck = self.program.deck(f"thermal_tps_{name}.toml")
            self.run_tool("thermal", "synthesise", deck)
            text, result = self.run_tool("thermal", "tps", self.path("synthesise/transient.csv"), "--deck", deck)
            transient = result["transients"][0]
            self.assertAlmostEqual(transient["conductivity_W_mK"]["value"] / conductivity, 1.0, delta=0.02)
            self.assertTrue(transient["all_criteria_met"], text)
            self.assertFalse(result["repeats"]["is_met"])  # one file is no repeat
            self.assertIn("BROKEN repeats", text)

    def test_mica_is_read_as_the_bed(self):
        deck = self.program.deck("thermal_tps_mica.toml")
        text, made = self.run_tool("thermal", "synthesise", deck)
        self.assertLess(made["contact_rise_K"], -0.3)  # the layers carry away more than they hold back
        self.assertIn("the contact adds -0.", text)
        _, result = self.run_tool("thermal", "tps", self.path("synthesise/transient.csv"), "--deck", deck)
        transient = result["transients"][0]
        self.assertAlmostEqual(transient["conductivity_W_mK"]["value"] / 0.21, 1.33, delta=0.03)
        self.assertFalse(transient["all_criteria_met"])

    def test_repeats_are_compared(self):
        before, after = self.write("before.csv", BEFORE), self.write("after.csv", AFTER)
        text, result = self.run_tool("compare", before, after, "--deck", self.program.deck("thermal_compare.toml"))
        self.assertEqual([figure["verdict"] for figure in result["figures"]], ["equivalent"] * 3)
        self.assertIn("below the limit", text)

    def test_simulated_beds_conduct(self):
        """Two packings of the program: the denser conducts more, at every temperature, and heat is not lost."""
        files = []
        for name, friction in (("loose", 0.827), ("dense", 0.01)):
            self.program.run(self.program.deck("packing.toml"), self.path(name),
                             f"pair.carbohsp-carbohsp.sliding_friction={friction}")
            files.append(sorted(glob.glob(self.path(name) + "/run_*.hdf"))[-1])
        _, result = self.run_tool("thermal", "network", *files, "--deck", self.program.deck("thermal_network.toml"),
                                  "--set", "temperature.count=3")
        loose, dense = result["beds"]
        self.assertGreater(loose["porosity"], dense["porosity"] + 0.03)
        for a, b in zip(loose["conductivity"], dense["conductivity"]):
            self.assertGreater(b["conductivity_W_mK"], 1.1 * a["conductivity_W_mK"])
            for row in (a, b):
                self.assertLess(abs(row["heat_imbalance"]), 1e-8)
                self.assertGreater(row["conductivity_W_mK"], 3.0 * 0.026)
                self.assertLess(abs(row["difference_percent"]), 40.0)  # the model knows neither sizes nor contacts
        for bed in (loose, dense):
            k = [row["conductivity_W_mK"] for row in bed["conductivity"]]
            self.assertEqual(k, sorted(k))

    def test_mistakes_are_one_line(self):
        bed = self.program.deck("thermal_bed_sand.toml")
        tps = self.program.deck("thermal_tps_steel.toml")
        output = ("--output", self.path("made"))
        self.fails(2, "--output is required", "thermal", "synthesise", tps)
        unsorted = self.write("unsorted.csv", "time,temperature\n1,1\n3,2\n2,3\n")
        few = self.write("few.csv", "time,temperature\n1,1\n2,1.5\n")
        self.fails(2, "gives the porosity -0.03", "thermal", "bed", bed, "--set", "bulk_density=2600")
        self.fails(2, "gives the porosity -0.03", "thermal", "bed", bed, "--set", "bulk_density=2600", ranks=2)
        self.fails(2, "conductivity.0.conductivity_W_mK would be", "thermal", "bed", bed, "--set", "bulk_density=1e-300")
        self.fails(2, "sample_rise_K would be inf", "thermal", "synthesise", tps, *output, "--set", "evaluation.power=1e308")
        self.fails(2, "unsorted.csv:4: time = 2 does not come after 3", "thermal", "tps", unsorted, "--deck", tps)
        self.fails(2, "few.csv: 2 points after time 0", "thermal", "tps", few, "--deck", tps)
        mica = self.program.deck("thermal_tps_mica.toml")
        self.fails(2, '"thickness" = -1e-06 is out of range', "thermal", "synthesise", mica, *output, "--set",
                   "synthetic.layer.0.thickness=-1 um")
        self.fails(2, '"conductivity" = 0 is out of range', "thermal", "synthesise", mica, *output, "--set",
                   "synthetic.layer.0.conductivity=0")
        self.fails(2, "contact_rise_K would be", "thermal", "synthesise", mica, *output, "--set",
                   "synthetic.layer.0.conductivity=1e-300")
        self.fails(2, 'unknown key "bulk_densty"', "thermal", "bed", bed, "--set", "bulk_densty=2600")
        self.fails(2, "see repose thermal --help", "thermal")
        self.fails(2, 'there is no command "oven"', "thermal", "oven", bed)
        self.fails(2, "see repose compare --help", "compare", few, "--deck", bed)
        self.fails(4, "absent.csv: cannot open", "thermal", "tps", self.path("absent.csv"), "--deck", tps)
        self.fails(4, "absent.toml: cannot open", "thermal", "bed", self.path("absent.toml"))
        self.fails(4, "few.csv", "thermal", "bed", bed, "--output", few)
        self.assertFalse(os.path.exists(self.path("bed")))

    def test_a_plot_of_something_else_is_refused(self):
        plot = os.path.join(self.program.source, "tools", "plot_thermal.py")
        for text, why in (("{}", 'is no result of a thermal tool: it has no "tool" of bed, network, .*'),
                          ("[]", "is no result of a thermal tool: .*"), ("[", ".*"),
                          ('{"tool": "oven", "title": ""}', "is no result of a thermal tool: .*"),
                          ('{"tool": "bed", "title": ""}', "is no result of a thermal tool, or damaged: .*")):
            done = subprocess.run(["/usr/bin/python3", plot, self.write("other.json", text)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, rf"^plot_thermal.py: .*other.json: {why}\n$")
            self.assertNotRegex(done.stderr, "Traceback|Error")
        done = subprocess.run(["/usr/bin/python3", plot, self.path("absent.json")], capture_output=True, text=True)
        self.assertRegex(done.stderr, "^plot_thermal.py: .*absent.json.*\n$")


if __name__ == "__main__":
    Thermal.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
