#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The fault matrix: one test for each node and fault. Argument: the node."""
import pathlib
import resource
import shutil
import sys
import tempfile
import threading

import rospy
from nav_msgs.srv import GetMap
from octomap_msgs.srv import GetOctomap
from portolan_msgs.srv import ListArcs

from portolan_testing import case, matrix
from portolan_testing.grid import files_of
from portolan_testing.node import Node
from portolan_testing.stand import STEPS, Stand

QUERIES = {"occupancy_grid": [("dynamic_map", GetMap), ("static_map", GetMap)],
           "octomap": [("octomap_binary", GetOctomap), ("octomap_full", GetOctomap)],
           "pose_graph": [("pose_graph/list_arcs", ListArcs)]}
NOT_READ = (".tum", ".bt")  # files that are for others: a map is loaded from those beside them


def paths(parameters, before=""):
    """The names of nested parameters."""
    for name, value in parameters.items():
        if isinstance(value, dict) and value:
            yield from paths(value, before + name + "/")
        else:
            yield before + name


class Faults(case.NodeCase):
    program = None  # of each class that is made of this one

    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(tempfile.mkdtemp())
        cls.maps, cls.elsewhere = cls.place / "maps", cls.place / "elsewhere"
        cls.elsewhere.mkdir()
        cls.maps.symlink_to(cls.elsewhere)
        cls.stand = Stand(cls.program, cls.maps, f"/faults/{cls.program}")

    @classmethod
    def tearDownClass(cls):
        cls.stand.close()
        shutil.rmtree(cls.place)

    def setUp(self):
        super().setUp()
        node = self.stand.node.process
        self.assertIsNone(node.poll(), "the node lives")
        self.assertTrue(self.stand.node.call("reset").success)

    def stream(self, fault):
        """A round with the fault: what is lost is counted, and the map is as if that had never been sent."""
        stand, nouns = self.stand, self.stand.subject.nouns.values()
        shows, fates = matrix.expected(self.program, fault, nouns)
        reference = stand.map_of(*shows) if shows else None
        stand.node.call("reset")
        sent = stand.play(fault, posed="no_transform" not in fates.values(), poses_first="any" in fates.values(),
                          by="odometry" if fault.endswith("covariance") else "poses")
        for noun in nouns:
            received, _, waiting, dropped = stand.since(noun)
            self.assertEqual((received, waiting), (sent[noun], 0), noun)
            if fates[noun] != "any":
                dropped.pop("thinned", None)
                self.assertEqual(dropped, {fates[noun]: STEPS} if fates[noun] else {}, noun)
        if reference:
            self.assertEqual(stand.saved(), reference)
        else:
            self.maps_on()

    def maps_on(self):
        reference = self.stand.map_of(*matrix.WHOLE)
        self.stand.node.call("reset")
        self.stand.play()
        self.assertEqual(self.stand.saved(), reference, "a further round is mapped as always")

    def refused(self, *names, **parameters):
        """The node does not start with these parameters, and names all of them."""
        node = self.closing(Node(self.namespace, self.program, parameters=parameters, until_ready=False))
        self.assertGreater(node.exit_code(), 0)
        self.assert_in_words([*paths(parameters), *names], node.errors())

    def parameter_of_wrong_type(self):
        self.refused(tf_wait="long", publish_interval=[1.0], **self.stand.subject.wrong_type)

    def parameter_out_of_range(self):
        self.refused(queue_size=0, publish_interval=float("nan"), **self.stand.subject.out_of_range)

    def parameter_misspelt(self):
        self.refused("tf_wiat", tf_wiat=1.0)

    def assert_refused(self, service, *words):
        answer = self.stand.node.call(service)
        self.assertFalse(answer.success, answer.message)
        self.assert_in_words(words, answer.message)

    def service_before_data(self):
        reference = self.stand.map_of(*matrix.WHOLE)
        for path in self.maps.iterdir():
            path.unlink()
        self.stand.start_node()
        self.assert_refused("save", "nothing has been observed")
        self.assert_refused("load", str(self.maps))
        self.assertEqual(list(self.maps.iterdir()), [])
        self.assertTrue(self.stand.node.call("reset").success)
        for name, type_ in QUERIES.get(self.program, []):
            rospy.ServiceProxy(f"{self.stand.namespace}/{name}", type_)()
        self.stand.play()
        self.assertEqual(self.stand.saved(), reference)

    def cannot_save(self, break_, mend):
        """What was saved stays, and so does the map, while saving is broken."""
        before = self.stand.map_of(*matrix.GAP)
        after = self.stand.map_of(*matrix.WHOLE)
        self.stand.node.call("reset")
        self.stand.play(looks="AC")
        self.assertEqual(self.stand.saved(), before)
        kept = files_of(self.elsewhere, "")
        self.stand.node.call("reset")
        self.stand.play()
        break_()
        self.assert_refused("save", str(self.maps))
        mend()
        self.assertEqual(files_of(self.elsewhere, ""), kept, "the old files, and no others")
        self.assertEqual(self.stand.saved(), after)

    def full_disk(self):
        process, most = self.stand.node.process.pid, resource.RLIM_INFINITY
        limit = lambda bytes_: resource.prlimit(process, resource.RLIMIT_FSIZE, (bytes_, most))
        self.cannot_save(lambda: limit(64), lambda: limit(most))

    def point_to(self, folder):
        self.maps.unlink()
        self.maps.symlink_to(folder)

    def read_only_folder(self):
        # In /proc not even root can write.
        self.cannot_save(lambda: self.point_to("/proc"), lambda: self.point_to(self.elsewhere))

    def corrupt_file_on_load(self):
        self.stand.play()
        before = self.stand.saved()
        for path in sorted(self.maps.iterdir()):
            if path.suffix in NOT_READ:
                continue
            good = path.read_bytes()
            for bad in (b"", good[:len(good) // 2], bytes(len(good)), b"no map at all, but words\n"):
                with self.subTest(path.name, bad=bad[:20]):
                    path.write_bytes(bad)
                    self.assert_refused("load", path.stem + ".")
            path.write_bytes(good)
        self.assertEqual(self.stand.saved(), before, "the map is as it was")

    def kill_9_in_save(self):
        whole = {}
        for parts in ("ABC", "C"):
            self.stand.node.call("reset")
            self.stand.play(parts=parts)
            self.stand.saved()
            self.assertTrue(self.stand.node.call("load").success)
            self.stand.saved()  # again: of a pose graph the last bits are those that its file can hold
            whole[parts] = files_of(self.elsewhere, "")
        self.assertNotEqual(*whole.values())
        interrupted = 0
        for attempt in range(12):
            stage = (".portolan_new", ".portolan_commit")[attempt % 2]
            interrupted += self.save_and_kill(stage, whole["ABC"], whole["C"])
            answer = self.stand.node.call("load")
            self.assertTrue(answer.success, answer.message)
            self.assertIn(self.visible(), whole.values(), "the files belong to one save")
            if interrupted == 4:
                break
        self.assertGreater(interrupted, 0)

    def save_and_kill(self, stage, old, new):
        """Kills a node when it saves `new` over `old` and this stage is reached; true where no answer came."""
        self.put(new)
        node = self.node(self.new_namespace(), program=self.program, parameters={
            **self.stand.subject.parameters, "map_directory": str(self.maps)})
        self.assertTrue(node.call("load").success)
        self.put(old)
        is_over = threading.Event()

        def kill_at_stage():
            while not is_over.is_set():
                if any(path.name.startswith(stage) for path in self.elsewhere.iterdir()):
                    return node.kill()
        killer = threading.Thread(target=kill_at_stage)
        killer.start()
        try:
            node.call("save")
            return False
        except (rospy.ServiceException, rospy.ROSException):
            return True
        finally:
            is_over.set()
            killer.join()
            node.close()

    def visible(self):
        """The files, without what an interrupted save leaves beside them."""
        return {name: content for name, content in files_of(self.elsewhere, "").items() if name[0] != "."}

    def put(self, files):
        for path in self.elsewhere.iterdir():
            path.unlink()
        for name, content in files.items():
            (self.elsewhere / name).write_bytes(content)

    def node_restart(self):
        reference = self.stand.map_of("C")
        self.stand.play(parts="AB")
        self.stand.start_node()
        self.stand.play(parts="C")
        self.assertEqual(self.stand.saved(), reference)


def cases_of(program):
    """A class with one test for each row of the matrix."""
    cells = {f"test_{program}_{fault}": lambda self, fault=fault: self.stream(fault) for fault in matrix.STREAM}
    cells.update({f"test_{program}_{fault}": getattr(Faults, fault) for fault in matrix.OTHER
                  if hasattr(Faults, fault)})
    return type(program, (Faults,), {"program": program, **cells})


if __name__ == "__main__":
    NODE = next(argument for argument in sys.argv[1:] if argument in matrix.NODES)
    case.run("faults_" + NODE, cases_of(NODE))
