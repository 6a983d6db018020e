#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What sensors, tf and clocks get wrong: each fault is counted and named, and the node maps on."""
import math

from sensor_msgs.msg import PointField

from portolan_testing import case, messages
from portolan_testing.room import Room
from portolan_testing.waiting import eventually

HERE = (0.0, 0.0, 0.0)
ROOM = Room()
RANGES = ROOM.scan(HERE)
NOUNS = {"scan": "scans", "sonar": "echoes", "cloud_in": "clouds"}
NOW = 100.0


def changed(message, **fields):
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def scan(stamp=NOW, frame="laser", ranges=None, **fields):
    return changed(messages.scan(stamp, frame, RANGES if ranges is None else ranges), **fields)


def echo(stamp=NOW, frame="sonar_0", **fields):
    return changed(messages.echo(stamp, frame, 2.05), **fields)


def cloud(stamp=NOW, frame="camera", points=((1.05, 0.05, 0.5),), **fields):
    return changed(messages.cloud(stamp, frame, points), **fields)


def fields_of(kind, offsets=(0, 4, 8), names="xyz"):
    return [PointField(name, offset, kind, 1) for name, offset in zip(names, offsets)]


MALFORMED_SCANS = [
    dict(ranges=[]), dict(angle_increment=0.0), dict(angle_increment=math.nan), dict(angle_increment=math.inf),
    dict(angle_min=math.nan), dict(angle_min=-math.inf), dict(range_min=math.nan), dict(range_max=math.nan),
    dict(range_min=-1.0), dict(range_min=5.0, range_max=1.0), dict(range_max=-math.inf),
    dict(time_increment=-0.001), dict(time_increment=math.nan), dict(time_increment=1e30)]
MALFORMED_ECHOES = [
    dict(field_of_view=0.0), dict(field_of_view=-0.5), dict(field_of_view=7.0), dict(field_of_view=math.nan),
    dict(min_range=-1.0), dict(min_range=5.0, max_range=1.0), dict(max_range=-math.inf), dict(max_range=math.nan)]
MOST = 2**32 - 1
MALFORMED_CLOUDS = [
    dict(fields=[]), dict(fields=fields_of(PointField.INT8)), dict(fields=fields_of(PointField.FLOAT64)),
    dict(fields=fields_of(PointField.FLOAT32, names="xy")), dict(fields=fields_of(PointField.FLOAT32, (0, 4, MOST))),
    dict(fields=fields_of(PointField.FLOAT32, (0, 4, 9))), dict(data=b""), dict(data=b"12345678901"),
    dict(width=2), dict(width=MOST), dict(height=MOST), dict(height=2), dict(row_step=MOST, height=3),
    dict(point_step=0), dict(point_step=MOST), dict(row_step=0)]
ODD_SCANS = [  # well-formed, whatever their values
    [math.nan] * 360, [math.inf] * 360, [-math.inf] * 360, [0.0] * 360, [-1.0] * 360, [1e30] * 360, [-1e30] * 360,
    [1e-45] * 360, [math.nan], [2.05], [math.nan, math.inf, -math.inf, 0.0, 1e38, -0.0] * 600]


