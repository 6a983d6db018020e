#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The grid node maps a room seen by laser and sonars, and publishes it as rviz and costmaps want it."""
import rospy
from nav_msgs.msg import MapMetaData, OccupancyGrid

from portolan_testing import case, messages
from portolan_testing.grid import Grid
from portolan_testing.room import LASER, RESOLUTION, SONAR, Room, upright
from portolan_testing.waiting import eventually

LOOKS = [1000.0 + 0.05 * i for i in range(16)]
OCCUPIED, FREE = 65, 20  # map_server's thresholds [%]


class GridMaps(case.NodeCase):
    def mapped(self, room=Room(), **more):
        """A robot that has looked around in the room, and the node that has mapped all of it."""
        robot, node = self.pair(**more)
        robot.look_around(room, LOOKS)
        node.wait_for("scans", used=robot.sent["scan"])
        node.wait_for("echoes", used=robot.sent["sonar"])
        return robot, node

    def test_walls_are_occupied_and_the_room_is_free(self):
        _, node = self.mapped()
        for topic in ("map", "map/laser", "map/sonar"):
            listener = self.listener(topic)
            eventually(lambda: listener.at(2.05, 0.05) > OCCUPIED, f"{topic} shows the wall")
            self.assertTrue(0 <= listener.at(0.5, 0.05) < FREE, topic)
            self.assertEqual(listener.at(2.45, 0.05), -1, topic)
        self.assertEqual(node.level(), 0, node.sentence())

    def test_messages_are_what_navigation_expects(self):
        self.mapped()
        listener = self.listener()
        metadata = []
        self.closing_subscriber("map_metadata", MapMetaData, metadata.append)
        eventually(lambda: listener.wholes and metadata, "map and metadata come")
        message = listener.wholes[-1]
        self.assertEqual(message.header.frame_id, "map")
        self.assertAlmostEqual(message.info.resolution, RESOLUTION, places=6)
        self.assertEqual(len(message.data), message.info.width * message.info.height)
        self.assertEqual(message.info.origin.orientation.w, 1.0)
        values = set(message.data)
        self.assertTrue(values <= set(range(-1, 101)))
        self.assertGreater(len(values - {-1, 0, 100}), 1, "real probabilities")
        for name in ("resolution", "width", "height", "origin"):
            self.assertEqual(getattr(metadata[-1], name), getattr(message.info, name), name)

    def closing_subscriber(self, topic, type_, callback):
        subscriber = rospy.Subscriber(f"{self.namespace}/{topic}", type_, callback)
        self.addCleanup(subscriber.unregister)

    def test_the_map_is_latched(self):
        _, node = self.mapped()
        first = self.listener()
        eventually(lambda: first.known() == node.map().known(), "the map has come")
        late = []
        self.closing_subscriber("map", OccupancyGrid, late.append)
        eventually(lambda: late and Grid(late[-1]).known() == node.map().known(), "a late joiner has the whole map")

    def test_services_agree(self):
        _, node = self.mapped()
        self.assertGreater(len(node.map().known()), 1000)
        self.assertEqual(node.map("dynamic_map").known(), node.map("static_map").known())

    def test_updates_carry_what_changed(self):
        robot, node = self.mapped()
        listener = self.listener()
        eventually(lambda: listener.known() == node.map().known(), "the first whole map has come")
        wholes, stamp = len(listener.wholes), LOOKS[-1]
        for distance in (0.5, 0.8, 1.1):  # a thing that moves within the known rectangle
            thing = Room(panels=[upright(distance + 0.05, -0.3, 0.3)])
            for _ in range(6):
                stamp += 0.1
                robot.look(thing, stamp)
            eventually(lambda: listener.at(distance + 0.05, 0.05) > OCCUPIED, "the thing is seen where it is")
        node.wait_for("scans", used=robot.sent["scan"])
        eventually(lambda: listener.known() == node.map().known(), "all updates have come")
        self.assertEqual(len(listener.wholes), wholes, "changes within the rectangle need no whole map")
        whole = listener.wholes[-1].info
        for update in listener.updates:
            self.assertEqual(len(update.data), update.width * update.height)
            self.assertTrue(0 <= update.x and update.x + update.width <= whole.width)
            self.assertTrue(0 <= update.y and update.y + update.height <= whole.height)
            self.assertEqual(update.header.frame_id, "map")
        self.assertTrue(any(u.width < whole.width or u.height < whole.height for u in listener.updates))

    def test_whoever_listens_to_updates_later_misses_none(self):
        robot, node = self.mapped()
        wholes = []
        self.closing_subscriber("map", OccupancyGrid, wholes.append)
        eventually(lambda: wholes and Grid(wholes[-1]).known() == node.map().known(), "the first map has come")
        thing = Room(panels=[upright(1.05, -0.3, 0.3)])
        robot.look_around(thing, [1001.0 + 0.1 * i for i in range(8)])
        node.wait_for("scans", used=robot.sent["scan"])  # its updates went out, and nobody heard them
        node.wait_for("echoes", used=robot.sent["sonar"])
        listener = self.listener()
        eventually(lambda: listener.known() == node.map().known(), "the late listener has the map as it is")

    def test_the_map_grows_with_what_is_seen(self):
        robot, node = self.mapped()
        listener = self.listener()
        eventually(lambda: listener.known() == node.map().known(), "the first map has come")
        first = listener.wholes[-1].info
        robot.look_around(Room(half_side=8.05), [1010.0 + 0.1 * i for i in range(4)])
        eventually(lambda: listener.at(8.05, 0.05) > OCCUPIED, "the far wall is seen")
        self.assertGreater(listener.wholes[-1].info.width, first.width)
        node.wait_for("scans", used=robot.sent["scan"])
        node.wait_for("echoes", used=robot.sent["sonar"])
        eventually(lambda: listener.known() == node.map().known(), "the large map is whole")

    def test_what_any_sensor_sees_stands(self):
        glass = upright(1.05, -0.45, 0.45, seen_by=(SONAR,))
        curtain = upright(-1.05, -0.45, 0.45, seen_by=(LASER,))
        _, node = self.mapped(Room(panels=[glass, curtain]))
        fused, laser, sonar = (self.listener(topic) for topic in ("map", "map/laser", "map/sonar"))
        eventually(lambda: all(g.known() for g in (fused, laser, sonar)), "the maps have come")
        eventually(lambda: fused.known() == node.map().known(), "the fused map is whole")
        self.assertLess(laser.at(1.05, 0.05), FREE, "the laser sees through glass")
        self.assertGreater(sonar.at(1.05, 0.05), OCCUPIED, "sonar sees glass")
        self.assertGreater(fused.at(1.05, 0.05), OCCUPIED, "glass stands in the fused map")
        self.assertLess(sonar.at(-1.05, 0.05), FREE, "sonar hears through a curtain")
        self.assertGreater(laser.at(-1.05, 0.05), OCCUPIED, "the laser sees a curtain")
        self.assertGreater(fused.at(-1.05, 0.05), OCCUPIED, "a curtain stands in the fused map")

    def test_clouds_are_cut_into_a_slice(self):
        robot, node = self.pair()
        wall = [(1.55, -0.5 + 0.05 * i, z) for i in range(21) for z in (0.5, 1.0)]
        lamp = [(0.75, 0.05, 2.5)]
        for stamp in LOOKS:
            robot.stand(stamp, (0.0, 0.0, 0.0))
            robot.send("cloud_in", messages.cloud(stamp, "camera", wall + lamp))
        node.wait_for("clouds", used=len(LOOKS))
        layer = self.listener("map/cloud")
        eventually(lambda: layer.at(1.55, 0.05) > OCCUPIED, "the cloud's layer shows the wall")
        self.assertTrue(0 <= layer.at(0.75, 0.05) < FREE, "what hangs above the slice does not stand")

    def test_reset_forgets(self):
        robot, node = self.mapped()
        listener = self.listener()
        eventually(lambda: listener.known() == node.map().known(), "the map has come")
        self.assertTrue(node.call("reset").success)
        eventually(lambda: not listener.known(), "the listener forgets")
        robot.look_around(Room(half_side=1.55), [1020.0 + 0.1 * i for i in range(4)])
        eventually(lambda: listener.at(1.55, 0.05) > OCCUPIED, "the new walls are seen")
        self.assertEqual(listener.at(2.05, 0.05), -1)


if __name__ == "__main__":
    case.run("grid_maps", GridMaps)
