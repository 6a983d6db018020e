# SPDX-License-Identifier: BSD-3-Clause
"""Test cases that start nodes: each test has a namespace and a folder of its own."""
import itertools
import pathlib
import sys
import tempfile
import unittest

import rospy
import rostest

from portolan_testing.grid import GridListener, files_of
from portolan_testing.node import Node
from portolan_testing.robot import Robot, heard_by


class NodeCase(unittest.TestCase):
    """Starts nodes, robots and listeners, and ends them all after the test."""

    files = "map"  # what the names of saved files begin with

    _numbers = itertools.count(1)

    def setUp(self):
        self.namespace = self.new_namespace()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def new_namespace(self):
        return f"/case_{next(NodeCase._numbers)}"

    def closing(self, thing):
        self.addCleanup(thing.close)
        return thing

    def node(self, namespace=None, **more):
        """A running node that saves into the test's folder, in a subfolder named after its namespace."""
        namespace = namespace or self.namespace
        parameters = {"map_directory": str(self.folder / namespace[1:]), **more.pop("parameters", {})}
        return self.closing(Node(namespace, parameters=parameters, **more))

    def robot(self, namespace=None, **more):
        return self.closing(Robot(namespace or self.namespace, **more))

    def pair(self, namespace=None, program="occupancy_grid", **more):
        """A node, and a robot that it hears."""
        namespace = namespace or self.namespace
        robot, node = self.robot(namespace), self.node(namespace, program=program, **more)
        robot.wait_until_heard(heard_by(program))
        return robot, node

    def listener(self, topic="map", namespace=None):
        return self.closing(GridListener(f"{namespace or self.namespace}/{topic}"))

    def saved(self, node):
        """The files that a save leaves, by name."""
        answer = node.call("save")
        self.assertTrue(answer.success, answer.message)
        return files_of(self.folder / node.namespace[1:], self.files)

    def assert_in_words(self, words, text):
        """All of these words stand in the text."""
        for word in words:
            self.assertIn(word, text)


def run(name, case):
    """The main of each test: `name` is that of its file."""
    rospy.init_node(name)
    rostest.rosrun("portolan_system_tests", name, case, sys.argv)
