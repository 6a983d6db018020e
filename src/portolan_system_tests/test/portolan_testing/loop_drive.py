# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot whose odometry turns too much, on its way round the block and half way round again."""
import yaml

from portolan_testing.block import CORNER, block
from portolan_testing.room import RESOLUTION

BEGIN = 10.0         # stamp of the drive's first moment [s]
SENSOR_HEIGHT = 0.5  # [m]
SENSORS = ("lasers", "lidars", "landmark_sensors", "beacon_receivers")
LANDMARKS = {1: (0.0, -6.0), 2: (3.5, -4.13), 3: (5.97, -2.0), 4: (4.13, -1.0), 5: (5.97, 4.5), 6: (0.0, 5.97),
             7: (-3.0, 4.13), 8: (-5.97, 3.0), 9: (-4.13, 0.0), 10: (-5.97, -4.0), 11: (-1.5, -4.13)}
BEACONS = {1: (-5.5, -5.9), 2: (5.9, -4.0), 3: (3.0, 5.9), 4: (-5.9, 2.0)}

# Matches of neighbours are left out, so that all drift is left to the loops.
QUEUE = {"tf_wait": 30.0, "queue_size": 5000}
MAPPERS = {
    "occupancy_grid": {**QUEUE, "resolution": RESOLUTION, "cloud_in_topics": []},
    "octomap": {**QUEUE, "resolution": RESOLUTION, "scan_topics": [], "sensor_model": {"max_range": 8.0}},
    "landmarks": QUEUE,
    "beacons": QUEUE,
    "pose_graph": {**QUEUE, "scans": {"enabled": False}, "settle_after": 0.5},
}


def world():
    walls = [{"points": [list(a), list(b)], "thickness": 0.05, "height": 1.5} for a, b, _ in block().segments]
    marks = {name: [{"id": i, "position": [x, y, SENSOR_HEIGHT]} for i, (x, y) in places.items()]
             for name, places in (("landmarks", LANDMARKS), ("beacons", BEACONS))}
    c = CORNER
    tour = [[0.0, -c], [c, -c], [c, c], [-c, c], [-c, -c], [c, -c], [c, c], [2.0, c]]
    return {"walls": walls, "tour": tour, **marks}


def robot():
    at = {"position": [0.0, 0.0, SENSOR_HEIGHT]}
    return {
        "seed": 1, "start_time": BEGIN, "odometry": {"turn_per_metre": 0.006}, "odometry_rate": 20.0,
        "robot": {"max_speed": 1.5, "max_turn_rate": 2.0}, "follower": {"speed": 1.2, "turn_rate": 1.5},
        "lasers": [{"frame": "laser", "topic": "scan", "rate": 5, **at}], "sonar_rings": [],
        "lidars": [{"frame": "lidar", "topic": "cloud_in", "rate": 1, "rings": 4, "columns": 180, "lowest": -0.1,
                    "highest": 0.1, **at}],
        "landmark_sensors": [{"frame": "landmark_sensor", "topic": "landmark_sightings", "rate": 2, **at}],
        "beacon_receivers": [{"frame": "antenna", "topic": "beacon_ranges", "rate": 2, "range_stddev": 0.1, **at}],
    }


def write_files(folder, sensors=None):
    """world.yaml, and robot.yaml with how it maps, some of its sensors or all; gives both paths."""
    built = robot()
    for name in SENSORS if sensors else ():
        built[name] = built[name] if name in sensors else []
    (folder / "world.yaml").write_text(yaml.safe_dump(world()))
    (folder / "robot.yaml").write_text(yaml.safe_dump({"robot_sim": built, **MAPPERS}))
    return folder / "world.yaml", folder / "robot.yaml"
