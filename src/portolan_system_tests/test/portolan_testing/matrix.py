# SPDX-License-Identifier: BSD-3-Clause
"""The rows and columns of the fault matrix: what goes wrong, and what every node has to do then."""
NODES = ("occupancy_grid", "octomap", "landmarks", "beacons", "pose_graph")

# What a map equals after a round in whose middle third there was a fault: the map of a round without fault; of one in
# which the sensors were silent in that third; of its later two thirds.
WHOLE, GAP, LATER = ("ABC", "ABC"), ("ABC", "AC"), ("BC", "ABC")

# Faults of streams. Name: (what is wrong, that map or None, what becomes of the messages, the same in words).
STREAM = {
    "clock_back": ("The clock, tf and all stamps jump back by 100 s", LATER, None,
                   "starts anew, and shows what came after the jump"),
    "clock_forward_by_a_day": ("The clock, tf and all stamps jump ahead by a day", WHOLE, None, "loses nothing"),
    "repeated_stamps": ("Every message comes twice", WHOLE, "repeated_stamp", "takes it once, and counts the other"),
    "decreasing_stamps": ("Every second message comes before the one that it follows", None, "any",
                          "takes it, or counts it as rejected; maps on"),
    "tf_late": ("tf comes half a second late", WHOLE, None, "waits, and loses nothing"),
    "tf_absent": ("There is no tf", GAP, "no_transform", "waits for a second, then counts it; guesses no pose"),
    "tf_loop": ("tf says that odom is a child of base_link too, and has a loop elsewhere", WHOLE, None,
                "loses nothing"),
    "nan_storm": ("All measurements are NaN", GAP, "malformed", "they say nothing"),
    "infinities": ("All measurements are plus or minus infinity", GAP, "malformed", "they say nothing"),
    "empty_messages": ("Messages have nothing but a header", GAP, "malformed", "counts them"),
    "malformed_sizes": ("Sizes contradict each other; messages end half-way on the wire", GAP, "malformed",
                        "counts them, as far as ROS can read them"),
    "coordinates_of_1e30": ("All measurements are 10^30", GAP, None, "they say nothing"),
    "poses_of_1e30": ("tf says that the robot is 10^30 m away", GAP, "no_transform", "refuses such a transform"),
    "unknown_frames": ("Messages name a frame that tf does not know, or none", GAP, "no_transform",
                       "counts them, and says which frame"),
    "zero_covariance": ("Standard deviations of sensors, and odometry's covariance, are 0", None, None,
                        "takes 0 as unknown: its own sensor model serves"),
    "negative_covariance": ("They are negative", GAP, "malformed", "counts them; odometry's is not read"),
    "nan_covariance": ("They are NaN", GAP, "malformed", "counts them; odometry's is not read"),
    "non_unit_quaternion": ("Quaternions of tf are twice too long, or zero", GAP, "no_transform",
                            "refuses such a transform"),
    "rate_ten_times_too_high": ("Messages come ten times as often", None, "any",
                                "uses or counts each; maps on, and its services answer"),
}

SILENT = dict.fromkeys(("scans", "echoes", "clouds"))  # fates of messages that are used and say nothing
ODOMETRY_ONLY = (WHOLE, SILENT, "its sensors state none; odometry's is not read")
NO_LIST = (None, {"rangings": None}, "took part: it listened and heard nothing")
CUT_ONLY = "has no messages with sizes of their own; what ROS cannot read does not reach it"

# Where a node differs: the map, what becomes of messages of these inputs, and why.
DIFFERS = {
    ("occupancy_grid", "nan_storm"): (GAP, {**SILENT, "clouds": "unusable"}, "counts such clouds as unusable"),
    ("occupancy_grid", "infinities"): (GAP, {**SILENT, "clouds": "unusable"}, "counts such clouds as unusable"),
    ("octomap", "nan_storm"): (GAP, SILENT, "counts the points"),
    ("octomap", "infinities"): (GAP, SILENT, "counts the points"),
    ("landmarks", "empty_messages"): (None, {"sightings": None, "images": None},
                                      "took part: it looked and saw nothing"),
    ("landmarks", "malformed_sizes"): (GAP, {"sightings": None, "images": None, "calibrations": None}, CUT_ONLY),
    ("landmarks", "negative_covariance"): (None, {"images": None, "calibrations": None}, "images have none"),
    ("landmarks", "nan_covariance"): (None, {"images": None, "calibrations": None}, "images have none"),
    ("landmarks", "coordinates_of_1e30"): (GAP, {noun: "malformed" for noun in ("sightings", "images", "calibrations")},
                                           "counts them as malformed"),
    ("beacons", "empty_messages"): NO_LIST,
    ("beacons", "malformed_sizes"): (GAP, {"rangings": None}, CUT_ONLY),
    ("beacons", "coordinates_of_1e30"): (GAP, {"rangings": "rejected"}, "counts them as too long"),
    ("pose_graph", "clock_forward_by_a_day"): (None, {"scans": None}, "loses nothing, but believes odometry more: in a "
                                               "day's time the robot may have gone as slowly as that"),
    **{("pose_graph", fault): (None, {"scans": None}, "goes on by odometry, as where there are no walls")
       for fault in ("nan_storm", "infinities", "coordinates_of_1e30")},
    **{(node, fault): ODOMETRY_ONLY for node in ("occupancy_grid", "octomap", "pose_graph")
       for fault in ("zero_covariance", "negative_covariance", "nan_covariance")},
}
NEED_NO_POSE = ("calibrations",)


def expected(node, fault, nouns):
    """The map, and what becomes of the broken messages of each input of this node."""
    _, shows, fate, _ = STREAM[fault]
    of_messages = fate in (None, "malformed", "any")
    fates = {noun: fate if of_messages or noun not in NEED_NO_POSE else None for noun in nouns}
    if (node, fault) in DIFFERS:
        shows, others, _ = DIFFERS[node, fault]
        fates.update({noun: others[noun] for noun in nouns if noun in others})
    return shows, fates


# Faults of users, files and processes. Name: (what is wrong, what every node does).
OTHER = {
    "parameter_of_wrong_type": ("A parameter has a wrong type", "does not start, and names all such"),
    "parameter_out_of_range": ("A parameter is out of its range", "does not start, and names all such"),
    "parameter_misspelt": ("A parameter is misspelt", "does not start, and names it"),
    "service_before_data": ("Services are called before there are data", "answers each; then maps as always"),
    "full_disk": ("The disk is full when it saves", "says so; old files and map stay as they are"),
    "read_only_folder": ("The folder is read-only when it saves", "says so; old files and map stay as they are"),
    "kill_9_in_save": ("It is killed while it saves", "leaves the old files or the new ones, all of them whole"),
    "corrupt_file_on_load": ("A file is empty, cut, all zeros or no map at all when it loads",
                             "refuses it by name, and keeps its map"),
    "node_restart": ("It is ended and started anew in mid-run", "maps what comes then; hears latched topics again"),
    "roscore_restart": ("roscore is ended and started anew",
                        "maps on with whom it heard before; ends when told to, and a new one is found again"),
}

ROWS = {**{name: (row[0], row[3]) for name, row in STREAM.items()}, **OTHER}