class GridFaults(case.NodeCase):
    def faulty_pair(self, **parameters):
        """A pair whose clock stands at NOW until the test moves it."""
        robot, node = self.pair(parameters={"tf_wait": 1.0, **parameters})
        robot.tick(NOW)
        return robot, node

    def assert_maps_on(self, robot, node, stamp=NOW + 20.0):
        """All that was sent is accounted for, and a good look around shows the room."""
        before = {topic: node.wait_for(noun, received=robot.sent.get(topic, 0), waiting=0)
                  for topic, noun in NOUNS.items()}
        robot.tick(stamp)
        # What comes before the node hears of that time has waited for twenty seconds as soon as it does.
        eventually(lambda: node.clock() == stamp, lambda: f"the node's clock is at {stamp}, not {node.clock()}")
        sent = dict(robot.sent)
        robot.look_around(ROOM, [stamp + 0.01 * i for i in range(12)])
        for topic, noun in NOUNS.items():
            good = robot.sent.get(topic, 0) - sent.get(topic, 0)
            node.wait_for(noun, received=robot.sent.get(topic, 0), used=before[topic].used + good, waiting=0)
        grid = node.map()
        self.assertGreater(grid.at(2.05, 0.05), 65, "the wall")
        self.assertTrue(0 <= grid.at(0.5, 0.05) < 35, "the floor")

    def send_all(self, robot, topic, faults, make):
        """One message for each fault, each at a stamp of its own that tf knows."""
        robot.stand(NOW - 1.0, HERE)
        robot.stand(NOW + 1.0, HERE)
        for i, fault in enumerate(faults):
            robot.send(topic, make(stamp=NOW + 0.01 * i, **fault))

    def test_malformed_scans(self):
        robot, node = self.faulty_pair()
        self.send_all(robot, "scan", MALFORMED_SCANS, scan)
        node.wait_for("scans", malformed=len(MALFORMED_SCANS), used=0)
        self.assertEqual(node.map().known(), set())
        self.assert_in_words([f"0 of {len(MALFORMED_SCANS)} scans used", "malformed"], node.sentence())
        self.assert_maps_on(robot, node)

    def test_malformed_echoes(self):
        robot, node = self.faulty_pair()
        self.send_all(robot, "sonar", MALFORMED_ECHOES, echo)
        node.wait_for("echoes", malformed=len(MALFORMED_ECHOES), used=0)
        self.assert_maps_on(robot, node)

    def test_malformed_clouds(self):
        robot, node = self.faulty_pair()
        self.send_all(robot, "cloud_in", MALFORMED_CLOUDS, cloud)
        node.wait_for("clouds", malformed=len(MALFORMED_CLOUDS), used=0)
        self.assert_maps_on(robot, node)

    def test_clouds_of_nothing(self):
        robot, node = self.faulty_pair()
        nothing = [dict(points=()), dict(points=((math.nan, math.nan, math.nan),)), dict(points=((1e30, -1e30, 0.5),)),
                   dict(points=((math.inf, 0.0, 0.5), (0.0, -math.inf, 0.5))), dict(points=((0.0, 0.0, 0.5),)),
                   dict(points=(), width=0, height=MOST, row_step=0)]
        self.send_all(robot, "cloud_in", nothing, cloud)
        node.wait_for("clouds", received=len(nothing), waiting=0)
        self.assert_maps_on(robot, node)

    def test_ranges_that_are_no_distances(self):
        robot, node = self.faulty_pair()
        self.send_all(robot, "scan", [dict(ranges=ranges) for ranges in ODD_SCANS], scan)
        self.send_all(robot, "sonar", [dict(range=value) for value in (math.nan, math.inf, -math.inf, 0.0, -1.0, 1e30)],
                      echo)
        self.assert_maps_on(robot, node)

    def test_stamps(self):
        robot, node = self.faulty_pair()
        for stamp in (NOW - 2.0, NOW + 2.0):
            robot.stand(stamp, HERE)
        stamps = [0.0, NOW, NOW, NOW + 1.0, NOW - 1.0, NOW - 1.5, NOW - 1.0]
        for stamp in stamps:
            robot.send("scan", scan(stamp))
        tally = node.wait_for("scans", received=len(stamps), no_stamp=1, repeated_stamp=2, used=4)
        self.assert_in_words(["4 of 7 scans used", "without a stamp"], tally.sentence)
        self.assert_maps_on(robot, node)

    def test_a_frame_that_tf_does_not_know(self):
        robot, node = self.faulty_pair()
        robot.stand(NOW, HERE)
        robot.send("scan", scan(frame="lazer"))
        robot.send("sonar", echo(frame=""))
        node.wait_for("scans", received=1)
        robot.tick(NOW + 1.5)
        node.wait_for("scans", no_transform=1)
        node.wait_for("echoes", no_transform=1)
        self.assert_in_words(["0 of 1 scans used: no transform odom <- lazer"], node.tally("scans").sentence)
        self.assert_in_words(["0 of 1 echoes used", "frame"], node.tally("echoes").sentence)
        self.assertNotEqual(node.level(), 0)
        self.assert_maps_on(robot, node)

    def test_later_tf_is_not(self):
        robot, node = self.faulty_pair()
        robot.stand(NOW - 1.8, HERE)
        robot.stand(NOW - 0.8, HERE)
        robot.send("sonar", echo(NOW - 0.8))
        node.wait_for("echoes", used=1)  # the transforms have come
        for i in range(3):
            robot.send("scan", scan(NOW - 0.02 + 0.01 * i))
        node.wait_for("scans", waiting=3)
        robot.tick(NOW + 1.2)
        node.wait_for("scans", no_transform=3, waiting=0)
        self.assertEqual(node.tally("scans").sentence, "0 of 3 scans used: no transform odom <- laser at their stamps; "
                         "newest is 0.8 s older")
        robot.stand(NOW + 1.0, HERE)
        self.assert_maps_on(robot, node)

    def test_too_many_wait(self):
        robot, node = self.faulty_pair(queue_size=10)
        robot.stand(NOW - 1.0, HERE)
        for i in range(25):
            robot.send("scan", scan(NOW + 0.01 * i))
        eventually(lambda: node.tally("scans").dropped.get("queue_full", 0) > 0, "the oldest are crowded out")
        robot.stand(NOW + 1.0, HERE)
        tally = eventually(lambda: node.tally("scans").waiting == 0 and node.tally("scans"), "the others are used")
        self.assertTrue(0 < tally.used <= 10, tally)
        for i in range(1, 5):  # one after the other: a queue of ROS is as short as that of the node
            robot.stand(NOW + 20.0 + 0.1 * i, HERE)
            robot.send("scan", scan(NOW + 20.0 + 0.1 * i))
            eventually(lambda i=i: node.tally("scans").used == tally.used + i, "it is used")
        self.assertGreater(node.map().at(2.05, 0.05), 65, "the wall")

    def test_poses_beyond_the_map(self):
        robot, node = self.faulty_pair()
        wild = [(2000.0, 0.0, 0.0), (0.0, -1e6, 0.0), (9e7, 9e7, 0.0)]
        for i, pose in enumerate(wild):
            robot.stand(NOW + 0.01 * i, pose)
            robot.send("scan", scan(NOW + 0.01 * i))
        node.wait_for("scans", rejected=len(wild), used=0)
        self.assertEqual(node.map().known(), set())
        self.assert_maps_on(robot, node)

    def test_malformed_transforms(self):
        robot, node = self.faulty_pair()
        bad = []
        for field, value in (("x", math.nan), ("y", math.inf)):
            bad.append(messages.transform(NOW, "odom", "base_link", HERE))
            setattr(bad[-1].transform.translation, field, value)
        for w in (0.0, 0.5, 2.0, math.nan, math.inf):
            bad.append(messages.transform(NOW, "odom", "base_link", HERE))
            bad[-1].transform.rotation.w = w
        bad.append(messages.transform(0.0, "odom", "base_link", HERE))
        bad.append(messages.transform(NOW, "", "base_link", HERE))
        bad.append(messages.transform(NOW, "odom", "", HERE))
        robot.send("tf", messages.transforms(*bad))
        eventually(lambda: node.values().get("transforms refused") == str(len(bad)), "all are refused")
        self.assert_maps_on(robot, node)

    def test_a_quaternion_that_is_a_little_too_long(self):
        robot, node = self.faulty_pair()
        long = messages.transform(NOW, "odom", "base_link", HERE)
        long.transform.rotation.w = 1.004
        robot.send("tf", messages.transforms(long))
        robot.send("scan", scan())
        node.wait_for("scans", used=1)
        self.assertGreater(node.map().at(2.05, 0.05), 50, "ranges are not stretched")
        self.assert_maps_on(robot, node)

    def test_a_lone_wild_stamp_of_tf(self):
        robot, node = self.faulty_pair()
        robot.stand(NOW - 1.0, HERE)
        for stamp in (1.0, 4000.0, 3e9):
            robot.stand(stamp, (5.0, 5.0, 0.0))
            robot.stand(NOW, HERE)
        robot.send("scan", scan(NOW - 0.5))
        node.wait_for("scans", used=1)
        self.assertEqual(node.values()["times the clock ran back"], "0")
        self.assert_maps_on(robot, node, stamp=NOW + 5.0)


if __name__ == "__main__":
    case.run("grid_faults", GridFaults)
