"""The command line from outside: exit codes, messages, files, and the same bits however it is run.

Usage: cli_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import json
import math
import os
import pathlib
import re
import sys
import unittest

from repose_runs import FolderTest, Program, read_series

SMALL = ("particles.0.mass=0.05 g", "particles.0.height=20 mm", "phase.settle.max_time=0.03", "phase.settle.min_time=0.01",
         "phase.discharge.max_time=0.08", "phase.discharge.min_time=0.01")


class CommandLine(FolderTest):
    def setUp(self):
        super().setUp()
        self.quick = self.program.deck("discharge_quick.toml")

    def test_version_names_the_build(self):
        done = self.program.call("--version")
        self.assertEqual(done.returncode, 0)
        for word in ("repose", "commit", "MPI", "HDF5", "vector"):
            self.assertIn(word.lower(), done.stdout.lower())

    def test_keys_lists_every_section(self):
        done = self.program.call("keys")
        self.assertEqual(done.returncode, 0)
        for key in ("youngs_modulus", "restitution", "max_overlap", "orifice_height", "azimuths", "remove_walls"):
            self.assertIn(key, done.stdout)

    def test_keys_of_a_sensitivity_study_are_those_it_takes(self):
        top, parameter = self.program.call("keys", "sensitivity").stdout.split("[[parameter]]")
        self.assertRegex(top, r"\n +figures ")
        for key in ("figures", "points", "values", "prior"):
            self.assertNotRegex(parameter, rf"\n +{key} ")
        text = pathlib.Path(self.program.deck("sensitivity_carbohsp.toml")).read_text()
        for key in ("points = 3", "values = [0.1, 0.2]", 'prior = "uniform"'):
            path = pathlib.Path(self.path("study.toml"))
            path.write_text(text.replace("[[parameter]]\n", f"[[parameter]]\n{key}\n", 1))
            self.fails(2, rf'study.toml:\d+:1: "{key.split()[0]}" of \[\[parameter\]\] is only allowed with a calibration', "check",
                       str(path))

    def test_a_wrong_key_of_a_study_is_told_with_its_line(self):
        text = pathlib.Path(self.program.deck("calibrate_quick.toml")).read_text().replace("discharge_quick.toml", self.quick)
        line = text[:text.index('key = "pair.0.rolling_friction"')].count("\n") + 1
        path = self.path("study.toml")
        pathlib.Path(path).write_text(text.replace("pair.0.rolling_friction", "pair.0.rolling_frictoin"))
        self.fails(2, rf'study.toml:{line}: pair.0.rolling_frictoin=0.05: unknown key "rolling_frictoin"', "check", path)

    def test_keys_of_a_command_that_has_none(self):
        for command in ("info", "check", "fields"):
            self.fails(2, rf'no keys of "{command}", but of calibrate, compare, photo, photo pile, photo plate, run, .*thermal bed, .*validate$', "keys", command)

    def test_check_names_the_tool_of_a_file(self):
        for name, command in (("thermal_bed_sand", "thermal bed"), ("thermal_mixture", "thermal mixture"),
                              ("thermal_network", "thermal network"), ("thermal_sensor", "thermal sensor"),
                              ("thermal_tps_mica", "thermal tps"), ("thermal_compare", "compare"), ("photo_pile", "photo")):
            self.fails(2, rf"{name}.toml: no deck of a run, but a file for repose {command}$", "check", self.program.deck(name + ".toml"))

    def test_check_expects_little_of_a_phase_without_mechanics(self):
        done = self.program.call("check", self.program.deck("packed_bed_charging.toml"))
        self.assertRegex(done.stdout, r"wall time +about [1-9] s on 1 rank")  # 80000 steps of 500 grains and 400 of heat

    def test_more_grains_than_are_taken(self):
        self.fails(2, r"e\+\d+ particles are too many; fewer than 1e\+09 are taken", "check", self.quick, "--set",
                   "particles.0.mass=1e6")

    def test_check_resolves_without_running(self):
        done = self.program.call("check", self.program.deck("carbohsp_mono.toml"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("156044", done.stdout)
        self.assertIn("criterion", done.stdout)

    def test_check_tells_what_a_study_takes(self):
        says = self.program.call("check", self.program.deck("calibrate_carbohsp_levels.toml")).stdout
        self.assertRegex(says, r"less: 28 at 14 points, each 46\d{3} particles, at most \d+ steps")
        self.assertRegex(says, r"part: 5 at 5 points, each 46813 particles, at most \d+ steps")
        self.assertRegex(says, r"full: 6 at 6 points, each 156044 particles, at most 1373952 steps, 8 ranks or more")
        self.assertRegex(says, r"core-hours +about \d+ at 8e\+06")
        self.assertIn("then 2 points at a time until the region is narrow, at most 40 core-hours in all", says)
        says = self.program.call("check", self.program.deck("calibrate_quick.toml"), ranks=2).stdout
        self.assertRegex(says, r"runs +18 at 9 points, each 2497 particles, at most \d+ steps")
        self.assertIn("on 2 ranks", says)
        says = self.program.call("check", self.program.deck("sensitivity_carbohsp.toml")).stdout
        self.assertRegex(says, r"runs +144 at 48 points, each 156044 particles, at most 2060927 steps")
        says = self.program.call("check", self.program.deck("validation.toml")).stdout
        self.assertRegex(says, r"carbohsp_mono: 156044 particles, at most 2060927 steps")
        self.assertRegex(says, r"sand_multi: 71270 particles")
        self.fails(2, "no_such_key", "check", self.program.deck("calibrate_quick.toml"), "--set", "pair.0.no_such_key=1")
        self.fails(2, "calibrate_quick.toml: .*repose calibrate", "run", self.program.deck("calibrate_quick.toml"),
                   "--output", self.path("out"))
        self.assertFalse(os.path.exists(self.path("out")))

    def test_wrong_command_line_is_2(self):
        self.fails(2, "output", "run", self.quick)
        self.fails(2, "frobnicate", "frobnicate")
        self.fails(2, r'"--quiet" belongs behind the command: repose run --quiet \.\.\.; see repose run --help', "--quiet", "run", self.quick)
        self.fails(4, r'--output "": names no folder', "run", self.quick, "--output", "")

    def test_wrong_deck_is_2_and_leaves_nothing(self):
        output = self.path("out")
        self.fails(2, "--set phase.settel.max_time", "run", self.quick, "--output", output, "--set",
                   "phase.settel.max_time=1")
        with open(self.path("bad.toml"), "w") as file:
            file.write(pathlib.Path(self.quick).read_text().replace("density = 3592.0", "densty = 3592.0"))
        self.fails(2, r"bad\.toml:\d+:\d+: .*densty.*density", "run", self.path("bad.toml"), "--output", output)
        self.assertFalse(os.path.exists(output))

    def test_too_long_time_step_is_2_and_names_the_limit(self):
        self.fails(2, "Rayleigh time", "check", self.quick, "--set", "time.step=1e-5")

    def test_missing_files_are_4(self):
        self.fails(4, "no_such.toml", "run", self.path("no_such.toml"), "--output", self.path("out"))
        self.fails(4, "summary|file|directory", "run", self.quick, "--output", self.quick)

    def test_results_of_another_kind_are_not_mixed(self):
        os.mkdir(self.path("study"))
        pathlib.Path(self.path("study"), "calibration.toml").write_text("")
        self.fails(2, "holds the results of a calibration; name another directory", "run", self.quick, "--output", self.path("study"))
        self.assertEqual(os.listdir(self.path("study")), ["calibration.toml"])

    def test_measurements_lie_in_the_domain(self):
        for key in ("angle_of_repose.plate_height", "discharge.orifice_height"):
            self.fails(2, r"lies outside the \[domain\], from -0\.\d+ to 0\.\d+", "check", self.quick, "--set", f"measurement.{key}=5")

    def test_a_phase_that_does_not_begin_is_said(self):
        done = self.program.call("run", self.quick, "--output", self.path("out"), "--set", "phase.settle.min_time=0", "--set",
                                 "phase.settle.kinetic_energy=1", "--set",
                                 "phase.discharge.max_time=1 ms", "--set", "phase.discharge.min_time=0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("phase settle ended before its first step", done.stdout + done.stderr)
        self.assertIn("no pile, so no angle of repose", done.stdout)

    def test_a_later_phase_that_does_not_begin_is_said(self):
        done = self.program.call("run", self.quick, "--output", self.path("out"), *self.settings(
            "phase.settle.max_time=1 ms", "phase.settle.min_time=0", "phase.discharge.min_time=0", "phase.discharge.kinetic_energy=1",
            "run.check_every=1"))
        self.assertIn("phase discharge ended before its first step", done.stdout + done.stderr)
        done = self.program.call("run", self.quick, "--output", self.path("out"), *self.settings(
            "phase.settle.max_time=1 ms", "phase.settle.min_time=0", "phase.discharge.max_time=1e-12", "phase.discharge.min_time=0"))
        self.assertIn("its time is less than half a time step", done.stdout + done.stderr)

    def test_grains_that_are_not_there_are_said(self):
        grains = "0,0,0.01,0,0,0,0,0,0,2e-4,carbohsp\n0.0145,0,0.03,0.9,0,0.5,0,0,0,2e-4,carbohsp\n"
        deck = self.scene(grains, [])
        done = self.program.call("run", deck, "--output", self.path("out"), *self.settings(
            "phase.settle.max_time=10 ms", "phase.settle.min_time=0", "phase.settle.kinetic_energy=1e-30",
            "phase.discharge.max_time=1 ms", "phase.discharge.min_time=0"))
        self.assertIn("1 of 2 particles have left the domain: x_max 1", done.stdout)
        pour = '[[particles]]\ntype = "pour"\nmaterial = "carbohsp"\ndiameter = "0.4 mm"\ncount = 9\nregion = "disc"\n' \
               'centre = [0.0, 0.0, "30 mm"]\nradius = "3 mm"\nvelocity = [0.0, 0.0, -0.5]\nparticle_rate = 300.0\n' \
               'interval = "10 ms"\n\n[[phase]]'
        path = pathlib.Path(deck)
        path.write_text(path.read_text().replace("[[phase]]", pour, 1))
        done = self.program.call("run", deck, "--output", self.path("out"), *self.settings(
            "phase.settle.max_time=15 ms", "phase.settle.min_time=0", "phase.discharge.max_time=1 ms", "phase.discharge.min_time=0"))
        self.assertIn("6 of the 11 planned particles were not poured before the run ended", done.stdout + done.stderr)
        done = self.program.call("check", deck, "--set", "particles.1.start_time=99")
        self.assertRegex(done.stdout, r"pour .* from 99.01 s on; none before the run ends, after \d+")

    def test_a_lid_that_goes_through_the_floor_is_3(self):
        self.fails(3, r'wall "lid" has gone down by 0\.004\d* m and through the floor', "run",
                   self.program.deck("uniaxial_compression.toml"), "--output", self.path("out"), "--set", "particles.0.count=20",
                   "--set", "measurement.compression.height=4 mm")

    def test_check_knows_what_will_end_a_run(self):
        deck = self.scene("0,0,0.01,0,0,-40,0,0,0,2e-4,carbohsp\n", [])
        self.fails(2, r"particle 0 at \(0, 0, 0.01\) moves at 40 m/s, .*time.step", "check", deck, "--set", "time.expected_speed=1")
        deck = self.program.deck("all_keys.toml")
        self.assertEqual(self.program.call("check", deck).returncode, 0)

    @staticmethod
    def settings(*overrides):
        return [word for override in overrides for word in ("--set", override)]

    def scene(self, grains, changes):
        """A deck beside a list of grains: the quick deck with its fill replaced."""
        text = pathlib.Path(self.quick).read_text()
        begin, end = text.index("[[particles]]"), text.index("[[phase]]")
        text = text[:begin] + '[[particles]]\ntype = "csv"\nfile = "grains.csv"\n\n' + text[end:]
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        pathlib.Path(self.path("deck.toml")).write_text(text)
        pathlib.Path(self.path("grains.csv")).write_text("x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n" + grains)
        return self.path("deck.toml")

    def test_only_regular_files_are_read(self):
        """A pipe or a device might never end: an error, not a wait."""
        deck = self.scene("0,0,0.01,0,0,0,0,0,0,2e-4,carbohsp\n", [])
        os.mkfifo(self.path("pipe"))
        for name, what in (("pipe", "a pipe"), (".", "a directory"), ("/dev/zero", "a device"), ("none", "No such file")):
            changed = pathlib.Path(deck).read_text().replace('"grains.csv"', f'"{name}"')
            pathlib.Path(self.path("special.toml")).write_text(changed)
            for ranks in (0, 2):
                self.fails(4, f"{what}", "check", self.path("special.toml"), ranks=ranks)
            self.fails(4, what, "run", self.path(name), "--output", self.path("out"))
        self.fails(4, "cannot read", "check", "/proc/self/mem")

    def test_nothing_in_a_deck_is_executed(self):
        sentinel = self.path("executed")
        deck = self.scene("0,0,0.01,0,0,0,0,0,0,2e-4,carbohsp\n", [])
        for name in (f"$(touch {sentinel})", f"`touch {sentinel}`", f"|touch {sentinel}", f"x; touch {sentinel}"):
            changed = pathlib.Path(deck).read_text().replace('"grains.csv"', f'"{name}"')
            pathlib.Path(self.path("shell.toml")).write_text(changed)
            self.fails(4, "cannot open", "check", self.path("shell.toml"))
            self.fails(4, "cannot open", "check", name)
        self.assertFalse(os.path.exists(sentinel))

    def test_a_run_does_not_overwrite_what_it_reads(self):
        grain = "0,0,0.01,0,0,0,0,0,0,2e-4,carbohsp\n"
        deck = self.scene(grain, [('"grains.csv"', '"walls.csv"')])
        os.rename(self.path("grains.csv"), self.path("walls.csv"))
        for ranks in (0, 2):
            self.fails(2, r"walls\.csv: the run would overwrite it", "run", deck, "--output", self.folder, ranks=ranks)
        self.assertTrue(pathlib.Path(self.path("walls.csv")).read_text().endswith(grain))
        self.assertFalse(os.path.exists(self.path("series.csv")))
        deck = self.scene(grain, [])
        self.program.run(deck, self.folder, "phase.settle.max_time=1 ms", "phase.settle.min_time=0", "phase.discharge.max_time=1 ms",
                         "phase.discharge.min_time=0")  # a list of another name stays as it is

    def test_check_refuses_what_run_refuses_at_its_beginning(self):
        heap = self.program.deck("lifted_cylinder.toml")
        bridges = ("--set", "contact.cohesion=capillary", "--set", "pair.0.bridge_volume=1e-6", "--set", "pair.0.surface_tension=0.07",
                   "--set", "pair.1.bridge_volume=0", "--set", "pair.1.surface_tension=0.07")
        for words in (("check", heap), ("run", heap, "--output", self.path("out"))):
            self.fails(2, "would hold together at .* of the radius", *words, *bridges)

    def test_a_watched_particle_without_a_pair_is_2(self):
        deck = pathlib.Path(self.program.deck("inclined_plane.toml")).read_text()
        glass = deck[deck.index("[[material]]"):]
        glass = glass[:glass.index("[[", 2)].replace(re.search(r'name = "(\w+)"', glass)[0], 'name = "glass"')
        path = self.path("plane.toml")
        pathlib.Path(path).write_text(deck.replace("[[pair]]", glass + "[[pair]]", 1).replace('against = "carbohsp"', 'against = "glass"'))
        self.fails(2, r'tilt_onset\.against = "glass": there is no \[\[pair\]\] of it and "metal"', "check", path)
        self.fails(2, r'tilt_onset\.particle = 5: it is "fixed" .* will never begin to move', "check",
                   self.program.deck("inclined_plane.toml"), "--set", "measurement.tilt_onset.particle=5")

    def test_listed_material_without_pair_is_2(self):
        deck = self.scene("0,0,0.01,0,0,0,0,0,0,2e-4,steel\n", [])
        self.fails(2, r'no \[\[pair\]\] for "steel" and "steel"', "check", deck)

    def test_leaving_beside_an_infinite_plane_is_counted(self):
        deck = self.scene("0.0145,0,-0.0097,0.5,0,0,0,0,0,3e-4,carbohsp\n",
                          [('type = "rectangle"', 'type = "plane"\npoint = [0.0, 0.0, -0.01]'),
                           ('corner = ["-15 mm", "-15 mm", "-10 mm"]\n', ""), ('edge_u = ["30 mm", 0.0, 0.0]\n', ""),
                           ('edge_v = [0.0, "30 mm", 0.0]\n', ""), ('"40 mm"]\n', '"40 mm"]\n')])
        s = self.program.run(deck, self.path("out"), "phase.settle.max_time=0.06")
        self.assertEqual([s["particles"][key] for key in ("inserted", "inside", "left")], [1, 0, 1])
        self.assertEqual(s["particles"]["exits"]["x_max"], 1)

    def test_named_exits_are_counted_with_their_mass(self):
        exit = '[[exit]]\nname = "spout"\nface = "x_max"\nmin = [0.0, "-1 mm", "-11 mm"]\nmax = [0.0, "1 mm", "40 mm"]\n\n'
        deck = self.scene("0.0145,0,0.02,0.5,0,0,0,0,0,3e-4,carbohsp\n0.0145,0.005,0.02,0.5,0,0,0,0,0,2e-4,carbohsp\n",
                          [("[output]", exit + "[output]")])
        s = self.program.run(deck, self.path("out"), "phase.settle.max_time=0.06")
        self.assertEqual(s["particles"]["exits"]["spout"], 1)
        self.assertEqual(s["particles"]["exits"]["x_max"], 1)
        self.assertEqual(s["particles"]["left"], 2)
        grain = 3592.0 * math.pi / 6.0 * 6e-4**3
        self.assertAlmostEqual(s["particles"]["exit_mass_kg"]["spout"] / grain, 1.0, places=9)
        self.assertAlmostEqual(s["particles"]["exit_mass_kg"]["x_max"] / grain, 8.0 / 27.0, places=9)
        rows = read_series(self.path("out"))
        self.assertEqual(rows[0]["exit_spout_kg"], 0.0)
        self.assertEqual(rows[-1]["exit_spout_kg"], s["particles"]["exit_mass_kg"]["spout"])

    def test_broken_physics_is_3_on_all_ranks(self):
        for ranks in (0, 2):
            self.fails(3, "step .*overlap.*max_overlap", "run", self.quick, "--output", self.path("out"), "--set",
                       "guards.max_overlap=0.01", ranks=ranks)
        self.assertFalse(os.path.exists(self.path("out/summary.json")))

    def test_same_bits_on_ranks_levels_and_without_fma(self):
        alone = self.program.run(self.quick, self.path("1"), *SMALL)
        self.assertEqual(alone["status"], "done")
        self.assertEqual(alone["particles"]["inserted"], alone["particles"]["inside"] + alone["particles"]["left"])
        self.assertGreater(alone["discharged_mass_kg"], 0.0)
        for ranks in (1, 3):
            self.assertEqual(self.program.run(self.quick, self.path("n"), *SMALL, ranks=ranks)["state_hash"],
                             alone["state_hash"])
            self.assertEqual(read_series(self.path("n")), read_series(self.path("1")))
        plain = self.program.run(self.quick, self.path("sse2"), *SMALL, options=("--vector-level", "sse2"))
        self.assertEqual(plain["state_hash"], alone["state_hash"])
        # glibc chooses its FMA and AVX2 variants when it loads; without them its bits differ, ours must not.
        tunables = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-FMA_Usable,-AVX2_Usable"
        without = self.program.run(self.quick, self.path("fma"), *SMALL, env={"GLIBC_TUNABLES": tunables})
        self.assertEqual(without["state_hash"], alone["state_hash"])
        other = self.program.run(self.quick, self.path("seed"), *SMALL, "run.seed=2")
        self.assertNotEqual(other["state_hash"], alone["state_hash"])

    def test_example_makes_a_pile_with_an_angle(self):
        output = self.path("quick")
        s = self.program.run(self.quick, output, ranks=2)
        self.assertEqual([p["name"] for p in s["phases"]], ["settle", "discharge"])
        self.assertFalse(s["plugged"])
        self.assertAlmostEqual(s["discharged_mass_kg"] + s["retained_mass_kg"], 0.4e-3, delta=2e-7)
        self.assertGreater(s["angle_of_repose_deg"], 15.0)
        self.assertLess(s["angle_of_repose_deg"], 40.0)
        mean = 0.5 * (s["angle_of_repose_left_deg"] + s["angle_of_repose_right_deg"])
        self.assertAlmostEqual(s["angle_of_repose_deg"], mean, places=9)
        for name in ("silhouette.png", "silhouette.pdf", "silhouette.svg", "run.hdf.series", "deck.resolved.toml"):
            self.assertTrue(os.path.getsize(os.path.join(output, name)) > 0, name)
        series = json.loads(pathlib.Path(output, "run.hdf.series").read_text())
        for file in series["files"]:
            self.assertTrue(os.path.exists(os.path.join(output, file["name"])))
        rows = read_series(output)
        discharged = [row["discharged_mass_kg"] for row in rows]
        self.assertAlmostEqual(discharged[-1], s["discharged_mass_kg"], delta=1e-12)
        self.assertFalse([f for f in os.listdir(output) if f.endswith(".partial")])

    def test_resolved_deck_runs_to_the_same_state(self):
        first = self.program.run(self.quick, self.path("a"), *SMALL)
        again = self.program.run(self.path("a/deck.resolved.toml"), self.path("b"))
        self.assertEqual(first["state_hash"], again["state_hash"])


if __name__ == "__main__":
    CommandLine.program = Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
