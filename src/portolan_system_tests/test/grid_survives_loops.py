#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time runs back, as when a bag loops or a simulator starts anew: the grid node goes on."""
import subprocess

import rospy
from rosgraph_msgs.msg import Clock

from portolan_testing import bags, case, messages
from portolan_testing.room import Room
from portolan_testing.waiting import eventually

OCCUPIED = 65
FIRST, SECOND = Room(half_side=2.05), Room(half_side=3.05)
FIRST_STAMPS = [100.0 + 0.1 * i for i in range(4)]
SECOND_STAMPS = [50.0 + 0.1 * i for i in range(4)]


class GridSurvivesLoops(case.NodeCase):
    def see(self, robot, node, room, stamps):
        """The robot looks around while the clock runs beside it."""
        robot.tick(stamps[0])
        before = {noun: node.tally(noun).used for noun in ("scans", "echoes")}
        sent = dict(robot.sent)
        for stamp in stamps:
            robot.tick(stamp)
            robot.look(room, stamp)
        for noun, topic in (("scans", "scan"), ("echoes", "sonar")):
            node.wait_for(noun, used=before[noun] + robot.sent[topic] - sent.get(topic, 0), waiting=0)

    def run_back(self, robot, node):
        robot.tick(SECOND_STAMPS[0] - 1.0)
        eventually(lambda: node.values().get("times the clock ran back") == "1", "the node notices")

    def files_of_one_run(self, *views):
        """What a node saves that sees these (room, stamps) while time only runs on."""
        namespace = self.new_namespace()
        robot, node = self.pair(namespace)
        for room, stamps in views:
            self.see(robot, node, room, stamps)
        return self.saved(node)

    def test_reset_starts_the_map_anew(self):
        robot, node = self.pair()
        listener = self.listener()
        self.see(robot, node, FIRST, FIRST_STAMPS)
        eventually(lambda: listener.at(2.05, 0.05) > OCCUPIED, "the first room is mapped")
        self.run_back(robot, node)
        eventually(lambda: not listener.known(), "the map is empty")
        self.see(robot, node, SECOND, SECOND_STAMPS)
        eventually(lambda: listener.at(3.05, 0.05) > OCCUPIED, "the second room is mapped")
        self.assertEqual(self.saved(node), self.files_of_one_run((SECOND, SECOND_STAMPS)))

    def test_keep_goes_on_with_the_map(self):
        robot, node = self.pair(parameters={"on_time_jump": "keep"})
        self.see(robot, node, FIRST, FIRST_STAMPS)
        before = node.map().known()
        self.run_back(robot, node)
        self.assertEqual(node.map().known(), before)
        self.see(robot, node, SECOND, SECOND_STAMPS)
        later = [stamp + 60.0 for stamp in SECOND_STAMPS]
        self.assertEqual(self.saved(node), self.files_of_one_run((FIRST, FIRST_STAMPS), (SECOND, later)))

    def test_what_is_kept_no_longer_bends(self):
        robot, node = self.pair(parameters={"on_time_jump": "keep"})
        self.see(robot, node, FIRST, FIRST_STAMPS)
        self.run_back(robot, node)
        kept = node.map().known()
        robot.send("drift_correction", messages.correction([(50.0, (7.0, 0.0, 0.0))]))
        self.see(robot, node, Room(half_side=1.05), SECOND_STAMPS)
        eventually(lambda: node.map().at(8.05, 0.05) > OCCUPIED, "what is new stands where the correction says")
        self.assertTrue(kept <= node.map().known(), "what was kept stands where it stood")

    def test_a_second_loop_is_like_the_first(self):
        robot, node = self.pair()
        self.see(robot, node, FIRST, FIRST_STAMPS)
        first = self.saved(node)
        for loop in range(1, 4):
            robot.tick(FIRST_STAMPS[0] - 1.0)
            eventually(lambda: node.values().get("times the clock ran back") == str(loop), "the node notices")
            self.see(robot, node, FIRST, FIRST_STAMPS)
            self.assertEqual(self.saved(node), first)

    def test_a_step_of_the_clock_by_little_is_no_loop(self):
        robot, node = self.pair()
        self.see(robot, node, FIRST, FIRST_STAMPS)
        robot.tick(FIRST_STAMPS[-1] - 0.05)
        robot.look(FIRST, FIRST_STAMPS[-1] + 0.1)
        node.wait_for("scans", used=robot.sent["scan"])
        self.assertEqual(node.values()["times the clock ran back"], "0")

    def test_what_waits_for_tf_when_time_runs_back_is_dropped(self):
        robot, node = self.pair()
        self.see(robot, node, FIRST, FIRST_STAMPS)
        robot.send("scan", messages.scan(FIRST_STAMPS[-1] + 5.0, "laser", FIRST.scan((0.0, 0.0, 0.0))))
        node.wait_for("scans", waiting=1)
        self.run_back(robot, node)
        node.wait_for("scans", waiting=0, time_ran_back=1)

    def test_stamps_run_back_and_the_clock_does_not(self):
        robot, node = self.pair(parameters={"tf_buffer": 10.0})
        listener = self.listener()
        robot.tick(200.0)
        robot.look_around(FIRST, FIRST_STAMPS)
        node.wait_for("scans", used=robot.sent["scan"])
        node.wait_for("echoes", used=robot.sent["sonar"])
        for i in range(20):  # the robot drives on before it looks, so that its tf is believed
            robot.stand(SECOND_STAMPS[0] - 2.0 + 0.1 * i, (0.0, 0.0, 0.0))
        eventually(lambda: node.values().get("times the clock ran back") == "1", "the node notices")
        robot.look_around(SECOND, SECOND_STAMPS)
        node.wait_for("scans", used=robot.sent["scan"])
        eventually(lambda: listener.at(3.05, 0.05) > OCCUPIED, "the second room is mapped")
        self.assertEqual(self.saved(node), self.files_of_one_run((SECOND, SECOND_STAMPS)))

    def test_a_bag_that_loops(self):
        bag = bags.write_room_bag(self.folder / "room.bag", looks=15)
        node = self.node()
        listener = self.listener()
        clock = []
        subscriber = rospy.Subscriber(f"{self.namespace}/clock", Clock, clock.append)
        self.addCleanup(subscriber.unregister)
        player = subprocess.Popen(bags.play_command(bag, self.namespace, rate=3) + ["--loop"],
                                  stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        self.addCleanup(player.wait)
        self.addCleanup(player.terminate)
        eventually(lambda: int(node.values().get("times the clock ran back", 0)) >= 3, "the bag has looped")
        looped = node.tally("scans").used
        eventually(lambda: node.tally("scans").used > looped + 20, "the node maps on")
        eventually(lambda: listener.at(2.05, 0.05) > OCCUPIED, "and shows the room")
        self.assertTrue(clock)


if __name__ == "__main__":
    case.run("grid_survives_loops", GridSurvivesLoops)
