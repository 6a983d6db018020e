#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The fault matrix: roscore is ended and started anew, once, while all nodes run under it."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile

import rosgraph

from portolan_testing import case, matrix
from portolan_testing.node import Node
from portolan_testing.robot import Robot, heard_by
from portolan_testing.stand import Part
from portolan_testing.subjects import SUBJECTS
from portolan_testing.waiting import eventually


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class Core:
    """A roscore of our own, which this process and its children take for theirs."""

    def __init__(self):
        self._port = free_port()
        os.environ["ROS_MASTER_URI"] = f"http://localhost:{self._port}"
        self.start()

    def start(self):
        self._process = subprocess.Popen([shutil.which("rosmaster"), "--core", "-p", str(self._port)],
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        master = rosgraph.Master("/faults_roscore")
        eventually(master.is_online, "the master answers")
        master.setParam("/use_sim_time", True)

    def restart(self):
        self.close()
        self.start()

    def close(self):
        self._process.kill()
        self._process.wait()


class Mapped:
    """A node, and the robot that it hears."""

    def __init__(self, program, folder):
        self.program, self.subject = program, SUBJECTS[program]
        self.namespace = f"/roscore/{program}"
        self._parameters = {**self.subject.parameters, "map_directory": str(folder), "tf_wait": 1.0}
        self.begin()

    def begin(self):
        self.robot = Robot(self.namespace)
        self.node = Node(self.namespace, self.program, parameters=self._parameters)
        self.robot.wait_until_heard(heard_by(self.program))

    def map_part(self, name, begin):
        """Sends a part of the round, all of which the node uses."""
        part = Part(self.subject, name, begin, tail=0)
        self.robot.tick(part.begin)
        before = self.received()
        for topic, message in part.looks + part.poses:
            self.robot.send(topic, message)
        eventually(lambda: self.received() == before + len(part.looks) and self.waiting() == 0,
                   lambda: f"all are used: {self.node.sentence()}")

    def goes_on_and_ends(self):
        """Maps a further part without a roscore that knows it, and ends when told to; gives what went wrong."""
        try:
            self.map_part("B", 1003.0)
            self.node.process.send_signal(signal.SIGINT)  # as roslaunch does
            assert self.node.exit_code() == 0, self.node.errors()
            return None
        except AssertionError as error:
            return error
        finally:
            self.close()

    def received(self):
        return sum(self.node.tally(noun).received for noun in self.subject.nouns.values())

    def waiting(self):
        return sum(self.node.tally(noun).waiting for noun in self.subject.nouns.values())

    def close(self):
        self.node.close()
        self.robot.close()


class Roscore(case.NodeCase):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp())
        cls.mapped = {program: Mapped(program, cls.place / program) for program in matrix.NODES}
        for mapped in cls.mapped.values():
            mapped.map_part("A", 1000.0)
        CORE.restart()
        cls.wrong = {program: mapped.goes_on_and_ends() for program, mapped in cls.mapped.items()}
        for mapped in cls.mapped.values():  # not before all have ended: they share a topic of diagnostics
            mapped.begin()

    @classmethod
    def tearDownClass(cls):
        for mapped in cls.mapped.values():
            mapped.close()
        shutil.rmtree(cls.place)

    def roscore_restart(self, program):
        self.assertIsNone(self.wrong[program])
        mapped = self.mapped[program]
        mapped.map_part("C", 1006.0)
        answer = mapped.node.call("save")
        self.assertTrue(answer.success, answer.message)


for NODE in matrix.NODES:
    setattr(Roscore, f"test_{NODE}_roscore_restart", lambda self, node=NODE: self.roscore_restart(node))

if __name__ == "__main__":
    CORE = Core()
    try:
        case.run("faults_roscore", Roscore)
    finally:
        CORE.close()
