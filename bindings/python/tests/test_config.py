# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import collections
import copy
import pickle
import types
import unittest

import numpy as np
from support import needs_program, program, scratch

import surefoot
from surefoot import Config, ConfigError


class ConfigTest(unittest.TestCase):
    def test_values_have_their_types(self):
        config = Config()
        self.assertIsInstance(config["knots.points"], int)
        self.assertIsInstance(config["preprocess.max_range"], float)  # its default is "100"
        self.assertIsInstance(config["knots.second_attempt"], bool)
        self.assertEqual(config["level.mode"], "ground")

    def test_what_is_set_is_there(self):
        config = Config("surefoot", {"knots.points": 1500})
        config["knots.map_voxel"] = np.float64(0.25)
        config["knots.second_attempt"] = False
        config["level.mode"] = "none"
        config.update({"knots.segments": np.float32(6), "preprocess.max_range": 50})
        values = dict(config)
        self.assertEqual(values["knots.points"], 1500)
        self.assertEqual(values["knots.map_voxel"], 0.25)
        self.assertIs(values["knots.second_attempt"], False)
        self.assertEqual(values["level.mode"], "none")
        self.assertEqual(values["knots.segments"], 6)
        self.assertIsInstance(values["preprocess.max_range"], float)
        self.assertIn("'knots.points': '1500'", repr(config))

    def test_any_mapping_is_taken(self):
        values = {"knots.points": 1500, "level.mode": "none"}
        expected = Config("surefoot", values)
        for mapping in (types.MappingProxyType(values), collections.ChainMap(values), expected):
            self.assertEqual(Config("surefoot", mapping), expected)
            config = Config()
            config.update(mapping)
            self.assertEqual(config, expected)
        with self.assertRaises((TypeError, ValueError)):
            Config("surefoot", 5)

    def test_every_value_goes_back(self):
        for method in surefoot.methods():
            config = Config(method)
            self.assertEqual(Config(method, dict(config)), config)
            self.assertEqual(set(config), set(config.keys()))
            self.assertEqual(len(config), len(list(config)))

    def test_errors_are_those_of_the_library(self):
        config = Config()
        with self.assertRaisesRegex(ConfigError, "knots.points: got '-1', expected 1"):
            config["knots.points"] = -1
        with self.assertRaisesRegex(ConfigError, "there is no parameter 'knots.colour'"):
            config["knots.colour"] = 1
        with self.assertRaisesRegex(ConfigError, "got 'nan', expected"):
            config["knots.map_voxel"] = float("nan")
        with self.assertRaisesRegex(ConfigError, "got '2.5', expected"):
            config["knots.segments"] = 2.5
        with self.assertRaisesRegex(ConfigError, "does not read it"):
            config["kiss_icp.voxel_size"] = 1.0
        with self.assertRaises(ConfigError):
            Config("fast")
        self.assertTrue(issubclass(ConfigError, ValueError))

    def test_no_number_is_too_large_to_be_refused(self):
        config = Config()
        for value in (float("inf"), 1e300, -1e300, float("nan"), 2.5):
            with self.assertRaises(ConfigError):
                config["knots.points"] = value

    def test_contradictions_are_refused(self):
        config = Config()
        config["preprocess.min_range"] = 90.0
        config["preprocess.max_range"] = 80.0
        for call in (config.validate, lambda: surefoot.Odometry(config)):
            with self.assertRaisesRegex(ConfigError, "must be less than preprocess.max_range"):
                call()

    def test_copies_are_independent(self):
        config = Config("kiss-icp", {"kiss_icp.voxel_size": 0.5})
        copies = [copy.copy(config), copy.deepcopy(config), pickle.loads(pickle.dumps(config))]
        config["kiss_icp.voxel_size"] = 2.0
        for one in copies:
            self.assertEqual(one["kiss_icp.voxel_size"], 0.5)
            self.assertEqual(one.method, "kiss-icp")
            self.assertNotEqual(one, config)

    def test_a_name_of_another_method_is_not_in(self):
        self.assertIn("knots.points", Config())
        self.assertNotIn("kiss_icp.voxel_size", Config())
        self.assertNotIn("no.such", Config())

    @needs_program
    def test_a_printed_config_is_loaded(self):
        file = scratch("config.yaml")
        file.write_text(program("config", "--yaml", "--method", "icp"))
        self.assertEqual(Config.load(file), Config("icp"))
        with self.assertRaisesRegex(ConfigError, "no.yaml"):
            Config.load("no.yaml")

    def test_the_table_tells_units(self):
        rows = {row.name: row for row in surefoot.parameters()}
        self.assertEqual(rows["preprocess.max_range"].unit, "m")
        self.assertEqual(rows["preprocess.max_range"].default_value, "100")
        self.assertTrue(all(row.help and row.source for row in rows.values()))


if __name__ == "__main__":
    unittest.main()
