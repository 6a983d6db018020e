#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""bag_to_map draws what the node draws from the same messages, byte for byte, and says what it did."""
import math
import subprocess

import rosbag
import yaml

from portolan_testing import bags, case, messages
from portolan_testing.grid import files_of, png_size, read_pgm
from portolan_testing.node import executable
from portolan_testing.room import RESOLUTION

LOOKS = 60
GRID = {"resolution": RESOLUTION, "tf_wait": 30.0, "laser": {"no_return": "clear", "max_range": 5.0}}


class GridLiveEqualsOffline(case.NodeCase):
    def bag_to_map(self, *arguments, out="maps"):
        """The finished process; its output lies in the folder `out`."""
        return subprocess.run([executable("bag_to_map"), "--out", str(self.folder / out)] + [str(a) for a in arguments],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)

    def config(self, name="config.yaml", **options):
        path = self.folder / name
        path.write_text(yaml.safe_dump({"occupancy_grid": options}))
        return path

    def offline(self, bag, out="maps", **options):
        done = self.bag_to_map("--mappers", "occupancy_grid", "--config", self.config(**options), bag, out=out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {path.name: path.read_bytes() for path in (self.folder / out).iterdir()}

    def live(self, bag, **options):
        """What the node saves once it has used or dropped all that the bag holds."""
        node = self.node(self.new_namespace(), parameters=options)
        subprocess.run(bags.play_command(bag, node.namespace, rate=3), stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, check=True)
        node.wait_for("scans", received=LOOKS, waiting=0)
        node.wait_for("echoes", received=LOOKS * len(bags.SONARS), waiting=0)
        return self.saved(node)

    def assert_equal_maps(self, bag, **options):
        offline = self.offline(bag, **options)
        live = self.live(bag, **options)
        self.assertEqual(set(live), {f"map{layer}.{suffix}" for layer in ("", "_laser", "_sonar")
                                     for suffix in ("pgm", "yaml")})
        for name, content in live.items():
            self.assertEqual(offline[name], content, name)

    def test_the_same_bytes_when_thinned_and_drawn_otherwise(self):
        self.assert_equal_maps(
            bags.write_room_bag(self.folder / "room.bag", LOOKS), resolution=0.05, tf_wait=30.0, fusion="sum",
            file_mode="scale", thinning={"min_travel": 0.05, "min_turn": 0.1}, laser={"beam_model": "ray"})

    def test_files(self):
        files = self.offline(bags.write_room_bag(self.folder / "room.bag", LOOKS), "new/folder", **GRID)
        sheets = ("map", "map_laser", "map_sonar")
        self.assertEqual(set(files), {f"{sheet}.{suffix}" for sheet in sheets for suffix in ("yaml", "pgm", "png")}
                         | {"trajectory.tum", "summary.yaml", "report.md"})
        for sheet in sheets:
            self.assertIn(f"![{sheet}.png]({sheet}.png)", files["report.md"].decode())
        for sheet in sheets:
            head = yaml.safe_load(files[sheet + ".yaml"])
            self.assertEqual(head["image"], sheet + ".pgm")
            self.assertAlmostEqual(head["resolution"], RESOLUTION)
            self.assertEqual((head["negate"], head["occupied_thresh"], head["free_thresh"]), (0, 0.65, 0.196))
            pixels = read_pgm(self.folder / "new/folder" / head["image"])
            self.assertTrue(set(pixels.flatten().tolist()) <= {0, 205, 254})
            column = math.floor((2.05 - head["origin"][0]) / RESOLUTION)
            row = pixels.shape[0] - 1 - math.floor((0.05 - head["origin"][1]) / RESOLUTION)
            if sheet == "map_laser":
                self.assertEqual((pixels[row, column], pixels[row, column - 1]), (0, 254), "the wall")
            width, height = png_size(files[sheet + ".png"])
            self.assertGreaterEqual(width, pixels.shape[1])
            self.assertGreaterEqual(height, pixels.shape[0])

    def test_trajectory(self):
        files = self.offline(bags.write_room_bag(self.folder / "room.bag", LOOKS), **GRID)
        rows = [[float(word) for word in line.split()] for line in files["trajectory.tum"].decode().splitlines()]
        self.assertEqual(len(rows), len(bags.tf_stamps(LOOKS)))
        for stamp, row in zip(bags.tf_stamps(LOOKS), rows):
            x, y, yaw = bags.way(stamp)
            expected = [stamp, x, y, 0.0, 0.0, 0.0, math.sin(yaw / 2.0), math.cos(yaw / 2.0)]
            self.assertLess(max(abs(a - b) for a, b in zip(row, expected)), 1e-6)

    def test_summary(self):
        files = self.offline(bags.write_room_bag(self.folder / "room.bag", LOOKS), **GRID)
        summary = yaml.safe_load(files["summary.yaml"])
        self.assertRegex(summary["portolan"], r"\d+\.\d+\.\d+")
        self.assertEqual(summary["bags"], ["room.bag"])
        grid = summary["mappers"]["occupancy_grid"]
        self.assertEqual((grid["inputs"]["scans"]["messages"], grid["inputs"]["scans"]["used"]), (LOOKS, LOOKS))
        echoes = grid["inputs"]["echoes"]
        self.assertEqual(echoes["messages"], LOOKS * len(bags.SONARS))
        self.assertEqual(echoes["messages"], echoes["used"] + sum(echoes.get("dropped", {}).values()))
        self.assertGreaterEqual(grid["wall_time"], 0.0)
        self.assertAlmostEqual(grid["options"]["resolution"], RESOLUTION)
        self.assertEqual(grid["options"]["laser"]["no_return"], "clear")

    def test_start_and_duration(self):
        bag = bags.write_room_bag(self.folder / "room.bag", LOOKS)
        done = self.bag_to_map("--start", 2.0, "--duration", 1.0, bag)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = yaml.safe_load((self.folder / "maps/summary.yaml").read_text())
        self.assertEqual(summary["mappers"]["occupancy_grid"]["inputs"]["scans"]["messages"], 10)

    def test_several_bags_are_one_recording(self):
        whole = bags.write_room_bag(self.folder / "room.bag", LOOKS)
        with rosbag.Bag(str(whole)) as source, rosbag.Bag(str(self.folder / "a.bag"), "w") as a, \
                rosbag.Bag(str(self.folder / "b.bag"), "w") as b:
            for topic, message, stamp in source:
                (a if stamp < messages.time(bags.BEGIN + 3.03) else b).write(topic, message, stamp)
        at_once = self.offline(whole, **GRID)
        done = self.bag_to_map("--config", self.folder / "config.yaml", self.folder / "a.bag",
                               self.folder / "b.bag", out="parts")
        self.assertEqual(done.returncode, 0, done.stderr)
        parts = files_of(self.folder / "parts")
        self.assertEqual(parts, {name: at_once[name] for name in parts})

    def test_a_robot_that_calls_its_topics_and_frames_otherwise(self):
        ours = bags.write_room_bag(self.folder / "room.bag", LOOKS)
        theirs = self.folder / "theirs.bag"
        with rosbag.Bag(str(ours)) as source, rosbag.Bag(str(theirs), "w") as target:
            for topic, message, stamp in source:
                for transform in getattr(message, "transforms", []):
                    transform.header.frame_id = f"robot/{transform.header.frame_id}"
                    transform.child_frame_id = f"robot/{transform.child_frame_id}"
                if hasattr(message, "header"):
                    message.header.frame_id = f"robot/{message.header.frame_id}"
                target.write(topic if "tf" in topic else f"/robot{topic}", message, stamp)
        self.assert_refused(self.bag_to_map(theirs), "scan:=/robot/scan", "sonar:=/robot/sonar")
        self.assert_refused(self.bag_to_map("odm_frame:=robot/odom", theirs), "odm_frame")
        done = self.bag_to_map("scan:=/robot/scan", "sonar:=/robot/sonar", "odom_frame:=robot/odom",
                               "base_frame:=robot/base_link", "--config", self.config(**GRID), "--mappers",
                               "occupancy_grid", theirs, out="theirs")
        self.assertEqual(done.returncode, 0, done.stderr)
        at_home = self.offline(ours, **GRID)
        for name in ("map.pgm", "map_laser.pgm", "map_sonar.pgm", "trajectory.tum"):
            self.assertEqual((self.folder / "theirs" / name).read_bytes(), at_home[name], name)

    def assert_refused(self, done, *words):
        """It ended badly, in its own words and not by a signal, and left no map."""
        self.assertGreater(done.returncode, 0, done.stderr)
        self.assert_in_words(words, done.stderr)
        self.assertFalse((self.folder / "maps/map.pgm").exists())

    def test_bad_bags(self):
        self.assert_refused(self.bag_to_map(self.folder / "missing.bag"), "missing.bag")
        (self.folder / "text.bag").write_text("this is no bag\n" * 1000)
        self.assert_refused(self.bag_to_map(self.folder / "text.bag"), "text.bag")
        (self.folder / "empty.bag").write_bytes(b"")
        self.assert_refused(self.bag_to_map(self.folder / "empty.bag"), "empty.bag")
        whole = bags.write_room_bag(self.folder / "room.bag", LOOKS)
        (self.folder / "torn.bag").write_bytes(whole.read_bytes()[:-5000])
        self.assert_refused(self.bag_to_map(self.folder / "torn.bag"), "torn.bag")
        self.assert_refused(self.bag_to_map(), "bag")
        with rosbag.Bag(str(self.folder / "silent.bag"), "w"):
            pass
        self.assert_refused(self.bag_to_map(self.folder / "silent.bag"), "no messages")

    def test_bad_wishes(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=3)
        self.assert_refused(self.bag_to_map("--mappers", "occupancy_gird", bag), "occupancy_gird")
        self.assert_refused(self.bag_to_map("--no-such-flag", bag), "no-such-flag")
        self.assert_refused(self.bag_to_map("--start", "soon", bag), "start")
        self.assert_refused(self.bag_to_map("--start", "1e6", bag), "the bags last")
        self.assert_refused(self.bag_to_map("--config", self.folder / "missing.yaml", bag), "missing.yaml")
        (self.folder / "torn.yaml").write_text("occupancy_grid: {resolution: [")
        self.assert_refused(self.bag_to_map("--config", self.folder / "torn.yaml", bag), "torn.yaml")
        (self.folder / "other.yaml").write_text("ocupancy_grid: {resolution: 0.1}")
        self.assert_refused(self.bag_to_map("--config", self.folder / "other.yaml", bag), "ocupancy_grid")

    def test_all_bad_options_are_named_at_once(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=3)
        config = self.config(resolution=-1.0, resolutoin=0.1, laser={"p_ocupied": 0.7, "p_free": 2.0}, fusion="mix")
        self.assert_refused(self.bag_to_map("--config", config, bag), "resolution", "resolutoin", "laser/p_ocupied",
                            "laser/p_free", "fusion")

    def test_an_empty_map_is_a_failure_with_its_reason(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=3, with_tf=False)
        self.assert_refused(self.bag_to_map(bag), "0 of 3 scans used", "odom")
        bag = bags.write_room_bag(self.folder / "mountless.bag", looks=3, with_mounts=False)
        self.assert_refused(self.bag_to_map(bag), "0 of 3 scans used", "laser")

    def test_an_empty_map_takes_no_other_with_it(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=3)
        config = self.folder / "lost.yaml"
        config.write_text(yaml.safe_dump({"octomap": {"odom_frame": "nowhere"}}))
        done = self.bag_to_map("--mappers", "octomap,occupancy_grid", "--config", config, bag)
        self.assertGreater(done.returncode, 0)
        self.assert_in_words(["the map of octomap is empty", "nowhere"], done.stderr)
        self.assertTrue((self.folder / "maps/map.pgm").exists())
        self.assertFalse((self.folder / "maps/octomap.ot").exists())

    def test_an_output_folder_that_cannot_be(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=3)
        (self.folder / "file").write_text("")
        done = self.bag_to_map(bag, out="file/maps")
        self.assertGreater(done.returncode, 0)
        self.assert_in_words(["file/maps"], done.stderr)


if __name__ == "__main__":
    case.run("grid_live_equals_offline", GridLiveEqualsOffline)
