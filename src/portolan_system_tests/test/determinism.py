#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The same messages give the same bytes: over a bag on one core or on all, and live at any rate, for every node."""
import os
import re
import subprocess

import rosbag
import yaml

from portolan_testing import bags, case, matrix, messages, subjects
from portolan_testing.grid import files_of
from portolan_testing.node import executable
from portolan_testing.robot import mounts
from portolan_testing.stand import PARTS, Part
from portolan_testing.subjects import SUBJECTS

ROUND = subjects.SUBJECTS["occupancy_grid"]._replace(look=subjects.sees(
    subjects.scan, subjects.echo, subjects.cloud, subjects.sightings, subjects.ranges))
# Which of two topics comes first is not the same in each run, unless they wait for each other, here for slow machines.
IN_ORDER = {"tf_wait": 30.0, "order_wait": 1.0}
RATES = (1.0, 4.0)


class Determinism(case.NodeCase):
    def setUp(self):
        super().setUp()
        self.bag = self.folder / "round.bag"
        self.looks = {}
        with rosbag.Bag(str(self.bag), "w") as bag:
            for stamp in (999.0, 1000.0 + 1.5 * len(PARTS) + 2.0):  # nothing waits for order after that
                bag.write("/tf_static", mounts(), messages.time(stamp))
            for name in PARTS:
                part = Part(ROUND, name, 1000.0 + 1.5 * PARTS.index(name), tail=1)
                for topic, message in part.looks:
                    bag.write("/" + topic, message, message.header.stamp)
                    self.looks[topic] = self.looks.get(topic, 0) + 1
                for topic, message in part.poses:
                    bag.write("/" + topic, message, message.transforms[0].header.stamp)

    def parameters(self, program):
        return {**SUBJECTS[program].parameters, **IN_ORDER}

    def offline(self, mappers, name, cores=None):
        """The files that bag_to_map leaves; it may use only these cores."""
        config = self.folder / "config.yaml"
        config.write_text(yaml.safe_dump({mapper: self.parameters(mapper) for mapper in mappers}))
        done = subprocess.run(
            [executable("bag_to_map"), "--mappers", ",".join(mappers), "--config", str(config), "--out",
             str(self.folder / name), str(self.bag)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            universal_newlines=True, check=False, preexec_fn=lambda: cores and os.sched_setaffinity(0, cores))
        self.assertEqual(done.returncode, 0, done.stderr)
        files = files_of(self.folder / name, "")
        files["summary.yaml"] = re.sub(rb"wall_time: \S+", b"", files["summary.yaml"])
        return files

    def test_a_bag_on_one_core_and_on_all(self):
        all_cores = os.sched_getaffinity(0)
        first = self.offline(matrix.NODES, "first", {min(all_cores)})
        self.assertEqual(first, self.offline(matrix.NODES, "second", all_cores))
        for program in matrix.NODES:
            self.assertTrue(any(name.startswith(SUBJECTS[program].files) for name in first), program)

    def live(self, rate):
        """The files that all nodes save after the bag has been played at this rate."""
        namespace = self.new_namespace()
        nodes = {program: self.node(namespace, program=program, parameters=self.parameters(program),
                                    remap={"drift_correction": f"what_{program}_hears"}) for program in matrix.NODES}
        subprocess.run(bags.play_command(self.bag, namespace, rate), stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, check=True)
        for program, node in nodes.items():
            for topic, noun in SUBJECTS[program].nouns.items():
                if topic in self.looks:
                    node.wait_for(noun, received=self.looks[topic], waiting=0)
            self.assertTrue(node.call("save").success)
        return files_of(self.folder / namespace[1:], "")

    def test_live_at_different_rates(self):
        maps = [program for program in matrix.NODES if program != "pose_graph"]  # which would bend them
        offline = {**self.offline(maps, "maps"), **self.offline(["pose_graph"], "graph")}
        for rate in RATES:
            live = self.live(rate)
            self.assertGreater(len(live), 10)
            for name, content in live.items():
                if name != "pose_graph.tum":  # over a bag the trajectory is that of all odometry
                    self.assertEqual(content, offline[name], f"{name} at {rate}")


if __name__ == "__main__":
    case.run("determinism", Determinism)
