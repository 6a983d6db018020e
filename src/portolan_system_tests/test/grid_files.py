#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Saving, loading and resetting: whole files or none, only where they may lie, and rubbish harms no map."""

import rospy

from portolan_testing import case, messages
from portolan_testing.grid import files_of, read_pgm
from portolan_testing.room import Room, upright
from portolan_testing.waiting import eventually

STAMPS = [1000.0 + 0.1 * i for i in range(4)]
NAMES = {f"map{layer}.{suffix}" for layer in ("", "_laser", "_sonar") for suffix in ("pgm", "yaml")}
GOOD_YAML = """image: map.pgm
resolution: 0.1
origin: [-1.0, -1.0, 0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""


def good_pgm(width=20, height=20):
    return b"P5\n%d %d\n255\n" % (width, height) + bytes([254] * (width * height))


def without(key):
    return "".join(line + "\n" for line in GOOD_YAML.splitlines() if not line.startswith(key))


def with_value(key, value):
    return without(key) + f"{key}: {value}\n"


# name: (map.yaml, map.pgm), None where there is no such file
RUBBISH = {
    "no picture": (GOOD_YAML, None),
    "no description": (None, good_pgm()),
    "cut short": (GOOD_YAML, good_pgm()[:-1]),
    "bytes too many": (GOOD_YAML, good_pgm() + b"and more"),
    "empty picture": (GOOD_YAML, b""),
    "only a magic": (GOOD_YAML, b"P5\n"),
    "wrong magic": (GOOD_YAML, good_pgm().replace(b"P5", b"P6")),
    "text": (GOOD_YAML, b"no picture at all, but words"),
    "16 bits": (GOOD_YAML, b"P5\n20 20\n65535\n" + bytes(800)),
    "huge": (GOOD_YAML, b"P5\n4000000000 4000000000\n255\n\0"),
    "overflowing": (GOOD_YAML, b"P5\n18446744073709551617 18446744073709551617\n255\n\0"),
    "no size": (GOOD_YAML, b"P5\n0 0\n255\n"),
    "negative": (GOOD_YAML, b"P5\n-20 -20\n255\n" + bytes(400)),
    "empty description": ("", good_pgm()),
    "no YAML": ("[}", good_pgm()),
    "a list": ("- image\n- resolution\n", good_pgm()),
    "bytes": ("\0\1\2\3", good_pgm()),
    "no image": (without("image"), good_pgm()),
    "no resolution": (without("resolution"), good_pgm()),
    "no origin": (without("origin"), good_pgm()),
    "resolution is no number": (with_value("resolution", "fine"), good_pgm()),
    "resolution NaN": (with_value("resolution", ".nan"), good_pgm()),
    "resolution inf": (with_value("resolution", ".inf"), good_pgm()),
    "resolution 0": (with_value("resolution", "0"), good_pgm()),
    "resolution negative": (with_value("resolution", "-0.1"), good_pgm()),
    "another resolution": (with_value("resolution", "0.05"), good_pgm()),
    "origin NaN": (with_value("origin", "[.nan, 0, 0]"), good_pgm()),
    "origin far away": (with_value("origin", "[1e30, 0, 0]"), good_pgm()),
    "origin too short": (with_value("origin", "[0]"), good_pgm()),
    "origin turned": (with_value("origin", "[0, 0, 0.5]"), good_pgm()),
    "image elsewhere": (with_value("image", "../map.pgm"), good_pgm()),
    "image absolute": (with_value("image", "/etc/passwd"), good_pgm()),
    "image is a list": (with_value("image", "[map.pgm]"), good_pgm()),
    "a long name": (with_value("image", "x" * 5000), good_pgm()),
}


class GridFiles(case.NodeCase):
    def mapped(self, room=Room(), namespace=None, **more):
        robot, node = self.pair(namespace, **more)
        robot.look_around(room, STAMPS)
        node.wait_for("scans", used=robot.sent["scan"])
        node.wait_for("echoes", used=robot.sent["sonar"])
        return robot, node

    def folder_of(self, node):
        return self.folder / node.namespace[1:]

    def assert_refused(self, answer, *words):
        self.assertFalse(answer.success, answer.message)
        self.assertGreater(len(answer.message), 10)
        self.assert_in_words(words, answer.message)

    def test_save_and_load_and_save_gives_the_same_bytes(self):
        for mode in ("trinary", "scale"):
            _, node = self.mapped(namespace=self.new_namespace(), parameters={"file_mode": mode})
            first, known = self.saved(node), node.map().known()
            self.assertEqual(set(first), NAMES)
            self.assertTrue(node.call("reset").success)
            self.assertEqual(node.map().known(), set())
            answer = node.call("load")
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(self.saved(node), first, mode)
            loaded = {(column, row): percent for column, row, percent in node.map().known()}
            for column, row, percent in known:
                if percent >= 66 or percent <= 19:
                    self.assertEqual(loaded[column, row] > 50, percent > 50)

    def test_layers_of_an_older_map_do_not_come_back(self):
        robot, node = self.mapped()
        self.saved(node)
        self.assertTrue(node.call("reset").success)
        robot.stand(1010.0, (0.0, 0.0, 0.0))
        robot.send("scan", messages.scan(1010.0, "laser", Room().scan((0.0, 0.0, 0.0))))
        node.wait_for("scans", used=robot.sent["scan"])
        laser_alone = self.saved(node)
        self.assertTrue(node.call("load").success)
        laser, sonar = self.listener("map/laser"), self.listener("map/sonar")
        eventually(laser.known, "the laser's layer is there")
        self.assertEqual(sonar.known(), set())
        self.assertEqual(self.saved(node), laser_alone)

    def test_a_loaded_map_is_mapped_on(self):
        robot, node = self.mapped()
        self.saved(node)
        self.assertTrue(node.call("reset").success)
        self.assertTrue(node.call("load").success)
        panel = Room(panels=[upright(1.05, -0.3, 0.3)])
        robot.look_around(panel, [1010.0 + 0.1 * i for i in range(10)])
        node.wait_for("scans", used=robot.sent["scan"])
        self.assertGreater(node.map().at(1.05, 0.05), 65)
        self.assertGreater(node.map().at(-2.05, 0.05), 65)

    def test_files_are_what_map_server_reads(self):
        _, node = self.mapped()
        self.saved(node)
        self.assertEqual(set(read_pgm(self.folder_of(node) / "map.pgm").flatten().tolist()), {0, 205, 254})

    def test_a_missing_folder_is_made(self):
        folder = self.folder / "a/b/c"
        _, node = self.mapped(parameters={"map_directory": str(folder)})
        self.assertTrue(node.call("save").success)
        self.assertEqual({path.name for path in folder.iterdir()}, NAMES)

    def test_folders_that_cannot_be(self):
        (self.folder / "file").write_text("in the way")
        for folder in (str(self.folder / "file"), str(self.folder / "file/maps"), "/proc/maps", "/proc"):
            _, node = self.mapped(namespace=self.new_namespace(), parameters={"map_directory": folder})
            known = node.map().known()
            self.assert_refused(node.call("save"), folder)
            self.assert_refused(node.call("load"))
            self.assertEqual(node.map().known(), known)
            node.close()

    def test_refused_names(self):
        _, node = self.mapped()
        before = self.saved(node)
        for name in ("../x", "a/b", "", ".hidden", "..", ".", "/tmp/x", "a..b/../c", "a\nb", 7, ["map"]):
            rospy.set_param(node.name + "/map_name", name)
            self.assert_refused(node.call("save"), "name")
            self.assert_refused(node.call("load"), "name")
        self.assertEqual(files_of(self.folder_of(node), ""), before)
        self.assertEqual([path.name for path in self.folder.iterdir()], [node.namespace[1:]])
        rospy.set_param(node.name + "/map_name", "second floor")
        self.assertTrue(node.call("save").success)
        self.assertTrue((self.folder_of(node) / "second floor.pgm").exists())

    def test_rubbish_keeps_the_map_and_is_called_so(self):
        robot, node = self.mapped()
        folder, known = self.folder_of(node), node.map().known()
        folder.mkdir()
        for name, (description, picture) in RUBBISH.items():
            with self.subTest(name):
                for path, content in ((folder / "map.yaml", description), (folder / "map.pgm", picture)):
                    path.unlink() if path.exists() else None
                    if content is not None:
                        path.write_bytes(content if isinstance(content, bytes) else content.encode())
                answer = node.call("load")
                self.assert_refused(answer, str(folder) if name == "a long name" else "map.")
                self.assertLess(len(answer.message), 10_000)
                self.assertEqual(node.map().known(), known)
        robot.look_around(Room(), [1010.0 + 0.1 * i for i in range(4)])
        node.wait_for("scans", used=robot.sent["scan"])
        (folder / "map.yaml").write_text(GOOD_YAML)
        (folder / "map.pgm").write_bytes(good_pgm())
        answer = node.call("load")
        self.assertTrue(answer.success, answer.message)


if __name__ == "__main__":
    case.run("grid_files", GridFiles)
